#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// Returns a study's results as CSV, a line for each measurement, with numbers at full precision.
///
/// The last column distinguishes measurements that the check used, measurements that it left out,
/// and controls.
std::string to_csv(const StudyResult& result);

/// Returns the numbers of a study as aliases of Doxygen, one line `ALIASES += name="value"` for
/// each: `val_<number>_<experiment>_<line>_<x>` is an error, `val_claim_<id>` the measured number
/// of a claim, `val_claim_<id>_claimed` the claimed number, and `badge_<id>` a link to the claim.
std::string to_aliases(const StudyResult& result);

/// Returns all tables and figures of a study as a page of Doxygen: Markdown that includes the files
/// of write_report().
/// @param  origin  version, compiler and machine of the results, as text
std::string study_page(const StudyResult& result, const std::string& origin);

/// Returns the index of all claims as a page of Doxygen (Markdown), with links to chapters, studies
/// and API. The studies are in reading order.
std::string claims_page(const std::vector<StudyResult>& results);

/// Writes the files of a study into an existing directory: `<name>.csv`, `<name>.aliases`,
/// `<name>_study.md`, and for each experiment `<name>_<experiment>_table.html`, `..._figure.html`
/// and, if the experiment requests it, `..._work_figure.html`. A line without measurements is left
/// out. If no line of an experiment has measurements, only the table file is written, with a
/// sentence instead of a table.
/// @throws RecordError when a file cannot be written
void write_report(const StudyResult& result, const std::string& origin,
                  const std::filesystem::path& directory);

/// Writes the common files of several studies into an existing directory: `claims.md` for Doxygen,
/// and `index.html`, which shows every table and figure without Doxygen.
/// @throws RecordError when a file cannot be written
void write_index(const std::vector<StudyResult>& results, const std::string& origin,
                 const std::filesystem::path& directory);

}  // namespace stokesbook::study
