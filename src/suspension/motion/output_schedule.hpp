#pragma once

#include <optional>
#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The times at which a run writes, reverses its flow, and ends.
///
/// Steps end at reversals and at the end of the run. They also end at written times, unless the
/// stepping method interpolates within its steps as accurately as it steps.
class OutputSchedule {
 public:
  /// Takes the times of a scene.
  ///
  /// @param  scene  with its [time], or without: then the run ends at t = 0
  explicit OutputSchedule(const Scene& scene);

  /// Returns the end of the run.
  /// @return time.t_final
  double t_final() const { return t_final_; }

  /// Returns the flow amplitude from a time on.
  ///
  /// @param  t  time
  /// @return    1, or -1 after an odd number of reversals
  double amplitude_at(double t) const;

  /// Returns whether the flow reverses at a time.
  ///
  /// @param  t  time
  /// @return    true for each time of flow.reverse_at
  bool is_reversal(double t) const;

  /// Returns whether a frame is written at a time that a step ends at.
  ///
  /// @param  t  time
  /// @return    true at multiples of output.dt_write, at the end, and always where every step is
  ///            written
  bool is_written(double t) const;

  /// Returns the first written time after a time.
  ///
  /// @param  t  time
  /// @return    a multiple of output.dt_write; infinite where every step is written
  double next_written(double t) const;

  /// Returns the time that the next step must not pass.
  ///
  /// @param  t  start of the step
  /// @return    the first of end, next reversal and, without interpolation, next written time
  double next_event(double t) const;

 private:
  double t_final_;
  std::optional<double> dt_write_;
  std::vector<double> reverse_at_;
  bool interpolates_;
  double rounding_;  // of written times
};

/// @}

}  // namespace stokesbook
