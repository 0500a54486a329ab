#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::suspension {

/// @name Experiments of the study
/// @{
study::Experiment spread_of_estimates();
study::Experiment estimates();
study::Experiment automatic_nodes();
study::Experiment pair_speeds();
study::Experiment lubrication();
study::Experiment many_bodies();
study::Experiment reversal_table();
study::Experiment holding_force();
study::Experiment holding_force_limit();
study::Experiment holding_steps();
study::Experiment contact_orders();
/// @}

}  // namespace stokesbook::verification::suspension
