#pragma once

#include <chrono>

#include "record/run_data.hpp"

namespace stokesbook {

/// Tells how a run is doing: one line rewritten on a terminal, a line every few seconds elsewhere.
class Progress {
 public:
  /// @param  t_start  time at which this process takes up the run
  /// @param  t_final  time at which it ends
  /// @param  quiet    whether to say nothing
  Progress(double t_start, double t_final, bool quiet);

  /// Takes note of a step.
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
