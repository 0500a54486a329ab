#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/run.hpp"
#include "analysis/settings.hpp"

namespace stokesbook {

/// The result and the cost of one run.
struct Outcome {
  std::optional<Run> run{};  ///< none if the run did not reach its end
  double seconds = 0.0;      ///< CPU time
  std::vector<int> nodes{};  ///< largest number of nodes of each body, then of each wall
  std::string failure{};     ///< reason if there is no run
};

/// Runs a scene for at most some seconds of CPU time.
using RunScene = std::function<Outcome(const Scene& scene, double most_seconds)>;

/// A wish for accurate settings.
struct Request {
  double accuracy = 1e-3;  ///< largest error allowed, in the units of compare()
  std::string quantity{};  ///< quantity of compare() whose error counts; empty: the trajectory
  double budget = 600.0;   ///< CPU time of all runs, seconds
};

/// One run of a search. Its errors, the largest of all written times, are nan if the run failed.
struct Trial {
  std::string line;          ///< name of what is varied
  Settings settings{};       ///< settings of the run
  double seconds = 0.0;      ///< CPU time
  std::vector<int> nodes{};  ///< as in Outcome
  std::size_t steps = 0;     ///< number of time steps
  double products = 0.0;     ///< applications of the operator
  double trajectory = 0.0;   ///< error of positions and angles
  double rheology = 0.0;     ///< error of the quantities of the whole suspension
  double error = 0.0;        ///< error that counts, see Request
};

/// The runs of a search, and what they show.
struct Search {
  std::vector<Trial> trials{};   ///< in the order of the runs
  double reference_error = 0.0;  ///< difference of the last two references
  double seconds = 0.0;          ///< CPU time of all runs
  /// Cheapest trial with the accuracy: in CPU time, or in products where times hardly differ. Among
  /// equally cheap ones, a trial whose error is not below a third of the accuracy.
  std::optional<std::size_t> best{};
  std::string failure{};  ///< reason if there is no such trial
};

/// Searches for the cheapest settings with which the run of a scene has an accuracy.
///
/// 1. Reference: dormand_prince54, or heun with contact, with tolerances that fall by a factor of
///    ten until two runs differ by at most a twentieth of the accuracy.
/// 2. Steps: for each method, the step varies until the error is between a third of the accuracy
///    and the accuracy, while solver.tolerance is a hundredth of the accuracy. The search leaves a
///    method if its next run is expected to cost twice as much as the best run so far.
/// 3. Solver: with smaller steps of the best method, solver.tolerance grows by factors of ten until
///    the error exceeds a third of the accuracy.
/// 4. Nodes: given numbers, those of the scene and the largest that the solver has chosen.
/// 5. The steps are adjusted once more to the settings of 3 and 4.
/// @param  scene  a scene with [time], without fills; if it writes every step, fifty times are
///                compared
/// @throws SceneError when the scene does not define the quantity, and as with_tables_only() does
/// @par Cost  at most the budget, of which the references take at most half
Search search(Scene scene, const Request& request, const RunScene& run);

/// Writes the trials as a table, cheapest first.
std::string to_text(const Search& search);

/// Draws the work-precision diagrams of a search as SVG: each error over each cost.
/// @return  SVG documents by file name, such as `trajectory_over_seconds.svg`
std::map<std::string, std::string> draw(const Search& search, const Request& request);

}  // namespace stokesbook
