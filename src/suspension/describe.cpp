#include "suspension/describe.hpp"

#include <algorithm>
#include <cmath>

#include "record/number_text.hpp"
#include "suspension/refusal.hpp"

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

// One line for all components that share a reference.
std::vector<std::string> component_lines(const SuspensionSolver& solver,
                                         const std::vector<int>& recommended) {
  const References& references = solver.references();
  std::vector<std::string> lines;
  std::vector<bool> done(references.size(), false);
  for (std::size_t k = 0; k < references.size(); ++k) {
    if (done[k]) continue;
    int members = 0, nodes = 0;
    for (std::size_t j = k; j < references.size(); ++j) {
      if (references[j] != references[k]) continue;
      done[j] = true;
      ++members;
      nodes = std::max(nodes, recommended[j]);
    }
    const auto n = references[k]->curve.size();
    lines.push_back(
        aligned("components", std::to_string(members) + " x " + shape_name(references[k]->shape) +
                                  ", " + std::to_string(n) + " nodes; " + std::to_string(nodes) +
                                  " recommended for shape and gaps"));
  }
  return lines;
}

// What the nodes are expected to leave as error, before any solve.
std::vector<std::string> resolution_lines(const SuspensionSolver& solver,
                                          const Configuration& configuration) {
  const References& references = solver.references();
  const double tolerance = solver.scene().solver.tolerance;
  double error = 0.0;
  for (const auto& reference : references) {
    error = std::max(error, reference->rigid_motion_residual);
  }
  std::vector<std::string> lines;
  const std::vector<Gap> gaps = find_gaps(configuration, references, tolerance);
  for (const Gap& gap : gaps) {
    const bool apart = gap.points.gap > 0.0;
    error = std::max(error, apart ? gap_resolution(gap, configuration, references).error : 1.0);
  }
  if (!gaps.empty()) {
    lines.push_back(
        aligned("closest pair", component_name(solver.scene(), gaps.front().a) + " and " +
                                    component_name(solver.scene(), gaps.front().b) + ", " +
                                    short_number(gaps.front().points.gap) + " apart"));
  }
  lines.push_back(aligned("resolution", "estimated error " + short_number(error) +
                                            " of the velocities from shapes and gaps, " +
                                            short_number(tolerance) + " asked"));
  return lines;
}

std::string time_line(const Scene& scene) {
  if (!scene.time) return "none: one solve at t = 0";
  const char* names[] = {"explicit Euler", "Adams-Bashforth 2", "Runge-Kutta 4"};
  const double steps = std::ceil(scene.time->t_final / scene.time->dt - 1e-9);
  return std::string(names[static_cast<int>(scene.time->method)]) + ", about " +
         short_number(steps, 9) + " steps of " + short_number(scene.time->dt) +
         " to t = " + short_number(scene.time->t_final, 6);
}

}  // namespace

std::string shape_name(const Shape& shape) {
  return std::visit(ShapeName{}, shape);
}

std::vector<std::string> describe(const SuspensionSolver& solver) {
  std::vector<std::string> lines;
  for (const Plan::Line& line : solver.plan().lines) {
    lines.push_back(aligned(line.topic, line.decision + ": " + line.reason));
  }
  lines.push_back(aligned("time", time_line(solver.scene())));
  const Configuration start = solver.initial_configuration();
  for (std::string& line : component_lines(solver, solver.recommended_nodes(start))) {
    lines.push_back(std::move(line));
  }
  for (std::string& line : resolution_lines(solver, start)) lines.push_back(std::move(line));
  return lines;
}

}  // namespace stokesbook
