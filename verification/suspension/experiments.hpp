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
/// @}

}  // namespace stokesbook::verification::suspension
