#include "near_singular/near_correction.hpp"

#include <algorithm>
#include <map>

#include "near_singular/near_test.hpp"

namespace stokesbook {

using Eigen::Index;

NearCorrection::NearCorrection(std::vector<PlacedCauchyCurve> curves, const ComplexVector& targets,
                               Targets kind, double tolerance)
    : curves_(std::move(curves)), near_(curves_.size()), target_count_(targets.size()) {
  offsets_.push_back(0);
  for (const PlacedCauchyCurve& curve : curves_) {
    offsets_.push_back(offsets_.back() + curve.reference->curve().size());
  }
  const auto count = static_cast<Index>(curves_.size());
#pragma omp parallel for schedule(dynamic)
  for (Index k = 0; k < count; ++k) {
    const auto source = static_cast<std::size_t>(k);
    near_[source] = find_targets(source, targets, kind, tolerance);
  }
  std::map<const CauchyCurve*, std::size_t> group_of;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    if (near_[k].index.empty()) continue;
    const auto [entry, is_new] = group_of.try_emplace(curves_[k].reference.get(), groups_.size());
    if (is_new) groups_.emplace_back();
    groups_[entry->second].push_back(k);
  }
}

NearCorrection::NearTargets NearCorrection::find_targets(std::size_t source,
                                                         const ComplexVector& targets, Targets kind,
                                                         double tolerance) const {
  const PlacedCauchyCurve& placed = curves_[source];
  const Curve& curve = placed.reference->curve();
  const Complex turn = std::polar(1.0, -placed.orientation);
  const double reach = bounding_radius(curve, 0.0) + near_reach(curve, tolerance);
  NearTargets near;
  std::vector<Complex> local;
  for (Index i = 0; i < targets.size(); ++i) {
    if (kind == Targets::own_nodes && i >= offsets_[source] && i < offsets_[source + 1]) continue;
    const Complex target = (targets[i] - placed.position) * turn;
    if (std::abs(target) < reach && is_near(curve, target, tolerance)) {
      near.index.push_back(i);
      local.push_back(target);
    }
  }
  near.local = Eigen::Map<const ComplexVector>(local.data(), static_cast<Index>(local.size()));
  return near;
}

ComplexVector NearCorrection::operator()(const ComplexVector& density) const {
  std::vector<ComplexVector> corrections(curves_.size());
  for (const std::vector<std::size_t>& group : groups_) {
    const CauchyCurve& reference = *curves_[group.front()].reference;
    const Index n = reference.curve().size();
    const auto columns = static_cast<Index>(group.size());
    Eigen::MatrixXcd densities(n, columns);
    for (Index c = 0; c < columns; ++c) {
      const std::size_t k = group[static_cast<std::size_t>(c)];
      densities.col(c) = std::polar(1.0, -curves_[k].orientation) * density.segment(offsets_[k], n);
    }
    const CauchyData data = reference.data(densities);
#pragma omp parallel for schedule(dynamic)
    for (Index c = 0; c < columns; ++c) {
      const std::size_t k = group[static_cast<std::size_t>(c)];
      const ComplexVector& targets = near_[k].local;
      ComplexVector correction = -reference.trapezoid_velocity(densities.col(c), targets);
      for (Index i = 0; i < targets.size(); ++i) {
        correction[i] += reference.velocity(data, c, targets[i]);
      }
      corrections[k] = std::polar(1.0, curves_[k].orientation) * correction;
    }
  }
  // In the curves' order, so that the sum does not depend on the threads.
  ComplexVector velocity = ComplexVector::Zero(target_count_);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    for (std::size_t i = 0; i < near_[k].index.size(); ++i) {
      velocity[near_[k].index[i]] += corrections[k][static_cast<Index>(i)];
    }
  }
  return velocity;
}

}  // namespace stokesbook
