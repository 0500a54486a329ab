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

// Collects the targets that are near one curve.
class Finder {
 public:
  Finder(const PlacedCurve& placed, double tolerance)
      : curve_(placed.curve()),
        position_(placed.position),
        turn_(std::polar(1.0, -placed.orientation)),
        tolerance_(tolerance),
        reach_(bounding_radius(curve_, 0.0) + near_reach(curve_, tolerance)) {}

  // Returns a square outside of which no target is near.
  Rectangle surroundings() const { return square_about(position_, reach_); }

  // Tests the targets first, ..., last - 1.
  void look_at(const ComplexVector& targets, Index first, Index last) {
    for (Index i = first; i < last; ++i) {
      const Complex local = (targets[i] - position_) * turn_;
      if (std::abs(local) < reach_ && is_near(curve_, local, tolerance_)) {
        index_.push_back(i);
        local_.push_back(local);
      }
    }
  }

  NearTargets found() const {
    return {index_,
            Eigen::Map<const ComplexVector>(local_.data(), static_cast<Index>(local_.size()))};
  }

 private:
  const Curve& curve_;
  Complex position_, turn_;
  double tolerance_, reach_;
  std::vector<Index> index_;
  std::vector<Complex> local_;
};

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
                                           double tolerance) {
  const std::vector<Index> runs = runs_of(curves, targets, kind);
  const RectangleIndex index(rectangles_of(targets, runs));
  std::vector<NearTargets> near(curves.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < curves.size(); ++k) {
    Finder finder(curves[k], tolerance);
    for (const std::size_t run : index.meeting(finder.surroundings())) {
      const bool own = kind == Targets::own_nodes && run == k;
      if (!own) finder.look_at(targets, runs[run], runs[run + 1]);
    }
    near[k] = finder.found();
  }
  return near;
}

}  // namespace stokesbook
