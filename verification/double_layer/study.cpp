// Study of the double layer: its identities, its rates of convergence, and the cases in which the
// plain rule fails.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study double_layer_study() {
  using namespace verification::double_layer;
  return {.number = "02",
          .name = "double_layer",
          .title = "The double layer of Stokes flow",
          .experiments = {published_table(), rates_near_the_curve(), spacings(), jumps(),
                          identities(), diagonal(), green(), dirichlet(), completion(),
                          conditioning(), cost(), near_target()}};
}

}  // namespace stokesbook
