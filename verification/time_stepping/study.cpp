// Study of the time steppers: orders, errors for a given tolerance, and the number of solves for a
// given accuracy.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study time_stepping_study() {
  using namespace verification::time_stepping;
  return {.number = "09",
          .name = "time_stepping",
          .title = "Time stepping with error control",
          .experiments = {orders_in_shear(),
                          orders_in_extension(),
                          orders_of_circles(),
                          orders_of_passing(),
                          interpolants(),
                          step_errors(),
                          tolerances(),
                          tolerances_of_passing(),
                          work(),
                          work_of_nine(),
                          work_of_cell(),
                          reversal(),
                          reversal_costs(),
                          drift(),
                          returns(),
                          noisy_rates(),
                          sweeps(),
                          lagged(),
                          guesses(),
                          guesses_after_stages(),
                          saved_iterations()}};
}

}  // namespace stokesbook
