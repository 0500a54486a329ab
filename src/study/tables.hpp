#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Writes an experiment's errors as an HTML table. The table has a row for each x, with the error
/// of each line and the order (on logarithmic axes) or rate between rows. The last rows list the
/// law, the measured number and the verdict of each line.
///
/// Numbers that a check left out are grey.
/// @param  experiment  the experiment
/// @param  lines       results of its lines, in order
/// @return             HTML
std::string convergence_table(const Experiment& experiment, const std::vector<LineResult>& lines);

/// Writes an experiment's errors and costs as an HTML table, a row for each measurement. Columns of
/// costs that were not measured are left out.
///
/// @param  experiment  the experiment
/// @param  lines       results of its lines, in order
/// @return             HTML
std::string work_precision_table(const Experiment& experiment,
                                 const std::vector<LineResult>& lines);

/// Writes the claims of a study as an HTML table: statement, reason and law, the measurement, the
/// control with its defect, and the verdict.
///
/// @param  result  of the study
/// @return         HTML
std::string claims_table(const StudyResult& result);

/// The sentence that pages show in place of numbers that the size of a study leaves out.
inline constexpr const char* full_size_measures = "The full size of the study measures this.";

/// @}

}  // namespace stokesbook::study
