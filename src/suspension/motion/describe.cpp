// Describes the plan of a scene, its nodes, gaps and time steps, as lines of text for the user
// (chapter 12, section "System").
#include "suspension/motion/describe.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "null_space/null_space.hpp"
#include "scene/words.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/forcing.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/fields.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

// One decision of a plan with its reason.
struct PlanLine {
  std::string topic, decision, reason;
};

std::string number_of(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

PlanLine problem_line(const ComponentCounts& counts, const Scene& scene) {
  const std::size_t prescribed = counts.held + counts.inner;
  std::string decision = counts.outer > 0 ? "bounded" : scene.cell ? "periodic" : "unbounded";
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
  if (scene.cell) {
    if (scene.cell->pressure_gradient) {
      return {"far field", "given gradient of the pressure, free mean velocity",
              "cell.pressure_gradient"};
    }
    return {"far field", "given mean velocity",
            "a periodic cell, in which forces need not balance"};
  }
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
  const bool loaded = std::ranges::any_of(scene.bodies, [](const Body& body) {
    const LoadLaws& laws = body.loads;
    return body.force != Complex{} || body.torque != 0.0 || laws.density || laws.trap ||
           laws.magnetic_moment != Complex{};
  });
  if (loaded || scene.repulsion)
    return {"singularities", "given Stokeslets and rotlets", "loads on bodies"};
  return {"singularities", "none", "no loads, no inner walls, no held bodies"};
}

// Describes the loads that depend on place, and the changes of the forcing in time; no lines if
// there are none.
std::vector<PlanLine> forcing_lines(const Scene& scene) {
  std::vector<std::string> laws;
  if (scene.gravity) laws.push_back("weight minus buoyancy");
  if (std::ranges::any_of(scene.bodies, [](const Body& body) { return !!body.loads.trap; })) {
    laws.push_back("traps");
  }
  if (scene.magnetic_field) laws.push_back("magnetic torques");
  if (scene.repulsion) {
    laws.push_back("repulsion " + short_number(scene.repulsion->strength) + " exp(-gap / " +
                   short_number(scene.repulsion->range) + ")");
  }
  std::vector<PlanLine> lines;
  if (!laws.empty()) lines.push_back({"loads", joined(laws), "computed in each configuration"});
  const std::size_t jumps = forcing_events(scene).size() - scene.reverse_at.size();
  if (jumps > 0) {
    lines.push_back({"amplitudes", "steps end at " + number_of(jumps, "time", "times"),
                     "an amplitude jumps or changes its slope there"});
  }
  const double period = shortest_period(scene);
  if (std::isfinite(period)) {
    const bool adapts = scene.time && adapts_steps(*scene.time);
    lines.push_back({"amplitudes", "shortest period " + short_number(period),
                     adapts ? "steps are not longer than a quarter of it"
                            : "steps of fixed length must resolve it"});
  }
  return lines;
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
      plan.preconditioner == PreconditionerKind::direct         ? "the whole system, factorised"
      : plan.preconditioner == PreconditionerKind::hierarchical ? "a tree of groups, from the right"
      : plan.preconditioner == PreconditionerKind::clusters     ? "clusters, from the right"
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
  if (!plan.direct_allowed && !plan.tree_allowed) {
    return {"preconditioner", decision, reason};
  }
  const char* small = plan.direct_allowed ? ", small systems factorised" : "";
  const char* large = plan.tree_allowed ? ", large ones by a tree of groups" : "";
  return {"preconditioner", decision + "; where gaps are tight or many" + small + large, reason};
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
  const auto to_name = [](FieldQuantity quantity) {
    return scene_text::name_of(quantity, scene_text::field_quantities);
  };
  return {"fields", std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " points",
          joined(fields.quantities, ", ", to_name) + " at every written time"};
}

PlanLine contact_line(const Scene& scene) {
  if (!scene.contact) return {"contact", "none", "no [contact]: an overlap stops the run"};
  return {"contact",
          "least gap " + short_number(scene.contact->minimum_separation) +
              (scene.contact->in_spacings ? " node spacings" : ""),
          "contact.minimum_separation, by space-time interference and complementarity"};
}

// Explains all decisions of a plan, in the order in which a run prints them.
std::vector<PlanLine> plan_lines(const Plan& plan, const Scene& scene) {
  const ComponentCounts counts = count_components(scene);
  std::vector<PlanLine> lines{problem_line(counts, scene), far_field_line(counts, scene),
                              singularity_line(counts, scene)};
  std::ranges::move(forcing_lines(scene), std::back_inserter(lines));
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

struct ShapeName {
  std::string operator()(const Circle& circle) const {
    return "circle " + short_number(circle.radius);
  }
  std::string operator()(const Ellipse& ellipse) const {
    return "ellipse " + short_number(ellipse.a) + " x " + short_number(ellipse.b);
  }
  std::string operator()(const Star& star) const {
    return std::to_string(star.arms) + "-armed star " + short_number(star.radius);
  }
  std::string operator()(const Superellipse& shape) const {
    return "superellipse " + short_number(shape.a) + " x " + short_number(shape.b);
  }
  std::string operator()(const NodalCurve& curve) const {
    return "curve through " + std::to_string(curve.points.size()) + " points";
  }
};

std::string aligned(const std::string& topic, const std::string& text) {
  constexpr std::size_t width = 17;
  return topic + std::string(topic.size() < width ? width - topic.size() : 1, ' ') + text;
}

// Returns whether two resolutions look the same to the reader: the places where nodes crowd differ
// from body to body, and are not compared.
bool is_same(const Resolution& a, const Resolution& b) {
  return a.n_nodes == b.n_nodes && a.is_graded() == b.is_graded();
}

// Recommends a number of nodes for components with given nodes; 0: no number suffices.
std::string recommendation(int nodes) {
  return nodes > 0 ? "; " + std::to_string(nodes) + " recommended for shape and gaps"
                   : "; no number up to " + std::to_string(most_nodes_for_shape) +
                         " resolves the shape to solver.tolerance";
}

// Explains what becomes of the net flux that interpolated velocities have.
std::string flux_text(const SuspensionSolver& solver) {
  const StokesProblem problem = solver.problem(solver.start(), solver.discretisation());
  const double flux = net_flux(problem);
  const auto wall =
      std::ranges::find(problem.components, ComponentKind::enclosing_wall, &Component::kind);
  return "net flux " + short_number(flux) + ", which is removed, if it is small, by the velocity " +
         short_number(-flux / perimeter(wall->curve)) + " on the outer wall, outwards";
}

// Returns one text for all components that share a shape and a resolution, and whose nodes are all
// given or all chosen.
std::vector<std::string> component_texts(const SuspensionSolver& solver,
                                         const Resolutions& resolutions,
                                         const std::vector<int>& recommended) {
  const Discretisation& discretisation = solver.discretisation();
  std::vector<std::string> texts;
  const auto is_chosen = [&](std::size_t component) {
    return component_of(solver.scene(), component).has_automatic_nodes();
  };
  std::vector<bool> done(discretisation.size(), false);
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    if (done[k]) continue;
    int members = 0, most = 0;
    for (std::size_t j = k; j < discretisation.size(); ++j) {
      if (discretisation[j] != discretisation[k] || !is_same(resolutions[j], resolutions[k]) ||
          is_chosen(j) != is_chosen(k)) {
        continue;
      }
      done[j] = true;
      ++members;
      most = std::max(most, recommended[j]);
    }
    texts.push_back(
        std::to_string(members) + " x " + std::visit(ShapeName{}, discretisation[k]->shape) + ", " +
        std::to_string(resolutions[k].n_nodes) + " nodes" +
        (resolutions[k].is_graded() ? " that crowd at gaps" : "") +
        (is_chosen(k) ? " initially, chosen for shape and gaps" : recommendation(most)));
  }
  return texts;
}

std::string sum_text(const Plan& plan, Eigen::Index nodes, bool has_cell) {
  const bool asked = plan.summation != Summation::automatic;
  const FmmSettings settings = FmmSettings::for_tolerance(plan.sum_tolerance);
  const std::string fast =
      "fast multipole method of order " + std::to_string(settings.order) + ": ";
  if (has_cell) return fast + "a periodic cell";
  if (!plan.is_fast(nodes)) {
    return StressletSum::automatic_storage(nodes) == KernelStorage::stored
               ? "direct, stored matrix: few nodes, the matrix stays in the cache"
               : "direct, streamed: evaluating the kernel is faster than reading a stored matrix";
  }
  return fast +
         (asked ? "solver.summation"
                : "more nodes than the " + std::to_string(break_even(settings)) + " of break-even");
}

std::string vector_text(Complex vector) {
  return "(" + short_number(vector.real()) + ", " + short_number(vector.imag()) + ")";
}

// Describes the cell at the start, and the sums over its images.
std::string cell_text(const SuspensionSolver& solver, const Instant& start,
                      const Resolutions& resolutions) {
  const Lattice lattice = lattice_of(*start.cell);
  const double tolerance = solver.plan().sum_tolerance;
  const FastSum sum(solver.problem(start, solver.discretise(resolutions)), tolerance);
  return "area " + short_number(lattice.area()) + ", reduced basis " +
         vector_text(lattice.shortest()) + ", " + vector_text(lattice.second()) + "; " +
         std::to_string(sum.near_images().size()) + " near images, all others by an operator of " +
         "order " + std::to_string(FmmSettings::for_tolerance(tolerance).order);
}

std::string late_reversals(const Scene& scene) {
  const auto late = std::ranges::upper_bound(scene.reverse_at, scene.time->t_final);
  if (late == scene.reverse_at.end()) return {};
  return "; reverse_at = " + short_number(*late, 6) + " is after the end";
}

std::string steps_text(const Scene& scene) {
  constexpr const char* names[] = {
      "explicit Euler",      "Adams-Bashforth 2",  "Heun", "Runge-Kutta 4", "Bogacki-Shampine 3(2)",
      "Dormand-Prince 5(4)", "Prince-Dormand 8(7)"};
  const TimeSettings& time = *scene.time;
  const std::string method = names[static_cast<int>(time.method)];
  const std::string end = " to t = " + short_number(time.t_final, 6);
  if (adapts_steps(time)) {
    const double velocities = scene.solver.tolerance;
    const double positions = time.tolerance.value_or(default_step_tolerance);
    const std::string solver = "; solver.tolerance = " + short_number(velocities);
    const bool is_least = positions <= 1.001 * velocities / most_solver_over_step;
    return method + ", steps for a tolerance of " + short_number(positions) + end +
           (is_least                 ? solver + " admits no lower tolerance of steps"
            : positions < velocities ? solver + " is larger, and limits the accuracy"
                                     : "");
  }
  if (time.effort) return method + ", steps from " + short_number(*time.dt) + " by effort" + end;
  const double steps = std::ceil(time.t_final / *time.dt - 1e-9);
  return method + ", about " + short_number(steps, 9) + " steps of " + short_number(*time.dt) + end;
}

}  // namespace

