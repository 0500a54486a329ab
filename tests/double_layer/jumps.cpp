// Checks the double layer's limits (02.8), -eta/2 + D eta from the fluid and +eta/2 + D eta from
// the other side, by extrapolation of values off the curve.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;

namespace {

// The limits have coarse_nodes nodes. The sum off the curve has coarse_nodes * refinement nodes,
// which resolve distances of 1e-3.
constexpr Index coarse_nodes = 256, refinement = 512;

ComplexVector analytic_density(Index n) {
  ComplexVector density(n);
  for (Index j = 0; j < n; ++j) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
    density[j] = {std::cos(t) + 0.3 * std::sin(3.0 * t), std::exp(std::sin(t)) - 0.5};
  }
  return density;
}

// Evaluates, at distance 0, the polynomial through values at distances 1, 2, ..., m times a step.
Complex extrapolate(const ComplexVector& values) {
  const Index m = values.size();
  Complex sum{};
  double weight = static_cast<double>(m);
  for (Index k = 1; k <= m; ++k) {
    sum += weight * values[k - 1];
    weight *= -static_cast<double>(m - k) / static_cast<double>(k + 1);
  }
  return sum;
}

// Returns the limit at every 16th coarse node, from the side of `direction` times the normal.
ComplexVector limit_from(const Curve& curve, const StressletSum& layer,
                         const ComplexVector& density, double direction) {
  constexpr Index distances = 10;
  constexpr double step = 1e-3;
  const ComplexVector normal = normals(curve);
  ComplexVector limits(16);
  for (Index i = 0; i < 16; ++i) {
    const Index j = i * 16 * refinement;
    ComplexVector targets(distances);
    for (Index k = 0; k < distances; ++k) {
      targets[k] = curve.x[j] + direction * step * static_cast<double>(k + 1) * normal[j];
    }
    limits[i] = extrapolate(layer(targets, density));
  }
  return limits;
}

void check_jumps(const Shape& shape, Side side) {
  const Curve curve = sample(shape, coarse_nodes, side);
  const ComplexVector density = analytic_density(coarse_nodes);
  const Eigen::VectorXd principal_values = double_layer_matrix(curve) * interleaved(density);
  const auto every_16th = Eigen::seqN(0, 16, 16);
  const ComplexVector on_curve = deinterleaved(principal_values)(every_16th);
  const ComplexVector half = 0.5 * density(every_16th);

  const Curve fine = sample(shape, coarse_nodes * refinement, side);
  const ComplexVector fine_density = analytic_density(fine.size());
  const StressletSum layer({fine});
  // The extrapolation multiplies rounding errors by 2^10.
  BOOST_TEST(largest(limit_from(fine, layer, fine_density, -1.0) - (on_curve - half)) < 1e-11);
  BOOST_TEST(largest(limit_from(fine, layer, fine_density, +1.0) - (on_curve + half)) < 1e-11);
}

}  // namespace

BOOST_AUTO_TEST_CASE(ellipse) {
  check_jumps(Ellipse{2.0, 1.0}, Side::fluid_outside);
  check_jumps(Ellipse{2.0, 1.0}, Side::fluid_inside);
}

BOOST_AUTO_TEST_CASE(star) {
  check_jumps(Star{1.0, 0.2, 5}, Side::fluid_outside);
  check_jumps(Star{1.0, 0.2, 5}, Side::fluid_inside);
}
