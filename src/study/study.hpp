#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "study/check.hpp"

namespace stokesbook::study {

/// The size of a study.
enum class Size {
  quick,  ///< enough for nearly every claim; for tests and for a build of the docs
  full    ///< more points, finer and harder ones, and lines that take long
};

/// Measures one line of a figure, ascending in x.
using Measure = std::function<std::vector<Measurement>(Size)>;

/// A control: the same measurements with a planted defect. A check that accepts it is worthless.
struct Control {
  std::string defect;  ///< description of the defect
  Measure measure;     ///< the defective method
};

/// A method in an experiment: a line of its figure and a column of its table.
struct Line {
  std::string key;                      ///< in aliases: letters, digits, underscores
  std::string label;                    ///< in tables and legends
  Measure measure;                      ///< the method
  std::optional<Claim> claim = {};      ///< none: the line is for comparison
  std::optional<Control> control = {};  ///< one for each claim
  Size least = Size::quick;             ///< full: the quick size leaves this line out
};

/// The axes on which an experiment's errors are straight lines.
enum class Axes {
  log_log,   ///< algebraic laws
  semi_log,  ///< geometric laws
  no_law,    ///< other errors over a linear x: no orders, no rates
  nominal,   ///< errors of cases with whole numbers x: no joined points, but cells of a heat map
};

/// An experiment: several lines over the same varied quantity.
struct Experiment {
  std::string key;              ///< in files and aliases: letters, digits, underscores
  std::string title;            ///< heading of table and figure
  std::string x;                ///< the varied quantity, with its letter last: "nodes N"
  std::string error;            ///< norm, and the scale of a relative error
  Axes axes = Axes::log_log;    ///< axes of the figure; the table has orders, rates or neither
  std::vector<Line> lines;      ///< one for each method
  bool work_precision = false;  ///< true: also draws errors against each measured cost
  std::string operation = {};   ///< the counted operation: "kernel evaluations"
};

/// Restricts all lines of an experiment to the full size.
Experiment left_to_full(Experiment experiment);

/// The study of one method, with all claims of its chapter.
struct Study {
  std::string number;                   ///< number of the chapter, "02"
  std::string name;                     ///< name of the method, "double_layer"
  std::string title;                    ///< title of the page
  std::vector<Experiment> experiments;  ///< in the order of the page
};

/// Results of a control.
struct ControlResult {
  std::vector<Measurement> measurements;  ///< measurements of the defective method
  Verdict verdict;                        ///< verdict of the same check

  /// Returns whether the check has found the defect; false also if the control was inconclusive.
  bool is_rejected() const { return verdict.outcome == Outcome::fails; }
};

/// Results of a line.
struct LineResult {
  Line line;                                   ///< the line
  std::vector<Measurement> measurements = {};  ///< ascending in x
  std::optional<Verdict> verdict = {};  ///< verdict of its claim; none if the line is left out
  std::optional<ControlResult> control = {};  ///< result of its control

  /// Returns whether the claim holds and its control was rejected; true also if the line has no
  /// claim, or if this size leaves the line out.
  bool holds() const;
};

/// Results of an experiment.
struct ExperimentResult {
  Experiment experiment;          ///< the experiment
  std::vector<LineResult> lines;  ///< in its order
};

/// A kind of cost, with its name on axes and in tables.
struct CostMeasure {
  std::string name;            ///< name with its unit
  double Measurement::*value;  ///< member of Measurement with this cost
};

/// Lists the costs that at least one line of an experiment has measured: unknowns, operations,
/// whose name is Experiment::operation, and seconds.
std::vector<CostMeasure> measured_costs(const ExperimentResult& result);

/// Results of a study.
struct StudyResult {
  std::string number;                         ///< number of the chapter, "02"
  std::string name;                           ///< name of the method, "double_layer"
  std::string title;                          ///< title of the page
  std::vector<ExperimentResult> experiments;  ///< in the order of the page

  /// Returns whether all claims hold and all controls were rejected; false also if a check was
  /// inconclusive.
  bool holds() const;
};

/// Runs a study and checks its claims. The stream shows the verdicts, one line for each claim.
///
/// @throws std::logic_error before any measurement, when a claim lacks its control, or when keys or
///                          ids are not unique or not fit for file names; later, when a line counts
///                          operations and Experiment::operation is empty
StudyResult run(const Study& study, Size size, std::ostream& progress);

}  // namespace stokesbook::study
