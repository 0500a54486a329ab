#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::lcp {

/// @name Experiments of the study
/// @{
study::Experiment pivots();
study::Experiment rays();
study::Experiment sweeps();
study::Experiment chains();
study::Experiment newton_steps();
study::Experiment suite_residuals();
study::Experiment profile();
study::Experiment definite();
study::Experiment singular();
study::Experiment long_chain();
study::Experiment hilbert();
study::Experiment units();
study::Experiment depths();
study::Experiment totals();
study::Experiment histories();
study::Experiment powers();
study::Experiment crowds();
study::Experiment turns();
study::Experiment clips();
/// @}

}  // namespace stokesbook::verification::lcp
