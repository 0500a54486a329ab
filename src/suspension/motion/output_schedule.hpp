#pragma once

#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// The times at which a run writes, at which its forcing is not smooth, and at which it ends.
///
/// Steps end at forcing_events() and at the end of the run. They also end at written times, unless
/// the stepping method interpolates within its steps as accurately as it steps.
class OutputSchedule {
 public:
  /// Takes the times of a scene. Without [time] the run ends at t = 0.
  explicit OutputSchedule(const Scene& scene);

  double t_final() const { return t_final_; }  ///< returns the end of the run

  /// Returns whether the forcing is not smooth at a time: one of forcing_events().
  bool is_event(double t) const;

  /// Returns whether the scene reverses its forcing at a time.
  bool is_reversal(double t) const;

  /// Returns whether a frame is written at a time that a step ends at: at multiples of
  /// output.dt_write and at the end; at all times if there is no dt_write.
  bool is_written(double t) const;

  /// Returns the multiples of output.dt_write after a time and before the end of a step; none that
  /// differs from the end by rounding alone, if a frame is written there.
  std::vector<double> written_within(double t, double end) const;

  /// Returns the time that a step from t must not pass: the first of end, next event and,
  /// without interpolation, next written time.
  double next_event(double t) const;

  /// Returns whether a step from t, and with it all later steps, depends on the end of the run: no
  /// event precedes the end.
  bool depends_on_end(double t) const { return next_event(t) >= t_final_; }

 private:
  double next_written(double t) const;

  double t_final_;
  std::optional<double> dt_write_;
  std::vector<double> reversals_, events_;  // ascending
  bool interpolates_;
  double rounding_;  // rounding error of written times
};

}  // namespace stokesbook
