#include <numbers>
#include <stdexcept>
#include <string>

#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/parametrisation.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

Curve sample_curve(const Shape& shape, Index n, Side side) {
  const Parametrisation point = parametrisation(shape);
  Curve curve{ComplexVector(n), ComplexVector(n), ComplexVector(n), side};
  for (Index j = 0; j < n; ++j) {
    const auto [x, dx, ddx] =
        point(2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
    curve.x[j] = x;
    curve.dx[j] = dx;
    curve.ddx[j] = ddx;
  }
  return curve;
}

// By fast transforms.
Curve sample_curve(const NodalCurve& shape, Index n, Side side) {
  const ComplexVector x = resample(counter_clockwise(shape), n);
  const ComplexVector dx = differentiate(x);
  return {x, dx, differentiate(dx), side};
}

}  // namespace

Curve resample(const Curve& curve, Index m) {
  return {resample(curve.x, m), resample(curve.dx, m), resample(curve.ddx, m), curve.side};
}

Curve sample(const Shape& shape, Index n, Side side) {
  if (n < 4 || n % 2 != 0) {
    throw std::invalid_argument("a curve needs an even number of nodes >= 4, got " +
                                std::to_string(n));
  }
  return std::visit([&](const auto& s) { return sample_curve(s, n, side); }, shape);
}

}  // namespace stokesbook
