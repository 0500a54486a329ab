// Chapter 02: errors of four identities of the double layer, with and without a mistake.
#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "interactive/numbers.hpp"
#include "trapezoid/curve.hpp"

namespace {

using namespace stokesbook;

// The buttons of the figure.
enum Mistake { none, other_normal, half_kernel, zero_diagonal, other_curvature, other_jump };

interactive::Case mistake_case(Mistake mistake, Eigen::Index n) {
  // A fluid inside has the other normal.
  const Side side = mistake == other_normal ? Side::fluid_inside : Side::fluid_outside;
  const Curve curve = sample(Ellipse{2.0, 1.0}, n, side);
  const ComplexVector into_body = normals(sample(Ellipse{2.0, 1.0}, n, Side::fluid_outside));
  const double factor = mistake == half_kernel ? 0.5 : 1.0;
  // The matrix contains the diagonal once.
  const double wrong_diagonal = mistake == zero_diagonal     ? -1.0
                                : mistake == other_curvature ? -2.0
                                                             : 0.0;
  const auto on_curve = [&](const ComplexVector& density) -> ComplexVector {
    const Eigen::VectorXd velocity = double_layer_matrix(curve) * interleaved(density);
    return factor * (deinterleaved(velocity) + wrong_diagonal * diagonal_velocity(curve, density));
  };
  const ComplexVector one = ComplexVector::Ones(n);
  const ComplexVector targets{{Complex{0.3, 0.2}, Complex{1.2, 1.5}}};
  const ComplexVector off_curve = factor * StressletSum({curve})(targets, one);

  const ComplexVector stretch = curve.x.real().cast<Complex>();
  const double jump = mistake == other_jump ? 0.5 : -0.5;
  const ComplexVector surplus = (1.0 + jump) * stretch + on_curve(stretch);
  double flux = 0.0;
  for (Eigen::Index j = 0; j < n; ++j) flux += weights(curve)[j] * dot(into_body[j], surplus[j]);

  const auto seen = [](double error) { return error < 1e-12 ? 0.0 : error; };  // as in the figure
  return {.settings = {{"mistake", mistake}, {"N", static_cast<double>(n)}},
          .numbers = {{"inside", seen(std::abs(off_curve[0] - 1.0))},
                      {"fluid", seen(std::abs(off_curve[1]))},
                      {"on", seen((on_curve(one) - 0.5 * one).cwiseAbs().maxCoeff())},
                      {"flux", seen(std::abs(flux) / perimeter(curve))}}};
}

}  // namespace

std::vector<interactive::Case> interactive::mistake() {
  return {mistake_case(none, 48),
          mistake_case(other_normal, 64),
          mistake_case(half_kernel, 64),
          mistake_case(zero_diagonal, 96),
          mistake_case(other_curvature, 32),
          mistake_case(other_jump, 128)};
}
