// Finds the points that lie on the fluid's side of every component, by the divisor Delta of the
// barycentric formula: Re Delta > 1/2 (06.15). An R-tree selects the components to test.
#include "suspension/solver/fluid_mask.hpp"

#include <algorithm>

#include "near_singular/barycentric.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

// The test for one component.
class Border {
 public:
  Border(const Curve& curve, const Pose& pose)
      : barycentric_(curve),
        side_(curve.side),
        position_(pose.position),
        turn_(std::polar(1.0, -pose.orientation)),
        reach_(outer_radius(curve, 0.0)) {}

  bool has_fluid_at(Complex point) const {
    const Complex local = (point - position_) * turn_;
    if (std::abs(local) > reach_) return side_ == Side::fluid_outside;
    return barycentric_.side(local) > 0.5;
  }

  // Returns a square that contains the component.
  Rectangle surroundings() const { return square_about(position_, reach_); }

 private:
  Barycentric barycentric_;
  Side side_;
  Complex position_, turn_;
  double reach_;
};

}  // namespace

std::vector<std::uint8_t> in_fluid(const Configuration& configuration,
                                   const Discretisation& discretisation,
                                   const ComplexVector& points) {
  std::vector<Border> enclosing, others;
  std::vector<Rectangle> rectangles;  // squares about the others
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const Curve& curve = discretisation[k]->curve;
    const Border border(curve, configuration[k]);
    if (curve.side == Side::fluid_inside) {
      enclosing.push_back(border);
    } else {
      others.push_back(border);
      rectangles.push_back(border.surroundings());
    }
  }
  const RectangleIndex index(rectangles);
  std::vector<std::uint8_t> result(static_cast<std::size_t>(points.size()));
#pragma omp parallel for schedule(dynamic, 256)
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Complex point = points[i];
    const auto has_fluid = [&](const Border& border) { return border.has_fluid_at(point); };
    const auto near = index.meeting({point, point});
    const bool fluid =
        std::ranges::all_of(enclosing, has_fluid) &&
        std::ranges::all_of(near, [&](std::size_t k) { return has_fluid(others[k]); });
    result[static_cast<std::size_t>(i)] = fluid ? 1 : 0;
  }
  return result;
}

}  // namespace stokesbook
