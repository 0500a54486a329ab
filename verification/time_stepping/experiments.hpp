#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::time_stepping {

/// @name Experiments of the study
/// @{
study::Experiment orders_in_shear();
study::Experiment orders_in_extension();
study::Experiment orders_of_circles();
study::Experiment orders_of_passing();
study::Experiment interpolants();
study::Experiment step_errors();
study::Experiment tolerances();
study::Experiment tolerances_of_passing();
study::Experiment work();
study::Experiment work_of_nine();
study::Experiment work_of_cell();
study::Experiment reversal();
study::Experiment reversal_costs();
study::Experiment drift();
study::Experiment returns();
study::Experiment noisy_rates();
study::Experiment sweeps();
study::Experiment lagged();
study::Experiment guesses();
study::Experiment guesses_after_stages();
study::Experiment saved_iterations();
/// @}

}  // namespace stokesbook::verification::time_stepping
