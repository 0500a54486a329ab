#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "record/run_data.hpp"
#include "record/run_info.hpp"
#include "suspension/solver/matrices.hpp"

namespace stokesbook {

/// Shows the progress of a run: one line that is rewritten on a terminal, and a line every few
/// seconds elsewhere.
class Progress {
 public:
  /// @param  t_start  time at which this process starts or resumes the run
  Progress(double t_start, double t_final, bool quiet);

  /// Shows a step, unless the last output is too recent.
  void step(const StepInfo& info);

  /// Ends the line.
  void finish();

 private:
  double t_start_, t_final_;
  bool quiet_, terminal_;
  bool open_line_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_print_ = start_;
};

/// Prints the title of a scene and the lines of its plan.
void print_plan(const std::string& title, const std::vector<std::string>& plan);

/// Prints the velocities of all bodies with 15 digits.
void print_motions(const Frame& frame);

/// Prints the mean stress over a periodic cell and what follows from it, the dissipation twice.
void print_cell(const Rheology& rheology);

/// Prints how far resistance and mobility matrix are from symmetric, and inverse to each other.
void print_matrix_errors(const MatrixErrors& errors);

/// Prints cost, error estimates and contact forces of a run that has ended.
void print_report(const RunInfo& info, const std::filesystem::path& out);

/// Warns of error estimates above the tolerance: of fields, and of velocities with contact forces
/// or lagged coupling. In all other cases, such an estimate of velocities stops the run.
void warn_of_estimates(const RunResolution& resolution, double tolerance);

}  // namespace stokesbook
