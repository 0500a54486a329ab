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
  quick,  ///< enough for nearly every claim: what tests and a build of the docs run
  full    ///< more points, finer and harder ones, and the lines that take long
};

/// Measures one line of a figure, ascending in x.
using Measure = std::function<std::vector<Measurement>(Size)>;

/// The same experiment with a planted defect; a check that accepts it checks nothing.
struct Control {
  std::string defect;  ///< what is wrong, for people
  Measure measure;     ///< the defective method
};

/// One method in an experiment: a line of its figure and a column of its table.
struct Line {
  std::string key;                      ///< of aliases: letters, digits, underscores
  std::string label;                    ///< for people
  Measure measure;                      ///< the method
  std::optional<Claim> claim = {};      ///< none: shown for comparison
  std::optional<Control> control = {};  ///< one for each claim
  Size least = Size::quick;             ///< full: the quick size leaves this line out
};

/// The axes on which an experiment's errors are straight lines.
enum class Axes {
  log_log,   ///< algebraic laws
  semi_log,  ///< geometric laws
  nominal,   ///< what follows no law, as cases by their number do: no orders, no rates
};

/// Several lines over the same quantity.
struct Experiment {
  std::string key;              ///< of files and aliases: letters, digits, underscores
  std::string title;            ///< heading of table and figure
  std::string x;                ///< what is varied, with its letter last: "nodes N"
  std::string error;            ///< norm, and what the error is relative to
  Axes axes = Axes::log_log;    ///< of the figure; the table has orders, rates or neither
  std::vector<Line> lines;      ///< one a method
  bool work_precision = false;  ///< also draw error against each cost that was measured
  std::string operation = {};   ///< what is counted: "kernel evaluations"
};

/// Leaves all lines of an experiment to the full size.
///
/// @param  experiment  of any size
/// @return             the same, which the quick size does not measure
Experiment left_to_full(Experiment experiment);

/// The study of one method: all that its chapter claims.
struct Study {
  std::string number;                   ///< of the chapter, "02"
  std::string name;                     ///< of the method, "double_layer"
  std::string title;                    ///< of the page
  std::vector<Experiment> experiments;  ///< in the order of the page
};

/// A control's measurements, and whether the check rejected them.
struct ControlResult {
  std::vector<Measurement> measurements;  ///< of the defective method
  Verdict verdict;                        ///< of the same check

  /// Tells whether the check has found the defect.
  /// @return  false also when the control was inconclusive
  bool rejected() const { return verdict.outcome == Outcome::fails; }
};

/// What came out of one line.
struct LineResult {
  std::vector<Measurement> measurements;  ///< ascending in x
  std::optional<Verdict> verdict;         ///< of the line's claim; none if this size leaves it out
  std::optional<ControlResult> control;   ///< of the line's control

  /// Tells whether the claim holds and its control was rejected.
  /// @return  true also where nothing is claimed, or this size leaves the line out
  bool holds() const;

  /// Says how the claim fared.
  /// @return  its outcome, with the control if that was not rejected; empty where nothing is claimed
  std::string verdict_text() const;
};

/// A cost by its name on axes and in tables.
struct CostMeasure {
  std::string name;            ///< with its unit
  double Measurement::*value;  ///< where measurements hold it
};

/// Lists the costs that some line of an experiment has measured: unknowns, operations, seconds.
///
/// @param  experiment  whose Experiment::operation names what was counted
/// @param  lines       its results, in order
/// @return             none to three of them
std::vector<CostMeasure> measured_costs(const Experiment& experiment,
                                        const std::vector<LineResult>& lines);

/// What came out of a study; its vectors are those of the study, in the same order.
struct StudyResult {
  Study study;                                       ///< what was run
  Size size = Size::quick;                           ///< how much of it
  std::vector<std::vector<LineResult>> experiments;  ///< lines of experiments

  /// Tells whether all claims hold and all controls were rejected.
  /// @return  false also when one was inconclusive
  bool holds() const;
};

/// Runs a study and checks its claims.
///
/// @param  study     claims and measurements
/// @param  size      how much to do
/// @param  progress  told of each verdict, a line a claim
/// @return           measurements, verdicts and controls
/// @throws std::logic_error before any measurement, when a claim lacks its control, or keys or ids
///                          are not unique or not fit for file names
StudyResult run(const Study& study, Size size, std::ostream& progress);

/// @}

}  // namespace stokesbook::study
