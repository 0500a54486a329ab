#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "study/check.hpp"
#include "study/claim.hpp"
#include "study/measurement.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// How much a study does.
enum class Size {
  quick,  ///< enough for every claim: what tests and a build of the docs run
  full    ///< more points, finer and harder ones
};

/// Measures one line of a figure, ascending in x.
using Measure = std::function<std::vector<Measurement>(Size)>;

/// The same experiment with a planted defect; a check that accepts it checks nothing.
struct Control {
  std::string defect;  ///< what is wrong, for people
  Measure measure;
};

/// One method in an experiment: a line of its figure and a column of its table.
struct Line {
  std::string key;    ///< of aliases: letters, digits, underscores
  std::string label;  ///< for people
  Measure measure;
  std::optional<Claim> claim = {};      ///< none: shown for comparison
  std::optional<Control> control = {};  ///< one for each claim
};

/// The axes on which an experiment's errors are straight lines.
enum class Axes {
  log_log,   ///< algebraic laws
  semi_log,  ///< geometric laws
};

/// Several lines over the same quantity.
struct Experiment {
  std::string key;    ///< of files and aliases: letters, digits, underscores
  std::string title;  ///< heading of table and figure
  std::string x;      ///< what is varied, with its letter last: "nodes N"
  std::string error;  ///< norm, and what the error is relative to
  Axes axes = Axes::log_log;
  std::vector<Line> lines;
  bool work_precision = false;  ///< also draw error against each cost that was measured
  std::string operation = {};   ///< what is counted: "kernel evaluations"
};

/// The study of one method: all that its chapter claims.
struct Study {
  std::string number;  ///< of the chapter, "02"
  std::string name;    ///< of the method, "double_layer"
  std::string title;
  std::vector<Experiment> experiments;
};

/// A control's measurements, and whether the check rejected them.
struct ControlResult {
  std::vector<Measurement> measurements;
  Verdict verdict;
  bool rejected() const { return verdict.outcome == Outcome::fails; }
};

/// What came out of one line.
struct LineResult {
  std::vector<Measurement> measurements;
  std::optional<Verdict> verdict;        ///< of the line's claim
  std::optional<ControlResult> control;  ///< of the line's control

  /// Whether there is nothing to hold, or the claim holds and its control was rejected.
  bool holds() const;
};

/// A cost by its name on axes and in tables.
struct CostMeasure {
  std::string name;
  double Measurement::*value;
};

/// Returns the costs that some line of an experiment has measured: unknowns, operations, seconds.
std::vector<CostMeasure> measured_costs(const Experiment& experiment,
                                        const std::vector<LineResult>& lines);

/// What came out of a study; its vectors are those of the study, in the same order.
struct StudyResult {
  Study study;
  Size size = Size::quick;
  std::vector<std::vector<LineResult>> experiments;

  /// Whether all claims hold and all controls were rejected.
  bool holds() const;
};

/// Runs a study and checks its claims.
///
/// @param  study     claims and measurements
/// @param  size      how much to do
/// @param  progress  told of each verdict, a line a claim
/// @throws std::logic_error before any measurement, when a claim lacks its control, or keys or ids
///                          are not unique or not fit for file names
StudyResult run(const Study& study, Size size, std::ostream& progress);

/// @}

}  // namespace stokesbook::study
