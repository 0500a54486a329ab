#pragma once

#include "study/study.hpp"

namespace stokesbook {

/// @name The studies, one for each method: claims of the chapter, and planted defects
/// @{
study::Study trapezoid_study();
study::Study double_layer_study();
study::Study closure_study();
study::Study null_space_study();
study::Study krylov_study();
study::Study near_singular_study();
study::Study stress_study();
study::Study fmm_study();
study::Study time_stepping_study();
study::Study stiv_study();
study::Study lcp_study();
study::Study suspension_study();
study::Study preconditioning_study();
study::Study periodic_study();
/// @}

}  // namespace stokesbook
