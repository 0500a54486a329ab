#pragma once

#include <chrono>

#include "record/run_data.hpp"

namespace stokesbook {

/// Shows the progress of a run: one line that is rewritten on a terminal, and a line every few
/// seconds elsewhere.
class Progress {
 public:
  /// @param  t_start  time at which this process starts or resumes the run
  /// @param  t_final  end of the run
  /// @param  quiet    true: nothing is printed
  Progress(double t_start, double t_final, bool quiet);

  /// Shows a step, unless the last output is too recent.
  void step(const StepInfo& info);

  /// Ends the line.
  void finish();

 private:
  double t_start_, t_final_;
  bool quiet_, terminal_;
  bool open_line_ = false;
  std::chrono::steady_clock::time_point start_, last_print_;
};

}  // namespace stokesbook
