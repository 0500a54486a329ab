// Study of the space-time interference: detection at any speed, accuracy, and cost.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study stiv_study() {
  using namespace verification::stiv;
  return {.number = "10",
          .name = "stiv",
          .title = "Space-time interference",
          .experiments = {tunnelling(), first_contact(), advancement(), distances(),
                          vertices_for_a_separation(), volume_of_depth(), volume_of_vertices(),
                          one_newton_step(), newton_iterations(), gradients(), balance(),
                          observers(), valley(), queries(), pairs()}};
}

}  // namespace stokesbook
