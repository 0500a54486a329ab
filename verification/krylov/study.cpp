// Studies GMRES and its preconditioners: compares numbers of iterations with the theory.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study krylov_study() {
  using namespace verification::krylov;
  return {.number = "05",
          .name = "krylov",
          .title = "GMRES and its preconditioners",
          .experiments = {known_spectra(),
                          least_residuals(),
                          normality(),
                          orthogonality(),
                          residuals(),
                          pair_spectrum(),
                          clusters(),
                          nine_by_form(),
                          published_count(),
                          one_body(),
                          slender_bodies(),
                          aspect_ratios(),
                          gaps(),
                          restarts(),
                          asked_iterations(),
                          asked_seconds(),
                          ideas(),
                          screening(),
                          pores(),
                          contact_iterations(),
                          contact_seconds(),
                          packings(),
                          packing_seconds(),
                          crystals(),
                          recycling(),
                          tolerances(),
                          solvers(),
                          costs_of_a_solve()}};
}

}  // namespace stokesbook
