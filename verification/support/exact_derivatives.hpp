#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "double_layer/flow_derivatives.hpp"
#include "support/exact_flows.hpp"

namespace stokesbook::test {

/// Returns pressure / viscosity, vorticity and strain of an exact flow. The viscosity of the flow
/// is 1.
inline FlowDerivatives derivatives_of(const ExactFlow& flow, Complex z) {
  return {flow.pressure(z), flow.vorticity(z), flow.strain(z)};
}

/// Returns the velocity of the linear flow with vorticity w and strain q. The velocity is 0 at the
/// origin.
inline ComplexVector linear_velocity(const FlowDerivatives& linear, const ComplexVector& z) {
  return 0.5 * (imaginary * linear.vorticity * z + linear.strain * z.conjugate());
}

/// Returns the largest error of pressure, vorticity and strain at the points, relative to the
/// largest strain at these points.
///
/// The pressure inside an enclosing wall is known up to a constant, so pressures are compared after
/// the error of the pressure at the first point is subtracted.
inline double derivative_error(const std::vector<FlowDerivatives>& found, const ExactFlow& flow,
                               const ComplexVector& points, Side side) {
  const double datum =
      side == Side::fluid_inside ? found.front().pressure - flow.pressure(points[0]) : 0.0;
  double error = 0.0, size = 0.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const FlowDerivatives& at = found[static_cast<std::size_t>(i)];
    const FlowDerivatives exact = derivatives_of(flow, points[i]);
    error =
        std::max({error, std::abs(at.pressure - datum - exact.pressure),
                  std::abs(at.vorticity - exact.vorticity), std::abs(at.strain - exact.strain)});
    size = std::max(size, std::abs(exact.strain));
  }
  return error / size;
}

}  // namespace stokesbook::test
