// Samples shapes at equidistant or graded nodes, with derivatives by the chain rule through the map
// t(s) of (01.11).
#include <stdexcept>
#include <string>

#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/grading.hpp"
#include "trapezoid/parametrisation.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// x(t(s)), dx/ds = x' t' and d2x/ds2 = x'' t'^2 + x' t'', t' and t'' being derivatives in s.
Curve sample_at(const std::vector<GradedParameter>& parameters, const Shape& shape, Side side) {
  const Parametrisation point = parametrisation(shape);
  const auto n = static_cast<Index>(parameters.size());
  Curve curve{ComplexVector(n), ComplexVector(n), ComplexVector(n), side};
  for (Index j = 0; j < n; ++j) {
    const auto [t, dt, ddt] = parameters[static_cast<std::size_t>(j)];
    const auto [x, first, second] = point(t);
    curve.x[j] = x;
    curve.dx[j] = first * dt;
    curve.ddx[j] = second * (dt * dt) + first * ddt;
  }
  return curve;
}

// Samples a NodalCurve at equidistant parameters, by fast Fourier transforms.
Curve sample_equidistantly(const NodalCurve& shape, Index n, Side side) {
  const ComplexVector x = resample(counter_clockwise(shape), n);
  const ComplexVector dx = differentiate(x);
  return {x, dx, differentiate(dx), side};
}

}  // namespace

Curve resample(const Curve& curve, Index m) {
  return {resample(curve.x, m), resample(curve.dx, m), resample(curve.ddx, m), curve.side};
}

Curve sample(const Shape& shape, Index n, Side side, const Grading& grading) {
  if (n < 4 || n % 2 != 0) {
    throw std::invalid_argument("a curve requires an even number of nodes >= 4, got " +
                                std::to_string(n));
  }
  const std::vector<GradedParameter> parameters = graded_parameters(grading, n);
  if (const auto* nodal = std::get_if<NodalCurve>(&shape); nodal && grading.clusters.empty()) {
    return sample_equidistantly(*nodal, n, side);
  }
  return sample_at(parameters, shape, side);
}

Curve sample(const Shape& shape, const std::vector<GradedParameter>& parameters, Side side) {
  return sample_at(parameters, shape, side);
}

Curve sample(const Shape& shape, Index n, Side side) {
  return sample(shape, n, side, Grading{});
}

}  // namespace stokesbook
