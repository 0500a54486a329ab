// Tests bodies on which the fluid slips: a lone squirmer against its closed form, a swimmer beside
// a wall and a neighbour against the reciprocal theorem, the power of slips, interpolated slips,
// and swimmers in contact.

#include <numbers>

#include "stress/dissipation.hpp"
#include "stress/traction.hpp"
#include "suspension/expected.hpp"
#include "suspension/solver/rheology.hpp"
#include "suspension/trajectories.hpp"

namespace stokesbook::test {
namespace {

using std::numbers::pi;

Body swimmer(const Shape& shape, const Slip& slip, Complex position, double orientation = 0.0) {
  Body result = body(shape, 96, position, orientation);
  result.slip = slip;
  return result;
}

double dissipation(const Scene& scene) {
  const Solved solved(scene);
  return Rheometer(solved.solver)(solved.solution).dissipation;
}

// Returns rows of a function of the parameter, which do not begin at 0. Their distances vary by a
// part of `unevenness`.
VelocityData data_of(int rows, double unevenness, const auto& velocity) {
  VelocityData data;
  for (int j = 0; j < rows; ++j) {
    const double t = 2.0 * pi * (j + 0.3) / rows;
    const Complex u = velocity(t + unevenness * std::sin(t));
    data.rows.push_back({t + unevenness * std::sin(t), u.real(), u.imag()});
  }
  return data;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(slip)

// U = B_1 / 2 along the axis, and S_11 = 2 pi mu a B_2 in the frame of the body. The flow of mode 1
// is a dipole; that of mode n has the stream function (A / r^n + C r^{2-n}) sin n theta.
BOOST_AUTO_TEST_CASE(lone_squirmer) {
  const double radius = 0.8, orientation = 2.3;
  const Complex position{-3.0, 7.0}, turn = std::polar(1.0, orientation);
  const std::vector<double> modes{1.4, -0.6, 0.3};
  Scene alone = scene({swimmer(Circle{radius}, Squirmer{modes}, position, orientation)});
  alone.viscosity = 1.7;
  const Complex stresslet = 2.0 * pi * alone.viscosity * radius * modes[1] * turn * turn;
  check(alone, {{0, RigidMotion{0.5 * modes[0] * turn, 0.0}, Load{}, stresslet}}, 1e-12);

  const double theta = 0.6, ratio = radius / 1.9;
  double power = 0.0;
  Complex exact = 0.5 * modes[0] * ratio * ratio * std::polar(1.0, theta);  // u_r + i u_theta
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const double n = static_cast<double>(k + 1), own = modes[k];
    power += 2.0 * pi * alone.viscosity * n * own * own;
    if (k == 0) continue;
    exact += 0.5 * own * std::pow(ratio, n - 1.0) *
             Complex{n * std::cos(n * theta) * (ratio * ratio - 1.0),
                     std::sin(n * theta) * (n * ratio * ratio - n + 2.0)};
  }
  const Complex direction = std::polar(1.0, orientation + theta);
  const Complex velocity = Solved(alone).velocity(ComplexVector{{position + 1.9 * direction}})[0];
  BOOST_TEST(std::abs(velocity - direction * exact) < 1e-12);
  BOOST_TEST(dissipation(alone) == power, boost::test_tools::tolerance(1e-11));
}

// If the body of a swimmer with the slip g moves rigidly in a second problem, with the traction t
// and the load (F, L), then U . F + omega L = -int g . t ds: the reciprocal theorem.
BOOST_AUTO_TEST_CASE(swimmer_beside_a_wall_and_a_neighbour) {
  const Complex position{1.5, 0.4};
  const auto tank = [&](const Body& first) {
    return scene({first, body(Circle{0.4}, 96, {0.4, -0.2})}, {},
                 {outer_wall(Ellipse{2.4, 2.0}, 192)});
  };
  const Shape shape = Ellipse{0.6, 0.4};
  const Solved swimming(tank(swimmer(shape, Squirmer{{1.0, -0.7, 0.4}}, position, 0.8)));
  const auto& [velocity, omega] = swimming.motion(0);
  for (const RigidMotion& motion :
       {RigidMotion{1.0, 0.0}, RigidMotion{imaginary, 0.0}, RigidMotion{0.0, 1.0}}) {
    const Solved dragged(tank(held_body(shape, 96, position, 0.8, motion)));
    const Component body =
        dragged.solver.problem(dragged.solution.instant, dragged.solution.discretisation)
            .components[0];
    const ComplexVector traction =
        traction_on(body.curve, dragged.solver.derivatives(dragged.solution, body.curve.x), 1.0);
    double work = 0.0;
    for (Eigen::Index j = 0; j < 96; ++j) {
      const double t = 2.0 * pi * static_cast<double>(j) / 96.0;
      const double speed = std::sin(t) - 0.7 * std::sin(2.0 * t) + 0.4 * std::sin(3.0 * t);
      const Complex tangent{-0.6 * std::sin(t), 0.4 * std::cos(t)};
      const Complex slip = speed * tangent / std::abs(tangent) * std::polar(1.0, 0.8);
      work += weights(body.curve)[j] * dot(slip, traction[j]);
    }
    const auto& [force, torque] = dragged.load(0);
    BOOST_TEST(std::abs(dot(velocity, force) + omega * torque + work) < 1e-9);
    BOOST_TEST(std::abs(work) > 1e-3);
  }
  BOOST_TEST(std::abs(swimming.load(0).force) == 0.0);
}

// The dissipation that loaded swimmers add to a linear flow is the limit of containers that move
// with the flow, as for bodies without slip (rheology.cpp).
BOOST_AUTO_TEST_CASE(power_in_a_linear_flow) {
  Eigen::Matrix2d gradient;
  gradient << 0.3, 0.9, -0.2, -0.3;
  std::vector<Body> bodies{swimmer(Ellipse{1.0, 0.5}, Squirmer{{1.0, 0.8}}, {-1.2, 0.2}, 0.4),
                           swimmer(Circle{0.7}, Squirmer{{0.5, -1.1}}, {1.1, -0.1}, 1.9)};
  bodies[0].force = {1.0, -0.5};
  bodies[1].force = {-1.0, 0.5};
  bodies[1].torque = 0.7;
  const double excess = dissipation(scene(bodies, LinearFlow{gradient}));
  const double strain2 = 2.0 * 0.3 * 0.3 + 0.5 * 0.7 * 0.7;  // E : E
  const auto contained = [&](double radius) {
    return dissipation(scene(bodies, {}, {outer_wall(Circle{radius}, 128, LinearWall{gradient})})) -
           2.0 * strain2 * pi * radius * radius;
  };
  BOOST_TEST(std::abs((4.0 * contained(60) - contained(30)) / 3.0 - excess) < 2e-5 * excess);
}

// The power of all boundaries from the tractions is the power from loads and slips.
BOOST_AUTO_TEST_CASE(power_of_slips_and_of_tractions) {
  Body pulled = swimmer(Circle{0.5}, Squirmer{{1.0, 0.8}}, {0.6, 0.2}, 0.4);
  pulled.force = {0.4, -0.3};
  pulled.torque = 0.2;
  const Solved solved(scene({pulled}, {}, {outer_wall(Ellipse{2.4, 2.0}, 128, RotatingWall{0.3})}));
  const SolvedFlow flow = solved.solver.disturbance(solved.solution);
  const ComplexVector nodes = all_nodes(curves_of(flow.problem()));
  const std::vector<double> powers = boundary_power(
      flow, boundary_traction(flow.problem(), solved.solver.derivatives(solved.solution, nodes)));
  BOOST_TEST(dissipation(solved.solver.scene()) == powers[0] + powers[1],
             boost::test_tools::tolerance(1e-10));
}

// The motion converges to that of the slip which the data sample: with order 4 for uneven rows.
BOOST_AUTO_TEST_CASE(interpolated_slip) {
  const auto slip = [](double angle) {
    return (std::exp(std::sin(angle)) - 0.4) * imaginary * std::polar(1.0, angle);
  };
  // U is minus the mean of the slip, omega = -<slip . x^perp> / a^2.
  const double radius = 0.8, orientation = 0.7, mean = 1.2660658777520084 - 0.4;  // I_0(1) - 0.4
  const Complex velocity = 0.5651591039924851 * std::polar(1.0, orientation);     // I_1(1)
  const auto error = [&](int rows, double unevenness) {
    Scene alone =
        scene({swimmer(Circle{radius}, data_of(rows, unevenness, slip), {2.0, 1.0}, orientation)});
    return distance(Solved(alone).motion(0), {velocity, -mean / radius}, radius);
  };
  BOOST_TEST(error(24, 0.0) < 1e-12);
  const double coarse = error(24, 0.3), finer = error(48, 0.3);
  BOOST_TEST(finer < coarse / 12.0);
  BOOST_TEST(finer > 1e-9);
  BOOST_TEST(error(96, 0.3) < finer / 12.0);
}

BOOST_AUTO_TEST_CASE(slip_reverses_with_the_flow) {
  const SuspensionSolver solver(scene({swimmer(Circle{0.8}, Squirmer{{1.4, 0.6}}, {1.0, 2.0})}));
  const auto [start, forcing, cell, shifts] = solver.start();
  BOOST_TEST(std::abs(solver.solve({start, scaled(-1.0, forcing)}).motions[0].velocity + 0.7) <
             1e-13);
}

// Two swimmers that meet head on push against each other at the least gap, by symmetry at rest.
BOOST_AUTO_TEST_CASE(swimmers_in_contact) {
  Scene meeting = scene({swimmer(Circle{1.0}, Squirmer{{1.0}}, {-1.2, 0.0}),
                         swimmer(Circle{1.0}, Squirmer{{1.0}}, {1.2, 0.0}, pi)});
  meeting.solver.tolerance = 1e-4;
  meeting.contact = ContactSettings{0.1};
  meeting.time = TimeSettings{.t_final = 1.2, .dt = 0.3, .method = SteppingMethod::euler};
  const std::vector<BodyState> bodies = frames_of(meeting).back().bodies;
  BOOST_TEST(std::abs(bodies[1].position.real() - 1.05) < 1e-5);
  BOOST_TEST(std::abs(bodies[0].position.real() + 1.05) < 1e-5);
  BOOST_TEST(std::abs(bodies[0].position.imag()) < 1e-5);
}

// The slip of a rigid body may not blow fluid out of it.
BOOST_AUTO_TEST_CASE(net_flux_of_a_slip) {
  const auto blowing = [](double speed) {
    const Slip data = data_of(64, 0.1, [=](double angle) {
      return (speed + imaginary * std::sin(angle)) * std::polar(1.0, angle);
    });
    Scene result = scene({body(Circle{0.5}, 64, {3.0, 0.0}), swimmer(Circle{0.5}, data, {})});
    result.solver.tolerance = 1e-4;
    return result;
  };
  check_refused(blowing(0.1), {"slip on body 1", "net flux of -0.314", "change the data"});
  BOOST_TEST(std::abs(Solved(blowing(0.0)).motion(1).velocity.real()) > 0.1);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
