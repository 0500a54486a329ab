#pragma once

#include <vector>

#include "analysis/run.hpp"
#include "record/run_data.hpp"
#include "statistics/measurement.hpp"
#include "statistics/region.hpp"

namespace stokesbook {

/// The bodies of a run at its written times.
struct BodyFrames {
  std::vector<double> t;                       ///< written times
  std::vector<std::vector<BodyState>> bodies;  ///< for each time, in the scene's order; no loads
  /// For each time and body, by body_stresslet(), force; empty unless the run has `nodes.csv`.
  std::vector<std::vector<Complex>> stresslets = {};
};

/// Reads the bodies of a run at the written times of an interval.
/// @throws RecordError when no time is in the interval, or a table is damaged
BodyFrames read_frames(const Run& run, double from, double to);

/// Measures the pair correlation g(r) of the bodies' positions.
///
/// The number of pairs with a distance in a bin is divided by the number for as many independent
/// points that are uniform in the region. Pairs near the edge of the region have fewer partners in
/// both numbers, so that g = 1 for uniform points at every distance and in every region. In a
/// region between walls, these points keep a clearance from the walls: the least distance of a
/// body's boundary from its position. In a periodic cell there is no region: all images of each
/// other body count, and a body's own images, which form the lattice, do not.
/// @param  longest  end of the last bin, length
/// @par Cost        O(N^2) per written time, and 1.2e7 distances
Measurement pair_correlation(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                             double longest, int bins);

/// Measures the mean number of other bodies, and of walls, whose gap to a body is less than h: the
/// coordination number as a function of h, whose increments are the distribution of the gaps.
///
/// The values of h are powers of ten, from 1e-4 to 1 mean radii, four in each decade. Walls are
/// left out unless walls_stay(). In a periodic cell, images count, also those of the body itself.
Measurement neighbours(const Scene& scene, const BodyFrames& frames);

/// Measures the distribution of the directions of long_axis() from 0 to pi, one per radian. Returns
/// no bins if no body has a long axis.
Measurement orientations(const Scene& scene, const BodyFrames& frames, int bins);

/// Computes the nematic order of the long axes at each time, \f$ |\langle e^{2i\theta}\rangle| \f$:
/// 1 for parallel axes, of the size \f$ 1/\sqrt N \f$ for N independent ones; nan without long
/// axes.
std::vector<double> nematic_order(const Scene& scene, const BodyFrames& frames);

/// The variable of a profile.
enum class Across {
  x,      ///< the coordinate x
  y,      ///< the coordinate y
  radius  ///< the distance from the middle of the region's box
};

/// Measures profiles across the region: the part of the area that bodies cover, and the mean
/// velocity of the bodies in it, along x and y, or along the radius about the middle of the
/// region's box and the azimuth.
///
/// If the frames have stresslets, the profiles include the particle stress: each bin's part of the
/// stresslets of all bodies over its area, where the stresslet of a body is spread evenly over the
/// area of the body.
/// The components are s_11 and s_12, or s_rr and s_rt; s_22 = -s_11. Summed over all bins, stress
/// times area is the sum of the stresslets (07.16).
///
/// Bodies are integrated by a rule with 32 points from the position to each of 128 boundary points,
/// and the region by 40000 uniform points: narrow bins count few of these points.
Measurement profile(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                    Across across, int bins);

}  // namespace stokesbook
