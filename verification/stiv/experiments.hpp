#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::stiv {

/// @name Experiments of the study
/// @{
study::Experiment tunnelling();
study::Experiment first_contact();
study::Experiment advancement();
study::Experiment vertices_for_a_separation();
study::Experiment volume_of_depth();
study::Experiment volume_of_vertices();
study::Experiment one_newton_step();
study::Experiment newton_iterations();
study::Experiment distances();
study::Experiment gradients();
study::Experiment balance();
study::Experiment observers();
study::Experiment valley();
study::Experiment queries();
study::Experiment pairs();
/// @}

}  // namespace stokesbook::verification::stiv
