#pragma once

#include "hard_case.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::hard_cases {

/// Returns the error of a run that reached its end.
using RunMeasure = std::function<double(const test::RecordedRun&)>;

/// Runs a scene and measures its error; a refusal is recorded in the result.
Finding run(const Scene& scene, double tolerance, const RunMeasure& error);

/// Returns the amount by which the least gap of all written states is below the separation,
/// relative to the separation.
double shortfall(const Scene& scene, const test::RecordedRun& recorded);

}  // namespace stokesbook::verification::hard_cases
