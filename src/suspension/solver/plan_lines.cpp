// Explains the decisions of a plan in words for the user (chapter 12, section "One way for the
// data").
#include "suspension/solver/plan_lines.hpp"

#include <algorithm>
#include <string_view>

#include "scene/scene.hpp"
#include "scene/words.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/solver/fields.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

std::string number_of(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

PlanLine problem_line(const ComponentCounts& counts, const Scene& scene) {
  const std::size_t prescribed = counts.held + counts.inner;
  std::string decision = counts.outer > 0 ? "bounded" : "unbounded";
  decision += counts.free == 0                 ? " resistance problem"
              : prescribed + counts.outer == 0 ? " mobility problem"
                                               : " mixed problem";
  std::string reason = number_of(counts.free, "free body", "free bodies") + ", " +
                       number_of(counts.held, "held body", "held bodies") + ", " +
                       number_of(counts.inner, "inner wall", "inner walls") + ", " +
                       (counts.outer > 0 ? "one" : "no") + " enclosing wall";
  if (scene.viscosity != 1.0) reason += ", viscosity " + short_number(scene.viscosity);
  return {"problem", decision, reason};
}

PlanLine far_field_line(const ComponentCounts& counts, const Scene& scene) {
  if (counts.outer > 0) return {"far field", "none", "the fluid ends at the enclosing wall"};
  if (scene.gauge_length) {
    return {"far field", "Stokeslets of gauge length " + short_number(*scene.gauge_length),
            "flow.gauge_length is given"};
  }
  if (counts.held + counts.inner > 0) {
    return {
        "far field", "zero net force, free uniform velocity",
        "unbounded fluid with prescribed velocities and no flow.gauge_length (Stokes' paradox)"};
  }
  return {"far field", "decaying disturbance", "free bodies in unbounded fluid, no net force"};
}

PlanLine singularity_line(const ComponentCounts& counts, const Scene& scene) {
  if (counts.held + counts.inner > 0) {
    return {"singularities", "Stokeslets and rotlets in the density's functionals",
            "forces and torques of inner walls and held bodies are unknown"};
  }
  const bool loaded = std::ranges::any_of(
      scene.bodies, [](const Body& body) { return body.force != Complex{} || body.torque != 0.0; });
  if (loaded) return {"singularities", "given Stokeslets and rotlets", "loads on bodies"};
  return {"singularities", "none", "no loads, no inner walls, no held bodies"};
}

PlanLine near_correction_line(const Plan& plan, const Scene& scene) {
  const NearSingular scheme = scene.solver.near_singular;
  if (scheme == NearSingular::off) {
    return {"near correction", "no", "solver.near_singular = \"off\""};
  }
  if (!plan.near_correction) return {"near correction", "no", "a single component"};
  return {"near correction", "yes",
          std::string(scheme == NearSingular::interpolation ? "interpolation" : "Cauchy") +
              " scheme where the error of the trapezoid rule exceeds " +
              short_number(plan.near_tolerance)};
}

PlanLine preconditioner_line(const Plan& plan, const Scene& scene, bool only_circles) {
  const std::string decision =
      plan.preconditioner == PreconditionerKind::direct           ? "the whole system, factorised"
      : plan.preconditioner == PreconditionerKind::clusters       ? "clusters, from the right"
      : plan.preconditioner == PreconditionerKind::block_diagonal ? "block diagonal, from the right"
                                                                  : "none";
  if (scene.solver.coupling == Coupling::local) {
    return {"preconditioner", decision, "solver.coupling = \"local\""};
  }
  if (scene.solver.preconditioner != PreconditionerKind::automatic) {
    return {"preconditioner", decision, "solver.preconditioner"};
  }
  const std::string reason = only_circles
                                 ? "own blocks of circles have the eigenvalues -1 and -1/2 only"
                                 : "own blocks of slender and lobed shapes spread the spectrum";
  if (!plan.direct_at_tight_gaps && !plan.clusters_at_tight_gaps) {
    return {"preconditioner", decision, reason};
  }
  const char* small = plan.direct_at_tight_gaps ? ", small systems factorised" : "";
  const char* large = plan.clusters_at_tight_gaps ? ", large ones by clusters" : "";
  return {"preconditioner", decision + "; where gaps are tight" + small + large, reason};
}

PlanLine gmres_line(const Plan& plan, const SolverSettings& solver) {
  const std::string decision = "to " + short_number(plan.gmres_tolerance) + ", without restart";
  if (solver.gmres_tol) return {"GMRES", decision, "solver.gmres_tol"};
  const std::string reason = "solver.tolerance = " + short_number(solver.tolerance) + " / 100";
  const bool is_met = plan.gmres_tolerance <= 0.01 * solver.tolerance;
  return {"GMRES", decision, is_met ? reason : "limited by rounding: " + reason};
}

PlanLine fields_line(const FieldSettings& fields) {
  const FieldGrid grid = field_grid(fields);
  std::vector<std::string_view> names;
  for (const FieldQuantity quantity : fields.quantities) {
    names.push_back(scene_text::name_of(quantity, scene_text::field_quantities));
  }
  return {"fields", std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " points",
          joined(names) + " at every written time"};
}

PlanLine contact_line(const Scene& scene) {
  if (!scene.contact) return {"contact", "none", "no [contact]: an overlap stops the run"};
  return {"contact",
          "least gap " + short_number(scene.contact->minimum_separation) +
              (scene.contact->in_spacings ? " node spacings" : ""),
          "contact.minimum_separation, by space-time interference and complementarity"};
}

}  // namespace

std::vector<PlanLine> plan_lines(const Plan& plan, const Scene& scene) {
  const ComponentCounts counts = count_components(scene);
  std::vector<PlanLine> lines{problem_line(counts, scene), far_field_line(counts, scene),
                              singularity_line(counts, scene)};
  lines.push_back(plan.null_space_fix ? PlanLine{"N_0", "yes", "an enclosing wall has a null space"}
                                      : PlanLine{"N_0", "no", "no enclosing wall"});
  lines.push_back(near_correction_line(plan, scene));
  lines.push_back(preconditioner_line(plan, scene, counts.circles == counts.all()));
  if (scene.solver.coupling == Coupling::local) {
    lines.push_back({"coupling", "lagged: one sweep of block Jacobi a step after the first",
                     "solver.coupling; its error is reported, and not bounded"});
  }
  lines.push_back(gmres_line(plan, scene.solver));
  if (is_couette_cell(scene)) {
    lines.push_back({"rheology", "one solve without bodies", "a Couette cell's torque ratio"});
  }
  if (scene.output.fields) lines.push_back(fields_line(*scene.output.fields));
  lines.push_back(contact_line(scene));
  return lines;
}

}  // namespace stokesbook
