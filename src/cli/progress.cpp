// Prints the progress of a run with an estimate of the remaining time.
#include "cli/progress.hpp"

#include <cstdio>

#include <unistd.h>

namespace stokesbook {

using std::chrono::duration;
using std::chrono::steady_clock;

Progress::Progress(double t_start, double t_final, bool quiet)
    : t_start_(t_start),
      t_final_(t_final),
      quiet_(quiet),
      terminal_(isatty(STDOUT_FILENO) != 0),
      start_(steady_clock::now()),
      last_print_(start_) {}

void Progress::step(const StepInfo& info) {
  const auto now = steady_clock::now();
  const bool last = info.t >= t_final_;
  const double pause = terminal_ ? 0.1 : 5.0;
  if (quiet_ || (!last && duration<double>(now - last_print_).count() < pause)) return;
  last_print_ = now;
  const double elapsed = duration<double>(now - start_).count();
  // The remaining time at the mean speed so far.
  const double left = elapsed * (t_final_ - info.t) / (info.t - t_start_);
  std::printf(
      "%st = %.4g of %.4g, dt %.3g, gap %.3g, %d contacts, %d GMRES iterations, %.3g s left%s",
      terminal_ ? "\r\033[K" : "", info.t, t_final_, info.dt, info.min_gap, info.contacts,
      info.gmres_iterations, left, terminal_ ? "" : "\n");
  std::fflush(stdout);
  open_line_ = terminal_;
}

void Progress::finish() {
  if (open_line_) std::printf("\n");
  open_line_ = false;
}

}  // namespace stokesbook
