#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::fmm {

/// @name Experiments of the study
/// @{
study::Experiment translation();
study::Experiment separation();
study::Experiment centres();
study::Experiment orders();
study::Experiment derivative_orders();
study::Experiment tolerances();
study::Experiment derivative_tolerances();
study::Experiment ill_cases();
study::Experiment cost();
study::Experiment break_even();
study::Experiment seconds();
study::Experiment work_precision();
study::Experiment threads();
study::Experiment fields();
/// @}

}  // namespace stokesbook::verification::fmm
