// Finds the targets near each curve: an R-tree of rectangles excludes most targets, and the near
// test (06.5) decides about the others.
#include "near_singular/near_targets.hpp"

#include <algorithm>

#include "near_singular/near_field.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Divides the targets into runs, whose bounding rectangles are searched: the nodes of one curve, or
// 32 consecutive points, which are neighbours if they lie on a grid. Returns the beginning of each
// run, and the end of the last run.
std::vector<Index> runs_of(const std::vector<PlacedCurve>& curves, const ComplexVector& targets,
                           Targets kind) {
  if (kind == Targets::own_nodes) return node_offsets(curves);
  constexpr Index points_in_a_run = 32;
  std::vector<Index> runs{0};
  while (runs.back() < targets.size()) {
    runs.push_back(std::min(runs.back() + points_in_a_run, targets.size()));
  }
  return runs;
}

std::vector<Rectangle> rectangles_of(const ComplexVector& targets, const std::vector<Index>& runs) {
  std::vector<Rectangle> rectangles;
  for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
    rectangles.push_back(bounding_rectangle(targets.segment(runs[k], runs[k + 1] - runs[k])));
  }
  return rectangles;
}

}  // namespace

std::vector<Index> node_offsets(const std::vector<PlacedCurve>& curves) {
  std::vector<Index> offsets{0};
  for (const PlacedCurve& placed : curves) {
    offsets.push_back(offsets.back() + placed.curve().size());
  }
  return offsets;
}

std::vector<NearTargets> find_near_targets(const std::vector<PlacedCurve>& curves,
                                           const ComplexVector& targets, Targets kind,
                                           double tolerance, const std::vector<Complex>& images) {
  const std::vector<Index> runs = runs_of(curves, targets, kind);
  const RectangleIndex index(rectangles_of(targets, runs));
  std::vector<NearTargets> near(curves.size());
  std::vector<Complex> shifts{0.0};
  shifts.insert(shifts.end(), images.begin(), images.end());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Curve& curve = curves[k].curve();
    const Complex turn = std::polar(1.0, -curves[k].orientation);
    // No target is near outside of the circle with this radius.
    const double reach = bounding_radius(curve, 0.0) + near_reach(curve, tolerance);
    std::vector<Complex> near_points;
    for (const Complex shift : shifts) {
      const Complex position = curves[k].position + shift;
      for (const std::size_t run : index.meeting(square_about(position, reach))) {
        if (kind == Targets::own_nodes && run == k && shift == 0.0) continue;
        for (Index i = runs[run]; i < runs[run + 1]; ++i) {
          const Complex local = (targets[i] - position) * turn;
          if (std::abs(local) >= reach || !is_near(curve, local, tolerance)) continue;
          near[k].index.push_back(i);
          near_points.push_back(local);
        }
      }
    }
    near[k].local = ComplexVector::Map(near_points.data(), std::ssize(near_points));
  }
  return near;
}

}  // namespace stokesbook
