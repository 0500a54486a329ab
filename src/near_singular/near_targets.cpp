#include "near_singular/near_targets.hpp"

#include "near_singular/near_test.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Appends the targets from first to last - 1 that are near a curve.
class Finder {
 public:
  Finder(const PlacedCurve& placed, double tolerance)
      : curve_(placed.curve()),
        position_(placed.position),
        turn_(std::polar(1.0, -placed.orientation)),
        tolerance_(tolerance),
        reach_(bounding_radius(curve_, 0.0) + near_reach(curve_, tolerance)) {}

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
  const std::vector<Index> offsets = node_offsets(curves);
  std::vector<NearTargets> near(curves.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < curves.size(); ++k) {
    Finder finder(curves[k], tolerance);
    if (kind == Targets::own_nodes) {
      finder.look_at(targets, 0, offsets[k]);
      finder.look_at(targets, offsets[k + 1], targets.size());
    } else {
      finder.look_at(targets, 0, targets.size());
    }
    near[k] = finder.found();
  }
  return near;
}

}  // namespace stokesbook
