// Studies the complementarity solvers and the contact loop: measures iteration counts and orders,
// and tests proofs that there is no solution.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study lcp_study() {
  using namespace verification::lcp;
  return {.number = "11",
          .name = "lcp",
          .title = "Linear complementarity",
          .experiments = {pivots(), rays(), sweeps(), chains(), newton_steps(), suite_residuals(),
                          profile(), definite(), singular(), long_chain(), hilbert(), units(),
                          depths(), totals(), histories(), powers(), crowds(), turns(), clips()}};
}

}  // namespace stokesbook
