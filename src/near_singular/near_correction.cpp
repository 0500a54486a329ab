// Plans and applies the near correction (06.17): a scheme of close evaluation minus the trapezoid
// rule, summed over the curves that are near a target. Corrects pressure, vorticity and strain in
// the same way by the Cauchy scheme (06.16).
#include "near_singular/near_correction.hpp"

#include <map>

#include "double_layer/double_layer.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;

namespace {

// [rows_pay]
// Rows take O(N^2) operations per target once. The factored Cauchy scheme takes O(N^2) operations
// per curve in each of about thirty applications. Therefore rows are cheaper up to a number of
// targets that does not depend on N: 20 to 40 for 64 bodies (./stokes bench), somewhat more for
// fewer bodies, whose rows stay in the cache.
bool rows_pay(const PlacedCurve& placed, Index near_targets) {
  if (std::holds_alternative<std::shared_ptr<const InterpolationCurve>>(placed.scheme)) {
    return true;  // evaluating the scheme costs about m sigma times as much as applying a row
  }
  return near_targets <= 24;
}
// [rows_pay]

ComplexVector turned(const ComplexVector& v, double angle) {
  return std::polar(1.0, angle) * v;
}

const CauchyCurve& cauchy_of(const PlacedCurve& placed) {
  const auto* cauchy = std::get_if<std::shared_ptr<const CauchyCurve>>(&placed.scheme);
  require(cauchy != nullptr,
          "pressure and strain near a curve require the Cauchy scheme, not the "
          "interpolation scheme");
  return **cauchy;
}

// Evaluates Cauchy scheme minus trapezoid rule at the near targets of a curve (06.17), in the frame
// of the plane: a turn of the frame does not change pressure and vorticity, and multiplies the
// complex strain by turn^2.
std::vector<FlowDerivatives> derivative_correction(const PlacedCurve& placed,
                                                   const NearTargets& near,
                                                   const ComplexVector& density) {
  const CauchyCurve& cauchy = cauchy_of(placed);
  const Complex turn = std::polar(1.0, placed.orientation);
  const ComplexVector local_density = std::conj(turn) * density;
  std::vector<FlowDerivatives> flow =
      cauchy.derivatives(cauchy.derivative_data(cauchy.data(local_density)), 0, near.local);
  const std::vector<FlowDerivatives> coarse =
      StressletSum({cauchy.curve()}).derivatives(near.local, local_density);
  for (std::size_t i = 0; i < flow.size(); ++i) {
    flow[i] = {flow[i].pressure - coarse[i].pressure, flow[i].vorticity - coarse[i].vorticity,
               (flow[i].strain - coarse[i].strain) * turn * turn};
  }
  return flow;
}

}  // namespace

NearCorrection::NearCorrection(std::vector<PlacedCurve> curves, const ComplexVector& targets,
                               Targets kind, const NearSettings& settings,
                               const std::vector<Complex>& images)
    : curves_(std::move(curves)),
      offsets_(node_offsets(curves_)),
      near_(find_near_targets(curves_, targets, kind, settings.tolerance, images)),
      target_count_(targets.size()) {
  std::map<CloseScheme, std::size_t> group_of;
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const Index count = near_[k].local.size();
    if (count == 0) continue;
    if (settings.storage == NearStorage::explicit_rows ||
        (settings.storage == NearStorage::automatic && rows_pay(curves_[k], count))) {
      rows_.push_back({k, {}});
      continue;
    }
    const auto [entry, is_new] = group_of.try_emplace(curves_[k].scheme, groups_.size());
    if (is_new) groups_.push_back({{}, StressletSum({curves_[k].curve()})});
    groups_[entry->second].curves.push_back(k);
  }
#pragma omp parallel for schedule(dynamic)
  for (Rows& rows : rows_) {
    // Scheme minus trapezoid rule at the near targets of one curve (06.17)
    const ComplexVector& local = near_[rows.curve].local;
    rows.matrix = std::visit([&](const auto& scheme) { return scheme->velocity_rows(local); },
                             curves_[rows.curve].scheme) -
                  StressletSum({curves_[rows.curve].curve()}).matrix(local);
  }
}

ComplexVector NearCorrection::local_density(const ComplexVector& density, std::size_t curve) const {
  return turned(density.segment(offsets_[curve], offsets_[curve + 1] - offsets_[curve]),
                -curves_[curve].orientation);
}

// Evaluates scheme minus trapezoid rule (06.17) for all curves that share a scheme.
void NearCorrection::evaluate(const Group& group, const ComplexVector& density,
                              std::vector<ComplexVector>& corrections) const {
  const PlacedCurve& first = curves_[group.curves.front()];
  const auto columns = static_cast<Index>(group.curves.size());
  MatrixXcd densities(first.curve().size(), columns);
  for (Index c = 0; c < columns; ++c) {
    densities.col(c) = local_density(density, group.curves[static_cast<std::size_t>(c)]);
  }
  std::visit(
      [&](const auto& scheme) {
        const auto data = scheme->data(densities);
#pragma omp parallel for schedule(dynamic)
        for (Index c = 0; c < columns; ++c) {
          const std::size_t k = group.curves[static_cast<std::size_t>(c)];
          const ComplexVector& targets = near_[k].local;
          corrections[k] =
              scheme->velocity(data, c, targets) - group.trapezoid(targets, densities.col(c));
        }
      },
      first.scheme);
}

ComplexVector NearCorrection::operator()(const ComplexVector& density) const {
  std::vector<ComplexVector> corrections(curves_.size());  // in the curves' frames
  for (const Group& group : groups_) evaluate(group, density, corrections);
#pragma omp parallel for schedule(dynamic)
  for (const Rows& rows : rows_) {
    corrections[rows.curve] =
        deinterleaved(rows.matrix * interleaved(local_density(density, rows.curve)));
  }
  // The corrections are added in the order of the curves, so that the sum does not depend on the
  // number of threads.
  ComplexVector velocity = ComplexVector::Zero(target_count_);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const ComplexVector correction = turned(corrections[k], curves_[k].orientation);
    for (Index i = 0; i < correction.size(); ++i) {
      velocity[near_[k].index[static_cast<std::size_t>(i)]] += correction[i];
    }
  }
  return velocity;
}

Index NearCorrection::pair_count() const {
  Index count = 0;
  for (const NearTargets& near : near_) count += near.local.size();
  return count;
}

std::vector<FlowDerivatives> near_derivative_corrections(const std::vector<PlacedCurve>& curves,
                                                         const ComplexVector& density,
                                                         const ComplexVector& targets,
                                                         double tolerance,
                                                         const std::vector<Complex>& images) {
  for (const PlacedCurve& curve : curves) cauchy_of(curve);  // throws outside the parallel region
  const std::vector<Index> offsets = node_offsets(curves);
  const std::vector<NearTargets> near =
      find_near_targets(curves, targets, Targets::points, tolerance, images);
  std::vector<std::vector<FlowDerivatives>> corrections(curves.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (near[k].index.empty()) continue;
    corrections[k] = derivative_correction(
        curves[k], near[k], density.segment(offsets[k], offsets[k + 1] - offsets[k]));
  }
  // The corrections are added in the order of the curves, like those of velocities.
  std::vector<FlowDerivatives> sum(static_cast<std::size_t>(targets.size()));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (std::size_t i = 0; i < corrections[k].size(); ++i) {
      sum[static_cast<std::size_t>(near[k].index[i])] += corrections[k][i];
    }
  }
  return sum;
}

}  // namespace stokesbook