std::vector<std::string> describe(const SuspensionSolver& solver) {
  const Scene& scene = solver.scene();
  std::vector<std::string> lines;
  const auto add = [&](const std::string& topic, const std::string& text) {
    lines.push_back(aligned(topic, text));
  };
  for (const auto& [topic, decision, reason] : plan_lines(solver.plan(), scene)) {
    add(topic, decision + ": " + reason);
  }
  add("time", scene.time ? steps_text(scene) + late_reversals(scene) : "none: one solve at t = 0");
  const Instant instant = solver.start();
  const Configuration& start = instant.configuration;
  const std::vector<Gap> gaps = solver.gaps(start, instant.cell);
  const Resolutions resolutions = solver.first_resolutions(start, gaps);
  long long nodes = 0;
  for (const Resolution& resolution : resolutions) nodes += resolution.n_nodes;
  add("unknowns", std::to_string(2 * nodes) + ": " + std::to_string(nodes) +
                      " nodes; motions and loads are functionals of the density (reduced closure)");
  add("summation", sum_text(solver.plan(), nodes, scene.cell.has_value()));
  if (scene.cell) add("cell", cell_text(solver, instant, resolutions));
  if (is_enclosed(scene) && has_velocity_data(scene)) add("velocity data", flux_text(solver));
  const std::vector<int> recommended = solver.recommended_nodes(start, gaps);
  for (const std::string& text : component_texts(solver, resolutions, recommended)) {
    add("components", text);
  }
  if (!gaps.empty()) {
    const auto& [a, b, points, shift] = gaps.front();
    add("closest pair", (shift == 0.0 ? name_pair(scene, a, b) : name_image_pair(scene, a, b)) +
                            ", " + short_number(points.gap) + " apart");
  }
  return lines;
}

std::string describe(const SuspensionSolver& solver, const Solution& solution) {
  std::map<int, int> components;  // number of components by number of nodes
  for (const Resolution& resolution : resolutions_of(solution.discretisation)) {
    ++components[resolution.n_nodes];
  }
  std::vector<std::string> nodes;
  for (const auto& [count, members] : components) {
    nodes.push_back(std::to_string(members) + " x " + std::to_string(count));
  }
  return aligned("resolution", "estimated error " + short_number(solution.error_estimate) +
                                   " of the velocities at the start, " +
                                   short_number(solver.scene().solver.tolerance) +
                                   " required; nodes " + joined(nodes) + "; " +
                                   std::to_string(solution.cost.gmres_iterations) +
                                   " GMRES iterations");
}

}  // namespace stokesbook
