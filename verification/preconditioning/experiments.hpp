#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::preconditioning {

/// @name Experiments of the study
/// @{
study::Experiment pair_spectrum();
study::Experiment clusters();
study::Experiment gaps();
study::Experiment target_iterations();
study::Experiment target_seconds();
study::Experiment ideas();
study::Experiment screening();
study::Experiment pores();
study::Experiment contact_iterations();
study::Experiment contact_seconds();
study::Experiment packings();
study::Experiment packing_seconds();
study::Experiment loaded_packings();
study::Experiment packing_fractions();
study::Experiment packing_prices();
study::Experiment fraction_prices();
study::Experiment packing_memory();
study::Experiment lines_of_disks();
study::Experiment containers();
study::Experiment jammed_packings();
study::Experiment crystals();
study::Experiment growth_of_iterations();
study::Experiment judged_packings();
study::Experiment earlier_trees();
study::Experiment choices();
study::Experiment choices_in_contact();
study::Experiment recycling();
/// @}

}  // namespace stokesbook::verification::preconditioning
