#pragma once

#include "hard_case.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::hard_cases {

/// What is measured of a run that reached its end.
using RunMeasure = std::function<double(const test::RecordedRun&)>;

/// Runs a scene, and measures it; refusals are findings.
Finding run(const Scene& scene, double tolerance, const RunMeasure& error);

/// By how much the least gap of any written state falls short of the separation, relative to it.
double shortfall(const Scene& scene, const test::RecordedRun& recorded);

}  // namespace stokesbook::verification::hard_cases
