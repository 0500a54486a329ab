#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "closure/closure.hpp"
#include "scene/scene.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"

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
  std::vector<Load> loads;      ///< load on each body, about its position; of no effect if held
};

/// The data on which the flow of an instant depends, in addition to the scene.
struct Instant {
  /// Poses of the components; in a periodic cell, of their images in the cell.
  Configuration configuration;
  Forcing forcing;                       ///< what drives the flow
  std::optional<PeriodicCell> cell{};    ///< lattice at this time; none: nothing repeats
  std::vector<PathShift> path_shifts{};  ///< of each component; empty without a cell

  /// Returns where the path of component k is, length.
  Complex path_position(std::size_t k) const {
    const Complex position = configuration[k].position;
    return cell ? position + path_shifts[k].vector : position;
  }

  /// Returns the velocity of component k on its path relative to its image, length / time.
  Complex path_velocity(std::size_t k) const {
    return cell ? forcing.flow * path_shifts[k].velocity : Complex{};
  }
};

/// Multiplies flow, motions and loads by a factor.
Forcing scaled(double factor, Forcing forcing);

/// Returns the centroid of the area that a curve encloses, length.
Complex area_centroid(const Curve& curve);

/// Two components that repel each other.
struct RepelledPair {
  Gap gap;        ///< closest points, at which the forces act
  Complex force;  ///< on b, or its image, force / length; -force acts on a
};

/// Finds the repulsion of a scene at an instant: strength exp(-gap / range), along the line through
/// the closest points. Returns no pairs in scenes without repulsion.
///
/// @param  instant  places and lattice; its forcing is not used, here and below
/// @par Cost        that of gaps_within()
std::vector<RepelledPair> repelled_pairs(const Scene& scene, const Discretisation& discretisation,
                                         const Instant& instant);

/// Computes the forcing of a scene at a time.
///
/// @param  discretisation  determines areas and gaps, to the accuracy of the trapezoid rule
/// @par Cost  O(nodes); with repulsion, that of repelled_pairs()
Forcing forcing_at(const Scene& scene, const Discretisation& discretisation, const StepTime& time,
                   const Instant& instant);

/// Returns the integral over time, from 0 to t, of the factor of the flow of a scene.
double flow_time(const Scene& scene, double t);

/// Returns the ascending times > 0 at which the forcing of a scene is not smooth in time.
std::vector<double> forcing_events(const Scene& scene);

/// Returns the shortest period of the forcing of a scene; infinite if nothing oscillates.
double shortest_period(const Scene& scene);

}  // namespace stokesbook
