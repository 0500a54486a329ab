// Defines the study of the suspension solver: error estimates, automatic node numbers, bodies in
// contact, published experiments, and the comparison of the published method with ours.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study suspension_study() {
  using namespace verification::suspension;
  study::Study study{
      .number = "12",
      .name = "suspension",
      .title = "The suspension solver: error estimates, automatic nodes, contact, experiments",
      .experiments = {spread_of_estimates(),
                      estimates(),
                      hard_shapes(),
                      field_errors(),
                      errors_on_automatic_nodes(),
                      pair_speeds(),
                      lubrication(),
                      narrow_gaps(),
                      contact_response(),
                      many_bodies(),
                      reversal_table(),
                      holding_force(),
                      holding_force_limit(),
                      holding_steps(),
                      contact_orders(),
                      resting(),
                      contact_turning(),
                      contact_price(),
                      cost_of_contact(),
                      random_crowds(),
                      taylor_green_in_contact(),
                      lagged_contact(),
                      lagged_steps(),
                      lagged_growth(),
                      extension_order(),
                      extension_gaps(),
                      extension_apart(),
                      couette_starts(),
                      couette_digits(),
                      couette_turns(),
                      couette_second_turn(),
                      couette_interval(),
                      couette_small(),
                      couette_care(),
                      couette_seeds(),
                      couette_unattended(),
                      lobed_iterations(),
                      lobed_run(),
                      vortex_iterations(),
                      injection(),
                      rotors()}};
  for (const study::Experiment& experiment : methods_compared()) {
    study.experiments.push_back(experiment);
  }
  return study;
}

}  // namespace stokesbook
