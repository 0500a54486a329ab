#pragma once

#include <string>

#include "record/svg.hpp"
#include "study/study.hpp"

namespace stokesbook::study {

using svg::escaped;

/// Writes a number as HTML with three digits, with powers of ten as in 1.3·10⁻¹². Whole numbers
/// below a million keep all their digits; NaN becomes a dash.
std::string html_number(double x);

/// Writes an experiment's errors as an HTML table.
///
/// The table has a row for each x, with the error of each line and the order (on logarithmic axes)
/// or rate between rows. The last rows list the law, the measured number and the verdict of each
/// line. Numbers that a check left out are grey.
std::string convergence_table(const ExperimentResult& result);

/// Lists the claims of a study as HTML: statement, law and reason, and the evidence.
std::string claims_list(const StudyResult& result);

/// Returns the outcome of a line's claim as HTML, bold unless the claim holds, or a sentence if the
/// line has no claim.
std::string verdict_html(const LineResult& result);

/// Returns the evidence for a line's claim as HTML: the measurement with its verdict, and the defect
/// of the control with its own. The separator stands between the two.
std::string evidence_html(const LineResult& result, const std::string& separator);

/// The sentence that pages show in place of numbers that the size of a study leaves out.
inline constexpr const char* full_size_measures = "The full size of the study measures this.";

}  // namespace stokesbook::study
