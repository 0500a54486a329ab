#include "suspension/side_test.hpp"

#include "near_singular/barycentric.hpp"

namespace stokesbook {

std::vector<std::uint8_t> in_fluid(const Configuration& configuration, const References& references,
                                   const ComplexVector& points) {
  std::vector<std::uint8_t> result(static_cast<std::size_t>(points.size()), 1);
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Curve& curve = references[k]->curve;
    const Barycentric barycentric(curve);
    // Between nodes a curve rises by less than their spacing.
    const double reach = bounding_radius(curve, 0.0) + weights(curve).maxCoeff();
    const Complex turn = std::polar(1.0, -configuration[k].orientation);
#pragma omp parallel for schedule(dynamic, 256)
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      std::uint8_t& fluid = result[static_cast<std::size_t>(i)];
      const Complex local = (points[i] - configuration[k].position) * turn;
      if (std::abs(local) > reach) {
        if (curve.side == Side::fluid_inside) fluid = 0;
      } else if (fluid == 1 && barycentric.side(local) <= 0.5) {
        fluid = 0;
      }
    }
  }
  return result;
}

}  // namespace stokesbook
