#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::suspension {

/// @name Experiments of the study
/// @{
study::Experiment spread_of_estimates();
study::Experiment estimates();
study::Experiment hard_shapes();
study::Experiment field_errors();
study::Experiment errors_on_automatic_nodes();
study::Experiment pair_speeds();
study::Experiment lubrication();
study::Experiment many_bodies();
study::Experiment reversal_table();
study::Experiment holding_force();
study::Experiment holding_force_limit();
study::Experiment holding_steps();
study::Experiment contact_orders();
study::Experiment resting();
study::Experiment contact_turning();
study::Experiment contact_price();
study::Experiment cost_of_contact();
study::Experiment random_crowds();
study::Experiment taylor_green_in_contact();
study::Experiment lagged_contact();
study::Experiment lagged_steps();
study::Experiment lagged_growth();
study::Experiment extension_order();
study::Experiment extension_gaps();
study::Experiment extension_apart();
study::Experiment couette_starts();
study::Experiment couette_digits();
study::Experiment couette_turns();
study::Experiment couette_second_turn();
study::Experiment couette_interval();
study::Experiment couette_small();
study::Experiment couette_care();
study::Experiment couette_seeds();
study::Experiment couette_unattended();
study::Experiment lobed_iterations();
study::Experiment lobed_run();
study::Experiment vortex_iterations();
study::Experiment injection();
study::Experiment rotors();
study::Experiment narrow_gaps();
study::Experiment contact_response();
std::vector<study::Experiment> methods_compared();
/// @}

}  // namespace stokesbook::verification::suspension
