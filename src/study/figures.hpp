#pragma once

#include <string>

#include "study/study.hpp"

namespace stokesbook::study {

/// Draws an experiment's errors against the varied quantity, as SVG.
///
/// Laws are drawn as slope triangles on logarithmic axes and as dashed lines of the claimed rate on
/// semi-logarithmic axes. Floors are dotted. Points that a check left out are hollow.
std::string convergence_figure(const ExperimentResult& result);

/// Draws an experiment's errors against each cost of measured_costs(), as SVG elements one after
/// another.
std::string work_precision_figures(const ExperimentResult& result);

}  // namespace stokesbook::study
