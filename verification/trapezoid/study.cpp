// Study of the trapezoid rule: compares rates of convergence with predictions from the
// singularities.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study trapezoid_study() {
  using namespace verification::trapezoid;
  return {
      .number = "01",
      .name = "trapezoid",
      .title = "The trapezoid rule on closed curves",
      .experiments = {published_table(), smoothness(), pole_rates(), interpolation_rates(),
                      perimeters(), ellipse_spectrum(), graded_poles(), graded_counts(), rules()}};
}

}  // namespace stokesbook
