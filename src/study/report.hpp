#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// Where results come from.
struct Provenance {
  std::string version;   ///< of the project
  std::string git_hash;  ///< commit
  std::string compiler;  ///< name and version
  std::string flags;     ///< of the compiler
  std::string machine;   ///< processor
};

/// Returns a study's results as CSV, a line for each measurement, numbers at full precision.
///
/// Controls are rows too, told by the last column: used by the check, left out, or control.
/// @param  result  of the study
/// @return         CSV with a header line
std::string to_csv(const StudyResult& result);

/// Returns a study's claims, verdicts, controls and measurements as JSON, with where they come
/// from; numbers at full precision, null for what was not measured.
///
/// @param  result      of the study
/// @param  provenance  of this build
/// @return             JSON
std::string to_json(const StudyResult& result, const Provenance& provenance);

/// Returns the numbers of a study as aliases of Doxygen, an `ALIASES += name="value"` line each:
/// `val_<number>_<experiment>_<line>_<x>` for an error, `val_claim_<id>` for what was measured of a
/// claim and `val_claim_<id>_claimed` for what was claimed.
///
/// @param  result  of the study
/// @return         lines of a Doxyfile
std::string to_aliases(const StudyResult& result);

/// Returns all tables and figures of a study as a page of Doxygen, with where they come from.
///
/// @param  result      of the study
/// @param  provenance  of this build
/// @return             Markdown that includes the files of write_report()
std::string study_page(const StudyResult& result, const Provenance& provenance);

/// Returns the index of all claims as a page of Doxygen, with links to chapters, studies and API.
///
/// @param  results  of all studies, in reading order
/// @return          Markdown
std::string claims_page(const std::vector<StudyResult>& results);

/// Writes the files of a study into a directory: `<name>.csv`, `<name>.json`, `<name>.aliases`,
/// `<name>_study.md`, and for each experiment `<name>_<experiment>_table.html` and
/// `..._figure.html`, where they were asked for `..._work_table.html` and `..._work_figure.html`.
/// A line without measurements is left out. If an experiment has no others, there is a table only,
/// which says so.
///
/// @param  result      of the study
/// @param  provenance  of this build
/// @param  directory   exists
/// @throws RecordError when the disk does not take them
void write_report(const StudyResult& result, const Provenance& provenance,
                  const std::filesystem::path& directory);

/// Writes what several studies share: `claims.md` for Doxygen, and `index.html`, which shows every
/// table and figure without Doxygen.
///
/// @param  results     of all studies, in reading order
/// @param  provenance  of this build
/// @param  directory   exists
/// @throws RecordError when the disk does not take them
void write_index(const std::vector<StudyResult>& results, const Provenance& provenance,
                 const std::filesystem::path& directory);

/// @}

}  // namespace stokesbook::study
