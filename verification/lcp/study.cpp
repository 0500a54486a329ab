// Study of the complementarity solvers and of the loop around them: counts, orders and verdicts.
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
