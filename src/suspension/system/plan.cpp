// Decides from the scene alone which parts of the solver are built and how accurate they are, and
// records each decision with its reason (chapter 12, section "One way for the data").
#include "suspension/system/plan.hpp"

#include <algorithm>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm_settings.hpp"
#include "scene/scene.hpp"
#include "scene/words.hpp"
#include "suspension/bodies/field_grid.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

std::string count(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

// Rounding error of a fast sum, relative to the sum.
constexpr double least_sum_tolerance = 1e-14;

// The numbers of components of each kind in a scene.
struct Census {
  std::size_t free = 0, held = 0, inner = 0, outer = 0, circles = 0, components = 0;
  bool loaded = false;
};

Census take_census(const Scene& scene) {
  Census census;
  const auto add = [&](const Shape& shape) {
    ++census.components;
    if (std::holds_alternative<Circle>(shape)) ++census.circles;
  };
  for (const Body& body : scene.bodies) {
    add(body.shape);
    ++(body.held ? census.held : census.free);
    census.loaded = census.loaded || body.force != Complex{} || body.torque != 0.0;
  }
  for (const Wall& wall : scene.walls) {
    add(wall.shape);
    ++(wall.role == WallRole::outer ? census.outer : census.inner);
  }
  return census;
}

Plan::Line problem_line(const Census& census, const Scene& scene) {
  const std::size_t prescribed = census.held + census.inner;
  std::string decision = census.outer > 0 ? "bounded" : "unbounded";
  decision += census.free == 0                 ? " resistance problem"
              : prescribed + census.outer == 0 ? " mobility problem"
                                               : " mixed problem";
  std::string reason = count(census.free, "free body", "free bodies") + ", " +
                       count(census.held, "held body", "held bodies") + ", " +
                       count(census.inner, "inner wall", "inner walls") + ", " +
                       (census.outer > 0 ? "one" : "no") + " enclosing wall";
  if (scene.viscosity != 1.0) reason += ", viscosity " + short_number(scene.viscosity);
  return {"problem", decision, reason};
}

Plan::Line far_field_line(const Census& census, const Scene& scene) {
  if (census.outer > 0) return {"far field", "none", "the fluid ends at the enclosing wall"};
  if (scene.gauge_length) {
    return {"far field", "Stokeslets of gauge length " + short_number(*scene.gauge_length),
            "flow.gauge_length is given"};
  }
  if (census.held + census.inner > 0) {
    return {
        "far field", "zero net force, free uniform velocity",
        "unbounded fluid with prescribed velocities and no flow.gauge_length (Stokes' paradox)"};
  }
  return {"far field", "decaying disturbance", "free bodies in unbounded fluid, no net force"};
}

Plan::Line singularity_line(const Census& census) {
  if (census.held + census.inner > 0) {
    return {"singularities", "Stokeslets and rotlets in the density's functionals",
            "forces and torques of inner walls and held bodies are unknown"};
  }
  if (census.loaded) {
    return {"singularities", "given Stokeslets and rotlets", "loads on bodies"};
  }
  return {"singularities", "none", "no loads, no inner walls, no held bodies"};
}

Plan::Line preconditioner_line(const Plan& plan, const Scene& scene, bool only_circles) {
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

// Least relative residual that rounding allows.
constexpr double rounding_of_residuals = 1e-14;

Plan::Line gmres_line(const Plan& plan, const SolverSettings& solver) {
  const std::string decision = "to " + short_number(plan.gmres_tolerance) + ", without restart";
  if (solver.gmres_tol) return {"GMRES", decision, "solver.gmres_tol"};
  const std::string asked = "solver.tolerance = " + short_number(solver.tolerance) + " / 100";
  const bool is_met = 0.01 * solver.tolerance >= rounding_of_residuals;
  return {"GMRES", decision, is_met ? asked : "limited by rounding: " + asked};
}

Plan::Line fields_line(const FieldSettings& fields) {
  const FieldGrid grid = field_grid(fields);
  std::string quantities;
  for (const FieldQuantity quantity : fields.quantities) {
    if (!quantities.empty()) quantities += ", ";
    quantities += scene_text::name_of(quantity, scene_text::field_quantities);
  }
  return {"fields", std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " points",
          quantities + " at every written time"};
}

Plan::Line contact_line(const Scene& scene) {
  if (!scene.contact) return {"contact", "none", "no [contact]: an overlap stops the run"};
  return {"contact",
          "least gap " + short_number(scene.contact->minimum_separation) +
              (scene.contact->in_spacings ? " node spacings" : ""),
          "contact.minimum_separation, by space-time interference and complementarity"};
}

}  // namespace

bool Plan::is_fast(double pairs_a_point) const {
  if (summation != Summation::automatic) return summation == Summation::fmm;
  if (sum_tolerance < least_sum_tolerance) return false;
  const FmmSettings settings = FmmSettings::for_tolerance(sum_tolerance);
  return pairs_a_point > static_cast<double>(break_even(settings));
}

SumMethod Plan::sum_method(Eigen::Index nodes) const {
  if (is_fast(static_cast<double>(nodes))) return SumMethod::fast;
  return StressletSum::automatic_storage(nodes) == KernelStorage::stored ? SumMethod::stored
                                                                         : SumMethod::streamed;
}

bool Plan::is_fast_at(Eigen::Index targets, Eigen::Index nodes) const {
  const auto m = static_cast<double>(targets), n = static_cast<double>(nodes);
  return targets > 0 && is_fast(m * n / (m + n));
}

Plan make_plan(const Scene& scene) {
  const Census census = take_census(scene);
  const double tolerance = scene.solver.tolerance;
  Plan plan;
  plan.null_space_fix = census.outer > 0;
  plan.near_correction = scene.solver.near_singular != NearSingular::off && census.components > 1;
  // The own block of a circle has the eigenvalues -1 and -1/2 only: its inverse saves nothing.
  const bool only_circles = census.circles == census.components;
  const bool local = scene.solver.coupling == Coupling::local;
  const bool chosen_here = !local && scene.solver.preconditioner == PreconditionerKind::automatic;
  plan.preconditioner = local          ? PreconditionerKind::block_diagonal
                        : !chosen_here ? scene.solver.preconditioner
                        : only_circles ? PreconditionerKind::none
                                       : PreconditionerKind::block_diagonal;
  // Below this tolerance, the rounding errors of a factorisation in the softest modes of held
  // components show in the estimates. Iterations that stop in time hardly touch these modes.
  constexpr double least_tolerance_of_direct = 1e-8;
  plan.direct_at_tight_gaps =
      chosen_here && census.components > 1 && tolerance >= least_tolerance_of_direct;
  // GMRES with clusters may break down if held components are close to each other (chapter 05).
  plan.clusters_at_tight_gaps = chosen_here && census.free > 1 && census.held + census.inner == 0;
  // A hundredth of the tolerance leaves room for the condition number. Rounding limits all
  // tolerances from below.
  plan.gmres_tolerance =
      scene.solver.gmres_tol.value_or(std::max(rounding_of_residuals, 0.01 * tolerance));
  // With contact, the densities of films under pressure exceed the scale of velocities by orders of
  // magnitude, and so do the errors of sums. These errors are rough: taken for unresolved tails of
  // densities, they would make the node number grow without end. Sums are therefore a hundred times
  // as accurate.
  const double closer = scene.contact ? 1e-2 : 1.0;
  plan.near_tolerance = std::max(1e-15, closer * 0.01 * tolerance);
  plan.summation = scene.solver.summation;
  plan.sum_tolerance = closer * 0.1 * plan.gmres_tolerance;

  plan.lines.push_back(problem_line(census, scene));
  plan.lines.push_back(far_field_line(census, scene));
  plan.lines.push_back(singularity_line(census));
  plan.lines.push_back(plan.null_space_fix
                           ? Plan::Line{"N_0", "yes", "an enclosing wall has a null space"}
                           : Plan::Line{"N_0", "no", "no enclosing wall"});
  const std::string scheme =
      scene.solver.near_singular == NearSingular::interpolation ? "interpolation" : "Cauchy";
  const std::string near_reason =
      scene.solver.near_singular == NearSingular::off ? "solver.near_singular = \"off\""
      : census.components == 1                        ? "a single component"
                               : scheme + " scheme where the error of the trapezoid rule exceeds " +
                                     short_number(plan.near_tolerance);
  plan.lines.push_back({"near correction", plan.near_correction ? "yes" : "no", near_reason});
  plan.lines.push_back(preconditioner_line(plan, scene, only_circles));
  if (local) {
    plan.lines.push_back({"coupling", "lagged: one sweep of block Jacobi a step after the first",
                          "solver.coupling; its error is reported, and not bounded"});
  }
  plan.lines.push_back(gmres_line(plan, scene.solver));
  if (is_couette_cell(scene)) {
    plan.lines.push_back({"rheology", "one solve without bodies", "a Couette cell's torque ratio"});
  }
  if (scene.output.fields) plan.lines.push_back(fields_line(*scene.output.fields));
  plan.lines.push_back(contact_line(scene));
  return plan;
}

}  // namespace stokesbook
