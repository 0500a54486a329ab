// Study of near-singular evaluation: the errors of every scheme at any distance from a curve.
#include "study/study.hpp"

#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study near_singular_study() {
  using namespace verification::near_singular;
  return {.number = "06",
          .name = "near_singular",
          .title = "Near-singular evaluation",
          .experiments = {distances(), false_successes(), shapes(), derivatives(), convergence(),
                          upsampling(), degrees(), tolerances(), tabulated(), sweep(), preimages(),
                          sides(), border(), pairs(), lobed_bodies(), beside_the_plain_rule(),
                          work_precision(), preimage_order(), gaps()}};
}

}  // namespace stokesbook
