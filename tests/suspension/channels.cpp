// Tests walls whose velocity varies along the curve: channel flow against Poiseuille's closed form,
// with the exact velocity and with data at both ends, and the net flux of data.

#include <numbers>

#include "suspension/motion/describe.hpp"
#include "suspension/scenes.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook::test {
namespace {

using std::numbers::pi;

// Returns rows at equidistant parameters of a function of the point on the curve.
VelocityData data_on(const Shape& shape, int rows, const auto& velocity) {
  const Parametrisation curve = parametrisation(shape);
  VelocityData data;
  for (int j = 0; j < rows; ++j) {
    const double t = 2.0 * pi * j / rows;
    const Complex u = velocity(curve(t).value);
    data.rows.push_back({t, u.real(), u.imag()});
  }
  return data;
}

Scene channel(const Shape& shape, const WallMotion& motion, double tolerance = 1e-9) {
  Scene result = scene({}, {}, {outer_wall(shape, automatic_nodes, motion)});
  result.solver.tolerance = tolerance;
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(channels)

// u = U (1 - (y / b)^2), p = -2 mu U x / b^2 and the dissipation mu int u_y^2 dA.
BOOST_AUTO_TEST_CASE(parabolic_wall) {
  const double speed = 1.3, half_width = 0.8, orientation = 0.5;
  const Superellipse shape{2.0, half_width, 6};
  const Complex position{30.0, -20.0}, turn = std::polar(1.0, orientation);
  Scene poiseuille = channel(shape, ParabolicWall{speed});
  poiseuille.walls[0].position = position;
  poiseuille.walls[0].orientation = orientation;
  poiseuille.viscosity = 1.7;
  const Solved solved(poiseuille);
  ComplexVector points{{Complex{0.0, 0.0}, Complex{-1.7, 0.3}, Complex{1.2, -0.79}}};
  const ComplexVector placed = (position + turn * points.array()).matrix();
  const ComplexVector velocity = solved.velocity(placed);
  const std::vector<FlowDerivatives> flow = solved.solver.derivatives(solved.solution, placed);
  const double slope = -2.0 * speed / (half_width * half_width);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double height = points[i].imag() / half_width;
    BOOST_TEST(std::abs(velocity[i] - turn * speed * (1.0 - height * height)) < 1e-8);
    const FlowDerivatives& at = flow[static_cast<std::size_t>(i)];
    BOOST_TEST(std::abs(at.vorticity + slope * points[i].imag()) < 1e-6);
    BOOST_TEST(std::abs(at.pressure - flow[0].pressure - slope * points[i].real()) < 1e-6);
  }
  // int y^2 dA = (2/3) a b^3 int (1 - x^6)^{1/2} dx, by the midpoint rule in the angle of x = sin.
  double moment = 0.0;
  constexpr int cells = 2000;
  for (int i = 0; i < cells; ++i) {
    const double angle = pi * ((i + 0.5) / cells - 0.5), x = std::sin(angle);
    moment += std::sqrt(1.0 - std::pow(x, 6.0)) * std::cos(angle) * pi / cells;
  }
  moment *= 2.0 / 3.0 * shape.a * std::pow(half_width, 3.0);
  BOOST_TEST(Rheometer(solved.solver)(solved.solution).dissipation ==
                 poiseuille.viscosity * slope * slope * moment,
             boost::test_tools::tolerance(1e-6));
}

// By Faxen's law, a small disk on the centre line lags by U a^2 / (2 b^2), up to the fourth order.
BOOST_AUTO_TEST_CASE(disk_on_the_centre_line) {
  const double radius = 0.05;
  Scene carried = channel(Superellipse{2.0, 1.0, 6}, ParabolicWall{1.0});
  carried.bodies.push_back(body(Circle{radius}, automatic_nodes, {0.3, 0.0}));
  const auto [velocity, omega] = Solved(carried).motion(0);
  BOOST_TEST(std::abs(velocity - (1.0 - 0.5 * radius * radius)) < 2.0 * std::pow(radius, 4.0));
  BOOST_TEST(std::abs(omega) < 1e-9);
}

// Fluid flows in and out with another profile, 1 - (y / b)^8. Far from the ends the profile is
// parabolic, with the same flux.
BOOST_AUTO_TEST_CASE(profile_from_data) {
  const Superellipse shape{6.0, 1.0, 8};
  const auto plug = [](Complex x) { return Complex{1.0 - std::pow(x.imag(), 8.0)}; };
  const Solved solved(channel(shape, data_on(shape, 400, plug), 1e-6));
  const double largest = 0.75 * (2.0 - 2.0 / 9.0);
  const ComplexVector points{{Complex{0.0, 0.0}, Complex{0.1, 0.6}, Complex{0.2, -0.3}}};
  const ComplexVector velocity = solved.velocity(points);
  const std::vector<FlowDerivatives> flow = solved.solver.derivatives(solved.solution, points);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double y = points[i].imag();
    BOOST_TEST(std::abs(velocity[i] - largest * (1.0 - y * y)) < 3e-6);
  }
  const double gradient = (flow[2].pressure - flow[0].pressure) / 0.2;
  BOOST_TEST(std::abs(gradient + 2.0 * largest) < 1e-4);
}

// The data turn with the wall. A linear velocity on an ellipse has one mode, which 12 rows resolve.
BOOST_AUTO_TEST_CASE(data_on_a_turned_wall) {
  const Ellipse shape{1.5, 1.0};
  Eigen::Matrix2d gradient;
  gradient << 0.4, 1.3, -0.2, -0.4;
  const double orientation = 0.9;
  const Complex turn = std::polar(1.0, orientation), point{0.3, 0.4};
  const auto linear = [&](Complex x) -> Complex {
    const Eigen::Vector2d u = gradient * Eigen::Vector2d{x.real(), x.imag()};
    return {u[0], u[1]};
  };
  Scene strained = channel(shape, data_on(shape, 12, linear));
  strained.walls[0].orientation = orientation;
  const Complex velocity = Solved(strained).velocity(ComplexVector{{turn * point}})[0];
  BOOST_TEST(std::abs(velocity - turn * linear(point)) < 1e-9);
}

// A net flux is refused. A small remainder is removed by a constant normal velocity Q / P: the flow
// of the data with this remainder is the flow of the data without it.
BOOST_AUTO_TEST_CASE(net_flux_of_data) {
  const Circle shape{2.0};
  const auto turning = [](double outflow) {
    return [=](Complex x) { return x * Complex{outflow, 0.5 + 0.1 * x.real()}; };
  };
  const auto tank = [&](double outflow) {
    return channel(shape, data_on(shape, 64, turning(outflow)), 1e-6);
  };
  check_refused(tank(0.1), {"net flux of 2.51", "out of the enclosed fluid"});
  const ComplexVector point{{Complex{0.4, 1.1}}};
  const Complex with = Solved(tank(1e-4)).velocity(point)[0],
                without = Solved(tank(0.0)).velocity(point)[0];
  BOOST_TEST(std::abs(with - without) < 1e-7);
  const std::vector<std::string> lines = describe(SuspensionSolver(tank(1e-4)));
  const auto line = std::ranges::find_if(
      lines, [](const std::string& text) { return text.starts_with("velocity data"); });
  BOOST_TEST_REQUIRE((line != lines.end()));
  BOOST_TEST(line->find("net flux 0.00251") != std::string::npos, *line);
  BOOST_TEST(line->find("velocity -0.0002") != std::string::npos, *line);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
