// Studies sums over a lattice and flows in periodic cells: compares them with Ewald sums, with
// expansions for small disks, and with printed values.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study periodic_study() {
  using namespace verification::periodic;
  return {.number = "14",
          .name = "periodic",
          .title = "Periodic and sheared cells",
          .experiments = {lattice_sums(), orders(), tolerances(), ewald_sums(), small_disks(),
                          drag(), printed_drag(), worm(), closures(), viscosity(), normal_stress(),
                          rotation(), dense_arrays(), invariances(), wraps(), cost(), seconds()}};
}

}  // namespace stokesbook
