// Study of stress: derivatives on the boundary and near it, loads and dissipation, and the
// contribution of bodies to the viscosity of a suspension.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study stress_study() {
  using namespace verification::stress;
  return {
      .number = "07",
      .name = "stress",
      .title = "Stress, dissipation and rheology",
      .experiments = {methods_on_the_surface(), rates_on_the_surface(), distances(), spacings(),
                      loads_of_tractions(), eccentric(), dissipation_of_gaps(), quadrature(),
                      stresslets(), orbits(), aspect_ratios(), container(), excess(), dilute()}};
}

}  // namespace stokesbook
