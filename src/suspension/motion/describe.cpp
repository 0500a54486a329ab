// Describes the plan of a scene, its nodes, gaps and time steps, as lines of text for the user
// (chapter 12, section "One way for the data").
#include "suspension/motion/describe.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/plan_lines.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

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

std::string sum_text(const Plan& plan, Eigen::Index nodes) {
  const bool asked = plan.summation != Summation::automatic;
  if (!plan.is_fast(nodes)) {
    return StressletSum::automatic_storage(nodes) == KernelStorage::stored
               ? "direct, stored matrix: few nodes, the matrix stays in the cache"
               : "direct, streamed: evaluating the kernel is faster than reading a stored matrix";
  }
  const FmmSettings settings = FmmSettings::for_tolerance(plan.sum_tolerance);
  return "fast multipole method of order " + std::to_string(settings.order) + ": " +
         (asked ? "solver.summation"
                : "more nodes than the " + std::to_string(break_even(settings)) + " of break-even");
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
    return method + ", steps for a tolerance of " + short_number(positions) + end +
           (positions < velocities ? "; solver.tolerance = " + short_number(velocities) +
                                         " is larger, and limits the accuracy"
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
  const Configuration start = solver.start().configuration;
  const std::vector<Gap> gaps = solver.gaps(start);
  const Resolutions resolutions = solver.first_resolutions(start, gaps);
  long long nodes = 0;
  for (const Resolution& resolution : resolutions) nodes += resolution.n_nodes;
  add("unknowns", std::to_string(2 * nodes) + ": " + std::to_string(nodes) +
                      " nodes; motions and loads are functionals of the density (reduced closure)");
  add("summation", sum_text(solver.plan(), nodes));
  const std::vector<int> recommended = solver.recommended_nodes(start, gaps);
  for (const std::string& text : component_texts(solver, resolutions, recommended)) {
    add("components", text);
  }
  if (!gaps.empty()) {
    const auto& [a, b, points] = gaps.front();
    add("closest pair", component_of(scene, a).name() + " and " + component_of(scene, b).name() +
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
