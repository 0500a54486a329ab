// Compares times of a run with those at which it writes, changes its forcing and ends (chapter 12).
#include "suspension/motion/output_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "suspension/bodies/forcing.hpp"

namespace stokesbook {

namespace {

// Two times that differ by less than this part of dt_write are the same time: a step from a written
// time to an event so near would be nothing but rounding.
constexpr double same_time = 1e-9;

}  // namespace

OutputSchedule::OutputSchedule(const Scene& scene)
    : dt_write_(scene.output.dt_write),
      reversals_(scene.reverse_at),
      events_(forcing_events(scene)) {
  const TimeSettings time = scene.time.value_or(TimeSettings{});
  t_final_ = time.t_final;
  interpolates_ = has_dense_output(time.method);
  rounding_ = interpolates_ ? 0.0 : same_time * dt_write_.value_or(0.0);
}

bool OutputSchedule::is_event(double t) const {
  return std::ranges::binary_search(events_, t);
}

bool OutputSchedule::is_reversal(double t) const {
  return std::ranges::binary_search(reversals_, t);
}

bool OutputSchedule::is_written(double t) const {
  if (!dt_write_ || t >= t_final_) return true;
  // Both sides are compared, not subtracted: a compiler may contract t - nearest to one operation
  // on the product before it is rounded.
  const double nearest = std::round(t / *dt_write_) * *dt_write_;
  return nearest >= t - rounding_ && nearest <= t + rounding_;
}

std::vector<double> OutputSchedule::written_within(double t, double end) const {
  const double before = is_written(end) ? end - same_time * dt_write_.value_or(0.0) : end;
  std::vector<double> times;
  for (double next = next_written(t); next < before; next = next_written(next)) {
    times.push_back(next);
  }
  return times;
}

// Returns the first multiple of output.dt_write after a time; infinite if there is no dt_write.
double OutputSchedule::next_written(double t) const {
  if (!dt_write_) return std::numeric_limits<double>::infinity();
  double k = std::floor(t / *dt_write_);
  while (k * *dt_write_ <= t + rounding_) k += 1.0;
  return k * *dt_write_;
}

double OutputSchedule::next_event(double t) const {
  double event = t_final_;
  const auto next = std::ranges::upper_bound(events_, t);
  if (next != events_.end()) event = std::min(event, *next);
  if (interpolates_) return event;
  const double written = next_written(t);
  return written < event - rounding_ ? written : event;
}

}  // namespace stokesbook
