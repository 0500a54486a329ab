// Study of the fast multipole method: truncation errors, and cost.
#include "study/study.hpp"

#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study fmm_study() {
  using namespace verification::fmm;
  return {.number = "08",
          .name = "fmm",
          .title = "The fast multipole method",
          .experiments = {translation(), separation(), centres(), orders(), derivative_orders(),
                          tolerances(), derivative_tolerances(), ill_cases(), cost(), break_even(),
                          seconds(), work_precision(), threads(), fields()}};
}

}  // namespace stokesbook
