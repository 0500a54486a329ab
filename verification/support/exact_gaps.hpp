#pragma once

#include "record/run_data.hpp"
#include "scene/scene.hpp"

namespace stokesbook::test {

/// A curve in the plane by its formula.
struct PlacedShape {
  Shape shape;  ///< a circle, an ellipse, a star or a superellipse
  Complex position{};
  double orientation = 0.0;
  bool encloses = false;  ///< the fluid, and all other curves
};

/// Least distance of two curves through the fluid, from their formulas alone: sampled pairs of
/// points, the closest ones refined by Newton's method for |x_a(s) - x_b(t)|^2. Shares no code with
/// the geometry that is checked by it.
///
/// @return  0 where they cross, minus the distance where one lies on the wrong side of the other
double exact_gap(const PlacedShape& a, const PlacedShape& b, int samples = 256);

/// Places a scene's bodies and walls as a frame has them, bodies first.
std::vector<PlacedShape> placed_shapes(const Scene& scene, const Frame& frame);

/// Least gap of all pairs that are nearer than a limit by their bounding circles, or the limit.
double least_exact_gap(const std::vector<PlacedShape>& shapes, double limit, int samples = 256);

/// Least gap of all frames of a run, or the limit.
double least_exact_gap(const Scene& scene, const std::vector<Frame>& frames, double limit);

}  // namespace stokesbook::test
