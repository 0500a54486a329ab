#pragma once

#include "study/study.hpp"

namespace stokesbook::verification::near_singular {

/// @name Experiments of the study
/// @{
study::Experiment distances();
study::Experiment false_successes();
study::Experiment shapes();
study::Experiment derivatives();
study::Experiment convergence();
study::Experiment upsampling();
study::Experiment degrees();
study::Experiment tolerances();
study::Experiment sweep();
study::Experiment tabulated();
study::Experiment preimages();
study::Experiment sides();
study::Experiment border();
study::Experiment pairs();
study::Experiment lobed_bodies();
study::Experiment beside_the_plain_rule();
study::Experiment work_precision();
study::Experiment preimage_order();
study::Experiment gaps();
/// @}

}  // namespace stokesbook::verification::near_singular
