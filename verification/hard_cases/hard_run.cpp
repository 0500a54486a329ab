// Runs hard scenes in time, and compares gaps with the separation.
#include "hard_run.hpp"

#include <algorithm>

#include "support/exact_gaps.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

Finding run(const Scene& scene, double tolerance, const RunMeasure& error) {
  const RecordedRun recorded = recorded_run(scene, Refusals::recorded);
  Finding finding{.tolerance = tolerance,
                  .iterations = recorded.totals.gmres_iterations,
                  .refusal = recorded.stopped};
  if (recorded.stopped.empty()) finding.error = error(recorded);
  return finding;
}

double shortfall(const Scene& scene, const RecordedRun& recorded) {
  const double separation = scene.contact->minimum_separation;
  const double least = least_exact_gap(scene, recorded.frames, 2.0 * separation);
  return std::max(0.0, 1.0 - least / separation);
}

}  // namespace stokesbook::verification::hard_cases
