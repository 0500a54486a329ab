// Solves hard cases, and decides whether each result is as required.
#include "hard_case.hpp"

#include <algorithm>
#include <cstdio>

namespace stokesbook::verification::hard_cases {

bool is_met(const HardCase& hard, const Finding& finding) {
  if (finding.refusal.empty()) {
    // A missing estimate (NaN) is accepted, a missing error is not.
    return hard.due != Due::refusal && finding.error <= finding.tolerance &&
           !(finding.estimate > finding.tolerance);
  }
  return hard.due != Due::answer && std::ranges::all_of(hard.words, [&](const std::string& word) {
           return finding.refusal.find(word) != std::string::npos;
         });
}

std::string text(const char* format, double number) {
  char buffer[160];
  std::snprintf(buffer, sizeof buffer, format, number);
  return buffer;
}

double distance_of_motions(const RigidMotion& a, const RigidMotion& b, double length) {
  return std::max(std::abs(a.velocity - b.velocity), length * std::abs(a.omega - b.omega));
}

Measure against_finer(const Scene& scene) {
  return [finer = scene](const Solution& solution) mutable {
    finer.solver.tolerance *= 1e-3;
    const SuspensionSolver solver(finer);
    const Solution reference = solver.solve(solver.start());
    double most = 0.0;
    for (std::size_t k = 0; k < solution.motions.size(); ++k) {
      most = std::max(most, distance_of_motions(solution.motions[k], reference.motions[k], 1.0));
    }
    return most;
  };
}

Finding solve(const Scene& scene, const Measure& error) {
  Finding finding{.tolerance = scene.solver.tolerance};
  try {
    const SuspensionSolver solver(scene);
    const Solution solution = solver.solve(solver.start());
    finding.error = error(solution) / solution.velocity_scale;
    finding.estimate = solution.error_estimate;
    finding.iterations = solution.cost.gmres_iterations;
  } catch (const SolverError& refusal) {
    finding.refusal = refusal.what();
  }
  return finding;
}

Body body(const Shape& shape, Complex position, double orientation) {
  return {.shape = shape, .position = position, .orientation = orientation};
}

Scene scene(const BackgroundFlow& flow, std::vector<Body> bodies, double tolerance) {
  Scene result;
  result.flow = flow;
  result.bodies = std::move(bodies);
  result.solver.tolerance = tolerance;
  return result;
}

Scene circles_in_extension(double gap, double tolerance) {
  const double x = 1.0 + 0.5 * gap;
  return scene(ExtensionalFlow{1.0}, {body(Circle{1.0}, -x), body(Circle{1.0}, x)}, tolerance);
}

}  // namespace stokesbook::verification::hard_cases
