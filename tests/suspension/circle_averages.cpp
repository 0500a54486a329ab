// Measures load and flux inside of circles from the velocity on these circles.
#include "circle_averages.hpp"

#include <array>
#include <numbers>

#include <Eigen/LU>

namespace stokesbook::test {

CircleAverage circle_average(const Solved& solved, Complex centre, double radius) {
  constexpr Eigen::Index count = 256;
  ComplexVector direction(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    direction[i] = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(i) / count);
  }
  const ComplexVector velocity = solved.velocity((centre + radius * direction.array()).matrix());
  const Complex polar = direction.dot(velocity) / static_cast<double>(count);
  return {velocity.mean(), polar.imag(), polar.real()};
}

Enclosed enclosed_by(const Solved& solved, Complex centre, double inner, double outer) {
  const std::array radii{inner, std::cbrt(inner * inner * outer), std::cbrt(inner * outer * outer),
                         outer};
  Eigen::Matrix4d laws;
  Eigen::Matrix<double, 4, 2> turning_laws;
  Eigen::Vector4cd mean;
  Eigen::Vector4d azimuthal, flux;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const double r = radii[static_cast<std::size_t>(i)], x = r / inner;
    const CircleAverage average = circle_average(solved, centre, r);
    laws.row(i) << 1.0, std::log(x), x * x, 0.0;
    turning_laws.row(i) << x, 1 / x;
    mean[i] = average.velocity;
    azimuthal[i] = average.azimuthal;
    flux[i] = 2 * std::numbers::pi * r * average.radial;
  }
  const Eigen::Vector3cd c = laws.topLeftCorner<3, 3>().inverse() * mean.head<3>();
  const Eigen::Vector2d turning = turning_laws.topRows<2>().inverse() * azimuthal.head<2>();
  const double scale = 4 * std::numbers::pi * solved.solver.scene().viscosity;
  const double misfit =
      std::abs(laws.row(3).head<3>().cast<Complex>().dot(c.conjugate()) - std::conj(mean[3]));
  const double turning_misfit = (turning_laws * turning - azimuthal).cwiseAbs().maxCoeff();
  return {{-scale * c[1], scale * inner * turning[1]},
          flux.cwiseAbs().maxCoeff(),
          std::max(misfit, turning_misfit)};
}

}  // namespace stokesbook::test
