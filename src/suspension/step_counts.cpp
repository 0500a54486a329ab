#include "suspension/step_counts.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

namespace stokesbook {

StepInfo begun_step(const Solution& first, double seconds) {
  const StepInfo none{.min_gap = std::numeric_limits<double>::infinity(),
                      .error_estimate = first.error_estimate};
  return with_solve(none, first, seconds);
}

StepInfo with_solve(StepInfo step, const Solution& solution, double seconds) {
  const double gap = solution.gaps.empty() ? std::numeric_limits<double>::infinity()
                                           : solution.gaps.front().points.gap;
  step.min_gap = std::min(step.min_gap, gap);
  step.gmres_iterations += solution.cost.gmres_iterations;
  step.matvecs += solution.cost.matvecs;
  step.residual = std::max(step.residual, solution.gmres.residual);
  step.seconds += seconds;
  return step;
}

StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost) {
  step.gmres_iterations += cost.gmres_iterations;
  step.matvecs += cost.matvecs;
  step.ncp_iterations += outcome.result.iterations;
  step.contacts = std::max(step.contacts, pairs_in_contact(outcome.forces));
  step.seconds += outcome.seconds;
  return step;
}

int pairs_in_contact(const std::vector<ContactForce>& forces) {
  std::set<std::tuple<bool, std::size_t, bool, std::size_t>> pairs;
  for (const ContactForce& force : forces) {
    pairs.emplace(force.a.is_wall, force.a.number, force.b.is_wall, force.b.number);
  }
  return static_cast<int>(pairs.size());
}

}  // namespace stokesbook
