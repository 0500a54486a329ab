#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "near_singular/closest_points.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// Two components, and the points at which they are closest to each other.
struct Gap {
  std::size_t a = 0,     ///< one component
      b = 0;             ///< the other component, b > a; in a periodic cell, b = a for own images
  ClosestPoints points;  ///< point_a on a, point_b on b or its image
  Complex shift{};       ///< vector from b to the image of b at the gap, length; else 0
};

/// Finds the gaps that may require nodes: the gaps of all pairs whose bounding circles are nearer
/// to each other than the near_reach() of one of the two curves, and the gap of the closest pair.
///
/// @param  tolerance  of velocities, > 0; sets the reach
/// @param  cell       all components repeat with its lattice, and the configuration is that of
///                    their images in the cell; none: nothing repeats
/// @return            in ascending order of the gap; empty for a single component without a cell
/// @par Cost          N_a N_b distances per close pair
std::vector<Gap> find_gaps(const Configuration& configuration, const Discretisation& discretisation,
                           double tolerance, const std::optional<PeriodicCell>& cell = {});

/// Finds the gaps of all pairs whose bounding circles are nearer to each other than a distance.
///
/// @param  cell  as for find_gaps()
/// @return       in ascending order of the pairs
/// @par Cost     N_a N_b distances per close pair
std::vector<Gap> gaps_within(const Configuration& configuration,
                             const Discretisation& discretisation, double distance,
                             const std::optional<PeriodicCell>& cell = {});

}  // namespace stokesbook
