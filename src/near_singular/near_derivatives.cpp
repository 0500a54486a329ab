// Evaluates pressure, vorticity and strain of double layers at any distance from their curves: the
// trapezoid sum, corrected (06.17) near the curves by the Cauchy scheme (06.16).
#include "near_singular/near_derivatives.hpp"

#include <stdexcept>

#include "double_layer/stresslet_sum.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

const CauchyCurve& cauchy_of(const PlacedCurve& placed) {
  const auto* cauchy = std::get_if<std::shared_ptr<const CauchyCurve>>(&placed.scheme);
  if (cauchy == nullptr) {
    throw std::invalid_argument(
        "pressure and strain near a curve require the Cauchy scheme, not the interpolation scheme");
  }
  return **cauchy;
}

// Transforms derivatives to a frame that is turned: pressure and vorticity do not change, and the
// complex strain is multiplied by turn^2.
FlowDerivatives turned(const FlowDerivatives& flow, Complex turn) {
  return {flow.pressure, flow.vorticity, flow.strain * turn * turn};
}

FlowDerivatives difference(const FlowDerivatives& a, const FlowDerivatives& b) {
  return {a.pressure - b.pressure, a.vorticity - b.vorticity, a.strain - b.strain};
}

// Evaluates Cauchy scheme minus trapezoid rule at the near targets of a curve (06.17), in the frame
// of the plane.
std::vector<FlowDerivatives> correction(const PlacedCurve& placed, const NearTargets& near,
                                        const ComplexVector& density) {
  const CauchyCurve& cauchy = cauchy_of(placed);
  const Complex turn = std::polar(1.0, placed.orientation);
  const ComplexVector local_density = std::conj(turn) * density;
  std::vector<FlowDerivatives> flow =
      cauchy.derivatives(cauchy.derivative_data(cauchy.data(local_density)), 0, near.local);
  const std::vector<FlowDerivatives> coarse =
      StressletSum({cauchy.curve()}).derivatives(near.local, local_density);
  for (std::size_t i = 0; i < flow.size(); ++i) {
    flow[i] = turned(difference(flow[i], coarse[i]), turn);
  }
  return flow;
}

}  // namespace

std::vector<FlowDerivatives> near_derivative_corrections(const std::vector<PlacedCurve>& curves,
                                                         const ComplexVector& density,
                                                         const ComplexVector& targets,
                                                         double tolerance) {
  for (const PlacedCurve& curve : curves) cauchy_of(curve);  // throws outside the parallel region
  const std::vector<Index> offsets = node_offsets(curves);
  const std::vector<NearTargets> near =
      find_near_targets(curves, targets, Targets::points, tolerance);
  std::vector<std::vector<FlowDerivatives>> corrections(curves.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < curves.size(); ++k) {
    if (near[k].index.empty()) continue;
    corrections[k] =
        correction(curves[k], near[k], density.segment(offsets[k], offsets[k + 1] - offsets[k]));
  }
  // The corrections are added in the order of the curves, so that the sum does not depend on the
  // number of threads.
  std::vector<FlowDerivatives> sum(static_cast<std::size_t>(targets.size()));
  for (std::size_t k = 0; k < curves.size(); ++k) {
    for (std::size_t i = 0; i < corrections[k].size(); ++i) {
      sum[static_cast<std::size_t>(near[k].index[i])] += corrections[k][i];
    }
  }
  return sum;
}

std::vector<FlowDerivatives> double_layer_derivatives(const std::vector<PlacedCurve>& curves,
                                                      const ComplexVector& density,
                                                      const ComplexVector& targets,
                                                      double tolerance) {
  std::vector<FlowDerivatives> flow =
      near_derivative_corrections(curves, density, targets, tolerance);
  std::vector<Curve> placed;
  for (const PlacedCurve& curve : curves) {
    placed.push_back(place(curve.curve(), curve.position, curve.orientation));
  }
  const std::vector<FlowDerivatives> plain = StressletSum(placed).derivatives(targets, density);
  for (std::size_t i = 0; i < flow.size(); ++i) flow[i] += plain[i];
  return flow;
}

}  // namespace stokesbook
