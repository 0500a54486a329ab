#pragma once

#include "record/run_data.hpp"
#include "scene/scene.hpp"

namespace stokesbook::test {

/// Describes a curve in the plane by its formula.
struct PlacedShape {
  Shape shape;  ///< a circle, an ellipse, a star or a superellipse
  Complex position{};
  double orientation = 0.0;
  bool encloses = false;  ///< whether the curve encloses the fluid and all other curves
};

/// Returns the least distance of two curves through the fluid, computed only from the formulas of
/// the curves. The function takes the closest pairs of sampled points and refines each pair by
/// Newton's method for |x_a(s) - x_b(t)|^2. The function and the geometry that it checks have no
/// code in common.
///
/// @return  the distance; 0 if the curves cross; minus the distance if one curve lies on the wrong
///          side of the other
double exact_gap(const PlacedShape& a, const PlacedShape& b, int samples = 256);

/// Returns the shapes of a scene's bodies and walls at their positions in a frame, bodies first.
std::vector<PlacedShape> placed_shapes(const Scene& scene, const Frame& frame);

/// Returns the least gap of all pairs, or the limit if no gap is smaller. Pairs whose bounding
/// circles are farther apart than the limit are skipped.
double least_exact_gap(const std::vector<PlacedShape>& shapes, double limit, int samples = 256);

/// Returns the least gap in all frames of a run, or the limit if no gap is smaller.
double least_exact_gap(const Scene& scene, const std::vector<Frame>& frames, double limit);

}  // namespace stokesbook::test
