#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// The origin of results.
struct Provenance {
  std::string version;   ///< version of the project
  std::string git_hash;  ///< commit of the sources
  std::string compiler;  ///< name and version
  std::string flags;     ///< of the compiler
  std::string machine;   ///< name of the processor
};

/// Returns a study's results as CSV, a line for each measurement, with numbers at full precision.
///
/// The last column distinguishes measurements that the check used, measurements that it left out,
/// and controls.
/// @param  result  of the study
/// @return         CSV with a header line
std::string to_csv(const StudyResult& result);

/// Returns a study's claims, verdicts, controls and measurements as JSON, with their origin.
/// Numbers have full precision; quantities that were not measured are null.
///
/// @param  result      of the study
/// @param  provenance  of this build
/// @return             JSON
std::string to_json(const StudyResult& result, const Provenance& provenance);

/// Returns the numbers of a study as aliases of Doxygen, one line `ALIASES += name="value"` for
/// each: `val_<number>_<experiment>_<line>_<x>` is an error, `val_claim_<id>` the measured number
/// of a claim, and `val_claim_<id>_claimed` the claimed one.
///
/// @param  result  of the study
/// @return         lines of a Doxyfile
std::string to_aliases(const StudyResult& result);

/// Returns all tables and figures of a study as a page of Doxygen, with their origin.
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
/// `..._figure.html`, and `..._work_table.html` and `..._work_figure.html` if the experiment
/// requests these. A line without measurements is left out. If no line of an experiment has
/// measurements, only the table file is written, with a sentence instead of a table.
///
/// @param  result      of the study
/// @param  provenance  of this build
/// @param  directory   an existing directory
/// @throws RecordError when a file cannot be written
void write_report(const StudyResult& result, const Provenance& provenance,
                  const std::filesystem::path& directory);

/// Writes the common files of several studies: `claims.md` for Doxygen, and `index.html`, which
/// shows every table and figure without Doxygen.
///
/// @param  results     results of all studies, in reading order
/// @param  provenance  of this build
/// @param  directory   an existing directory
/// @throws RecordError when a file cannot be written
void write_index(const std::vector<StudyResult>& results, const Provenance& provenance,
                 const std::filesystem::path& directory);

/// @}

}  // namespace stokesbook::study
