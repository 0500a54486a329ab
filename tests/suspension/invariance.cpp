// Tests that results do not depend on the frame or the units: rotation, translation and Galilean
// boost of the whole scene, units of length, time and viscosity, walls that carry all bodies with
// them, and superposition.

#include <functional>

#include <Eigen/Geometry>

#include "expected.hpp"

namespace stokesbook::test {
namespace {

Eigen::Matrix2d shear_gradient() {
  Eigen::Matrix2d gradient;
  gradient << 0.2, 1.0, -0.3, -0.2;
  return gradient;
}

Complex times(const Eigen::Matrix2d& matrix, Complex x) {
  const Eigen::Vector2d y = matrix * Eigen::Vector2d{x.real(), x.imag()};
  return {y[0], y[1]};
}

// Returns loaded bodies, one of them held, in a linear flow.
Scene mixed_scene(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Scene mixed = resolved(scene(random_bodies(random), LinearFlow{shear_gradient()}));
  for (Body& body : mixed.bodies) {
    const Load load = random_load(random);
    body.force = load.force;
    body.torque = load.torque;
  }
  Body& held = mixed.bodies[1];
  held =
      held_body(held.shape, held.n_nodes, held.position, held.orientation, random_motion(random));
  return mixed;
}

std::vector<Expected> expected_from(const Solved& solved,
                                    const std::function<RigidMotion(RigidMotion, Complex)>& motion,
                                    Complex turn = 1.0) {
  std::vector<Expected> expected;
  for (std::size_t k = 0; k < solved.solution.motions.size(); ++k) {
    const Load& load = solved.load(k);
    expected.push_back({k,
                        motion(solved.motion(k), solved.solution.instant.configuration[k].position),
                        Load{turn * load.force, load.torque},
                        {}});
  }
  return expected;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(invariance)

BOOST_AUTO_TEST_CASE(units) {
  for (const std::uint64_t seed : {41u, 42u}) {
    const Scene mixed = mixed_scene(seed);
    check(mixed, expected_from(Solved(mixed), [](RigidMotion m, Complex) { return m; }), 1e-11,
          all_units);
  }
}

BOOST_AUTO_TEST_CASE(rotation) {
  for (const double angle : {0.7, 2.0, -1.1}) {
    Scene mixed = mixed_scene(43);
    const Solved solved(mixed);
    const Complex turn = std::polar(1.0, angle);
    const Eigen::Matrix2d turning = Eigen::Rotation2Dd(angle).toRotationMatrix();
    mixed.flow = LinearFlow{turning * shear_gradient() * turning.transpose()};
    for (Body& body : mixed.bodies) {
      body.position *= turn;
      body.orientation += angle;
      body.force *= turn;
      body.velocity *= turn;
    }
    const auto turned = [&](RigidMotion m, Complex) {
      return RigidMotion{turn * m.velocity, m.omega};
    };
    check(mixed, expected_from(solved, turned, turn), 1e-11);
  }
}

// In a linear flow, a translation is equivalent to a boost by the difference of the flow. Held
// bodies must have the same boost.
BOOST_AUTO_TEST_CASE(translation_and_boost) {
  Scene mixed = mixed_scene(44);
  const Solved solved(mixed);
  const Complex shift{13.0, -7.0}, boost = times(shear_gradient(), shift);
  for (Body& body : mixed.bodies) {
    body.position += shift;
    if (body.held) body.velocity += boost;
  }
  const auto boosted = [&](RigidMotion m, Complex) {
    return RigidMotion{m.velocity + boost, m.omega};
  };
  check(mixed, expected_from(solved, boosted), 1e-11);
}

// A flow about a centre, or the same flow as a sum with a uniform stream, moves bodies at this
// centre like bodies at the origin, at any tolerance and distance.
BOOST_AUTO_TEST_CASE(relative_motion_in_shifted_and_summed_flows) {
  std::mt19937_64 random(49);
  Scene crowd = scene(random_bodies(random), LinearFlow{shear_gradient()});
  for (Body& body : crowd.bodies) body.n_nodes = automatic_nodes;
  crowd.solver.tolerance = 1e-3;
  const Solved here(crowd);
  for (const double distance : {1e2, 1e4, 1e6}) {
    const Complex shift = std::polar(distance, 0.6), stream = times(shear_gradient(), shift);
    for (const BackgroundFlow& flow :
         {BackgroundFlow{LinearFlow{shear_gradient(), shift}},
          BackgroundFlow{SumFlow{{UniformFlow{-stream}, LinearFlow{shear_gradient()}}}},
          BackgroundFlow{
              SumFlow{{UniformFlow{-2.0 * stream}, LinearFlow{shear_gradient() / 2, shift},
                       LinearFlow{shear_gradient() / 2, -2.0 * shift}}}}}) {
      Scene there = crowd;
      there.flow = flow;
      for (Body& body : there.bodies) body.position += shift;
      const Solved solved(there);
      const double rounding = 1e-12 + 1e-14 * distance;
      const Complex drift = std::get_if<SumFlow>(&flow) == nullptr
                                ? 0.0
                                : background_velocity(flow, ComplexVector{{shift}})[0];
      for (std::size_t k = 0; k < crowd.bodies.size(); ++k) {
        BOOST_TEST(std::abs(solved.motion(k).velocity - drift - here.motion(k).velocity) <
                   rounding);
        BOOST_TEST(std::abs(solved.motion(k).omega - here.motion(k).omega) < rounding);
      }
      BOOST_TEST(solved.solution.error_estimate == here.solution.error_estimate,
                 boost::test_tools::tolerance(1e-3));
    }
  }
}

// The speed with which the flow carries all bodies has no effect on their relative motion, at any
// tolerance.
BOOST_AUTO_TEST_CASE(relative_motion_in_a_fast_flow) {
  std::mt19937_64 random(47);
  Scene crowd = scene(random_bodies(random), ShearFlow{1.0});
  for (Body& body : crowd.bodies) body.n_nodes = automatic_nodes;
  crowd.solver.tolerance = 1e-3;
  const Solved here(crowd);
  for (const double height : {1e2, 1e4, 1e6}) {
    Scene there = crowd;
    for (Body& body : there.bodies) body.position += height * imaginary;
    const Solved solved(there);
    const double rounding = 1e-15 * height;
    for (std::size_t k = 0; k < crowd.bodies.size(); ++k) {
      const auto of_first = [&](const Solved& s) {
        return s.motion(k).velocity - s.motion(0).velocity;
      };
      BOOST_TEST(std::abs(of_first(solved) - of_first(here)) < 1e-12 + 10.0 * rounding);
      BOOST_TEST(std::abs(solved.motion(k).omega - here.motion(k).omega) < 1e-12 + 10.0 * rounding);
    }
    BOOST_TEST(solved.solution.error_estimate == here.solution.error_estimate,
               boost::test_tools::tolerance(1e-3));
  }
}

BOOST_AUTO_TEST_CASE(relative_motion_in_a_fast_container) {
  std::mt19937_64 random(48);
  std::vector<Body> bodies = random_bodies(random);
  for (Body& body : bodies) {
    body.n_nodes = automatic_nodes;
    body.force = {0.3, -1.0};
  }
  const auto within = [&](Complex velocity) {
    Scene result =
        scene(bodies, {}, {outer_wall(Circle{4.0}, automatic_nodes, TranslatingWall{velocity})});
    result.solver.tolerance = 1e-3;
    return result;
  };
  const Solved still(within(0.0));
  const Complex fast{1e6, -3e5};
  const Solved moved(within(fast));
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    BOOST_TEST(std::abs(moved.motion(k).velocity - fast - still.motion(k).velocity) < 1e-9);
    BOOST_TEST(moved.motion(k).omega == still.motion(k).omega);
  }
  const ComplexVector points{{Complex{0.0, 3.8}, Complex{-3.7, 0.0}}};
  BOOST_TEST((moved.velocity(points) - still.velocity(points)).cwiseAbs().maxCoeff() > 1e6);
  BOOST_TEST(((moved.velocity(points) - still.velocity(points)).array() - fast).abs().maxCoeff() <
             1e-9);
}

// A uniform stream adds its velocity to the motion of all free bodies.
BOOST_AUTO_TEST_CASE(uniform_stream) {
  Scene still = mixed_scene(45);
  still.bodies[1].held = false;
  still.flow = QuiescentFlow{};
  still.gauge_length = 10.0;
  const Solved solved(still);
  Scene stream = still;
  stream.flow = UniformFlow{{0.8, -0.5}};
  const auto carried = [](RigidMotion m, Complex) {
    return RigidMotion{m.velocity + Complex{0.8, -0.5}, m.omega};
  };
  check(stream, expected_from(solved, carried), 1e-12);
}

// A turning or translating container carries all bodies with it, and no body has a load.
BOOST_AUTO_TEST_CASE(walls_carry_bodies_rigidly) {
  std::mt19937_64 random(46);
  for (const Shape& container :
       {Shape{Circle{4}}, Shape{Star{4, 0.05, 3}}, Shape{Superellipse{4.5, 4, 4}}}) {
    const Complex centre{0.2, -0.1};
    std::vector<Body> bodies = random_bodies(random);
    const std::vector<std::pair<WallMotion, RigidMotion>> motions{
        {RotatingWall{0.9}, {0.0, 0.9}}, {TranslatingWall{{0.4, 1.2}}, {{0.4, 1.2}, 0.0}}};
    for (const auto& [motion, wall] : motions) {
      const auto carried = [wall = wall, centre](Complex position) {
        return RigidMotion{wall.velocity + wall.omega * perp(position - centre), wall.omega};
      };
      // A held body that moves with the container disturbs the rigid motion as little as a free
      // one.
      Body& held = bodies[2];
      held = held_body(held.shape, 0, held.position, held.orientation, carried(held.position));
      std::vector<Expected> expected{{3, wall, Load{}, {}}};
      for (std::size_t k = 0; k < 3; ++k) {
        expected.push_back({k, carried(bodies[k].position), Load{}, {}});
      }
      check(resolved(scene(bodies, {}, {outer_wall(container, 0, motion, centre)})), expected,
            1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(circle_carried_by_its_container) {
  const Scene carried =
      scene({body(Circle{.5}, 64, 1.2)}, {}, {outer_wall(Circle{3}, 96, RotatingWall{1})});
  check(carried, {{0, RigidMotion{{0, 1.2}, 1.0}, {}, {}}}, 1e-13);
}

// The solution of a sum of data is the sum of the solutions, in a container with all kinds of data.
BOOST_AUTO_TEST_CASE(superposition) {
  std::mt19937_64 random(47);
  Scene base = resolved(scene(random_bodies(random), {}, {outer_wall(Circle{4}, 0)}));
  Scene loads = base, walls = base, both = base;
  for (std::size_t k = 0; k < 3; ++k) {
    const Load load = random_load(random);
    for (Scene* part : {&loads, &both}) {
      part->bodies[k].force = load.force;
      part->bodies[k].torque = load.torque;
    }
  }
  walls.walls[0].motion = both.walls[0].motion = LinearWall{shear_gradient()};
  const Solved a(loads), b(walls);
  std::vector<Expected> sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum.push_back({k,
                   RigidMotion{a.motion(k).velocity + b.motion(k).velocity,
                               a.motion(k).omega + b.motion(k).omega},
                   {},
                   {}});
  }
  check(both, sum, 1e-12);
}

// A reversed flow reverses all motions and loads.
BOOST_AUTO_TEST_CASE(reversed_flow) {
  const Scene mixed = mixed_scene(48);
  const SuspensionSolver solver(mixed);
  const Instant start = solver.start();
  const Solution forth = solver.solve(start),
                 back = solver.solve({start.configuration, scaled(-1.0, start.forcing)});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [u, omega] = back.motions[k];
    BOOST_TEST(distance(forth.motions[k], {-u, -omega}) < 1e-12);
    BOOST_TEST(distance(forth.loads[k], {-back.loads[k].force, -back.loads[k].torque}) < 1e-11);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
