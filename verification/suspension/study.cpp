// Study of the solver: error estimates that can be trusted, and node counts chosen by them.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study suspension_study() {
  using namespace verification::suspension;
  return {.number = "12",
          .name = "suspension",
          .title = "The suspension solver: error estimates and automatic nodes",
          .experiments = {spread_of_estimates(), estimates(), automatic_nodes(), pair_speeds(),
                          lubrication(), many_bodies()},
          .has_chapter = false};
}

}  // namespace stokesbook
