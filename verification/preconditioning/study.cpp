// Studies preconditioners for bodies that nearly touch: compares spectra, numbers of iterations and
// decays of forces with the theory.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study preconditioning_study() {
  using namespace verification::preconditioning;
  return {.number = "13",
          .name = "preconditioning",
          .title = "Bodies that nearly touch",
          .experiments = {pair_spectrum(),
                          clusters(),
                          gaps(),
                          target_iterations(),
                          target_seconds(),
                          ideas(),
                          screening(),
                          pores(),
                          contact_iterations(),
                          contact_seconds(),
                          packings(),
                          loaded_packings(),
                          packing_fractions(),
                          packing_prices(),
                          fraction_prices(),
                          packing_memory(),
                          lines_of_disks(),
                          containers(),
                          jammed_packings(),
                          packing_seconds(),
                          crystals(),
                          growth_of_iterations(),
                          judged_packings(),
                          earlier_trees(),
                          choices(),
                          choices_in_contact(),
                          recycling()}};
}

}  // namespace stokesbook
