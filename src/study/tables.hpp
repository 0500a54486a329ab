#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Writes an experiment's errors as an HTML table: a row for each x, for each line the error and
/// the order (on logarithmic axes) or rate between rows; below, what was claimed and found.
///
/// Numbers that a check left out are grey.
/// @param  experiment  what was measured
/// @param  lines       its results, in order
/// @return             HTML
std::string convergence_table(const Experiment& experiment, const std::vector<LineResult>& lines);

/// Writes an experiment's errors and costs as an HTML table, a row for each measurement; columns
/// of costs that were not measured are left out.
///
/// @param  experiment  what was measured
/// @param  lines       its results, in order
/// @return             HTML
std::string work_precision_table(const Experiment& experiment,
                                 const std::vector<LineResult>& lines);

/// Writes the claims of a study as an HTML table: what was claimed and why, what was measured, the
/// verdict, and the control with its defect.
///
/// @param  result  of the study
/// @return         HTML
std::string claims_table(const StudyResult& result);

/// Pages show this sentence in place of numbers that the size of a study leaves out.
inline constexpr const char* full_size_measures = "The full size of the study measures this.";

/// @}

}  // namespace stokesbook::study
