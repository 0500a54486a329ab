#pragma once

#include <vector>

#include "closure/closure.hpp"
#include "scene/scene.hpp"
#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

/// A time within a step of a run.
///
/// The forcing of a step is smooth: an amplitude that jumps at the end of a step has the value
/// before the jump there. The step that begins at the jump has the value after it.
struct StepTime {
  double t = 0.0;      ///< the time
  double begin = 0.0;  ///< the time at which the step begins, <= t
};

/// All that drives the flow of an instant.
struct Forcing {
  double flow = 1.0;            ///< factor of the background flow
  std::vector<double> motions;  ///< factor of the prescribed motion of each component
  std::vector<Load> loads;      ///< load on each body, about its position; zero on held bodies
};

/// The data on which the flow of an instant depends, in addition to the scene.
struct Instant {
  Configuration configuration;  ///< poses of the components
  Forcing forcing;              ///< what drives the flow
};

/// Multiplies flow, motions and loads by a factor.
Forcing scaled(double factor, Forcing forcing);

/// Computes the forcing of a scene at a time.
Forcing forcing_at(const Scene& scene, const StepTime& time);

/// Returns the ascending times > 0 at which the forcing of a scene is not smooth in time.
std::vector<double> forcing_events(const Scene& scene);

}  // namespace stokesbook
