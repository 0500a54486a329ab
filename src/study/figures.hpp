#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Draws an experiment's errors against what was varied, as SVG.
///
/// Laws are drawn as slope triangles on logarithmic axes and as dashed lines of the claimed rate on
/// semi-logarithmic ones; floors are dotted; points that a check left out are hollow.
///
/// @param  experiment  what was measured
/// @param  lines       its results, in order
/// @return             an svg element
std::string convergence_figure(const Experiment& experiment, const std::vector<LineResult>& lines);

/// Draws an experiment's errors against each cost that was measured, as SVG elements one after
/// another: unknowns, counted operations, seconds.
///
/// @param  experiment  what was measured
/// @param  lines       its results, in order
/// @return             none to three svg elements
std::string work_precision_figures(const Experiment& experiment,
                                   const std::vector<LineResult>& lines);

/// @}

}  // namespace stokesbook::study
