#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::periodic {

/// @name Experiments of the study
/// @{
study::Experiment lattice_sums();
study::Experiment orders();
study::Experiment tolerances();
study::Experiment ewald_sums();
study::Experiment small_disks();
study::Experiment drag();
study::Experiment printed_drag();
study::Experiment worm();
study::Experiment closures();
study::Experiment viscosity();
study::Experiment normal_stress();
study::Experiment rotation();
study::Experiment dense_arrays();
study::Experiment invariances();
study::Experiment wraps();
study::Experiment cost();
study::Experiment seconds();
/// @}

}  // namespace stokesbook::verification::periodic
