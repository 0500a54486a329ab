#pragma once

#include <string>

#include "study/study.hpp"

namespace stokesbook::study {

/// Replaces the characters that HTML reserves.
std::string escaped(const std::string& text);

/// Writes a number as HTML with three digits, with powers of ten as in 1.3·10⁻¹². Whole numbers
/// below a million keep all their digits; NaN becomes a dash.
std::string html_number(double x);

/// Writes an experiment's errors as an HTML table.
///
/// The table has a row for each x, with the error of each line and the order (on logarithmic axes)
/// or rate between rows. The last rows list the law, the measured number and the verdict of each
/// line. Numbers that a check left out are grey.
std::string convergence_table(const ExperimentResult& result);

/// Writes the claims of a study as an HTML table: statement, reason and law, the measurement, the
/// control with its defect, and the verdict.
std::string claims_table(const StudyResult& result);

/// Returns the outcome of a line's claim as HTML, bold unless the claim holds, or a sentence if the
/// line has no claim.
std::string verdict_html(const LineResult& result);

/// Returns the defect of a line's control as HTML, and whether the check has rejected it.
std::string control_html(const LineResult& result);

/// The sentence that pages show in place of numbers that the size of a study leaves out.
inline constexpr const char* full_size_measures = "The full size of the study measures this.";

}  // namespace stokesbook::study
