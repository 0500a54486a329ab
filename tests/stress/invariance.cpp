// Checks that stresses turn with the whole configuration, do not depend on its place, and scale
// with the units of length, time and viscosity.
#include <cmath>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "stress/dissipation.hpp"
#include "stress/stress.hpp"
#include "stress/stresslet.hpp"
#include "stress/traction.hpp"
#include "support/solved_flow.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// Maps a configuration to another place, direction, unit of length, speed and viscosity.
struct Change {
  Complex shift{};
  double turn = 0.0, length = 1.0, speed = 1.0, viscosity = 1.0;

  Complex direction() const { return std::polar(1.0, turn); }
  Complex point(Complex z) const { return length * (direction() * z + shift); }
};

// Solves for two bodies and a deforming wall after the change.
SolvedFlow changed(const Change& change) {
  const auto pose = [&](Complex position, double orientation) {
    return Pose{change.point(position), orientation + change.turn};
  };
  const double force = change.viscosity * change.speed;
  const Load load{change.direction() * force * Complex{1.0, -2.0}, 0.5 * force * change.length};
  Component wall =
      test::enclosing_wall(Ellipse{3.0 * change.length, 2.5 * change.length}, 192, pose(0.0, 0.0));
  const ComplexVector original = sample(Ellipse{3.0, 2.5}, 192, Side::fluid_inside).x;
  wall.velocity = change.speed * change.direction() * original.conjugate();
  return test::solve_flow(
      {{test::free_body(Ellipse{change.length, 0.6 * change.length}, 160, pose({-0.8, 0.3}, 0.4),
                        load),
        test::free_body(test::lopsided_curve(0.6 * change.length), 160, pose({1.2, -0.4}, 0.0)),
        wall},
       1.3 * change.viscosity,
       {},
       {}});
}

struct Values {
  explicit Values(const Change& change) {
    const SolvedFlow flow = changed(change);
    ComplexVector targets(flow.nodes().size() + 2);
    targets << flow.nodes(), change.point({0.2, 0.9}), change.point({0.3, 0.0});
    const std::vector<FlowDerivatives> at = flow.derivatives(targets);
    const double stress_unit = 1.3 * change.viscosity * change.speed / change.length;
    const Complex turned = change.direction() * change.direction();
    strain.resize(targets.size());
    pressure.resize(targets.size());
    for (Index i = 0; i < targets.size(); ++i) {
      const FlowDerivatives& here = at[static_cast<std::size_t>(i)];
      const Stress s = stress(here, flow.problem().viscosity);
      strain[i] = Complex{0.5 * (s.s11 - s.s22), s.s12} / turned / stress_unit;
      pressure[i] = -0.5 * (s.s11 + s.s22) / stress_unit;
    }
    pressure.array() -= pressure[targets.size() - 1];
    stresslet = body_stresslet(flow.problem().components[1].curve, flow.density().segment(160, 160),
                               flow.problem().viscosity) /
                turned / (stress_unit * change.length * change.length);
    dissipation = 0.0;
    for (const double power : power_of_loads(flow)) {
      dissipation += power / (stress_unit * change.speed * change.length);
    }
  }

  ComplexVector strain, pressure;
  Complex stresslet;
  double dissipation;
};

}  // namespace

BOOST_AUTO_TEST_CASE(stresses_follow_the_configuration) {
  const Values original({});
  for (const Change& change :
       {Change{{3.0, -7.0}, 1.1, 1e-3, -1e2, 20.0}, Change{{0.4, 2.0}, -2.0, 1e3, 0.02, 1e-3}}) {
    const Values values(change);
    const double size = test::largest(original.strain);
    BOOST_TEST(test::largest(values.strain - original.strain) < 1e-11 * size);
    BOOST_TEST(test::largest(values.pressure - original.pressure) < 1e-11 * size);
    BOOST_TEST(std::abs(values.stresslet - original.stresslet) <
               1e-12 * std::abs(original.stresslet));
    BOOST_TEST(std::abs(values.dissipation / original.dissipation - 1.0) < 1e-12);
  }
}
