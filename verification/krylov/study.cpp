// Studies GMRES: compares residuals and numbers of iterations with the theory.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study krylov_study() {
  using namespace verification::krylov;
  return {
      .number = "05",
      .name = "krylov",
      .title = "GMRES and the blocks of single bodies",
      .experiments = {known_spectra(), least_residuals(), normality(), orthogonality(), residuals(),
                      nine_by_form(), published_count(), one_body(), slender_bodies(),
                      aspect_ratios(), restarts(), tolerances(), solvers(), costs_of_a_solve()}};
}

}  // namespace stokesbook
