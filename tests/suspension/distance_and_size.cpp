// Tests scenes far from the origin, and bodies that are tiny beside others: the solver compares
// distances between bodies and walls, never absolute positions.

#include <cmath>
#include <numbers>

#include "support/recorded_run.hpp"
#include "suspension/scenes.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook::test {
namespace {

Scene at_tolerance(double tolerance, Scene scene) {
  scene.solver.tolerance = tolerance;
  return scene;
}

Body pushed(const Shape& shape, Complex position, Complex force) {
  return body(shape, automatic_nodes, position, 0.3, {force, 0.2});
}

// Returns one scene of each kind of problem, with lengths of about 1.
std::vector<Scene> problems() {
  const std::vector<Body> bodies{pushed(Circle{0.5}, {-1.0, 0.2}, {0.3, -1.0}),
                                 pushed(Ellipse{0.6, 0.3}, {0.4, 0.1}, {-0.5, 0.8})};
  std::vector<Body> with_held = bodies;
  with_held.push_back(held_body(Circle{0.4}, automatic_nodes, {0.3, 1.2}, 0.0, {{0.1, 0.4}, 0.7}));
  const auto walls = [](const WallMotion& motion) {
    return std::vector{outer_wall(Ellipse{2.6, 2.2}, automatic_nodes, motion),
                       inner_wall(Circle{0.3}, automatic_nodes, RotatingWall{-0.4}, {0.2, -1.2})};
  };
  return {with_gauge(scene(bodies), 50.0),
          with_gauge(scene(with_held), 50.0),
          with_gauge(scene(bodies, UniformFlow{{0.3, 0.1}}), 50.0),
          scene(bodies, {}, walls(RotatingWall{0.6})),
          scene(with_held, {}, walls(TranslatingWall{{0.4, 0.2}})),
          scene(bodies, {},
                {outer_wall(Circle{2.4}, automatic_nodes, RadialWall{-0.05}),
                 inner_wall(Circle{0.3}, automatic_nodes, RadialWall{0.4}, {0.2, -1.2})})};
}

Scene moved(Scene scene, Complex shift) {
  for (Body& body : scene.bodies) body.position += shift;
  for (Wall& wall : scene.walls) wall.position += shift;
  return scene;
}

// Returns all results that do not depend on the position of a scene: motions, loads, stresslets and
// dissipation.
Eigen::VectorXd answers(const Scene& scene) {
  const Solved solved(scene);
  const Rheology rheology = Rheometer(solved.solver)(solved.solution);
  std::vector<double> numbers{rheology.dissipation, rheology.stresslet.real(),
                              rheology.stresslet.imag()};
  for (std::size_t k = 0; k < solved.solution.instant.configuration.size(); ++k) {
    const auto& [velocity, omega] = solved.motion(k);
    const auto& [force, torque] = solved.load(k);
    numbers.insert(numbers.end(),
                   {velocity.real(), velocity.imag(), omega, force.real(), force.imag(), torque});
  }
  return Eigen::Map<Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(distance_and_size)

BOOST_AUTO_TEST_CASE(answers_do_not_depend_on_the_place) {
  for (const Scene& problem : problems()) {
    const Scene here = at_tolerance(1e-7, problem);
    const Eigen::VectorXd expected = answers(here);
    for (const double diameters : {10.0, 1e3, 1e6}) {
      const Eigen::VectorXd found = answers(moved(here, std::polar(diameters, 0.7)));
      for (Eigen::Index i = 0; i < expected.size(); ++i) {
        if (std::isnan(expected[i])) continue;
        // Positions are rounded in proportion to their distance from the origin.
        BOOST_TEST(std::abs(found[i] - expected[i]) <= 1e-12 + 1e-14 * diameters);
      }
    }
  }
}

// Bodies sink to the floor of a container and rest there.
BOOST_AUTO_TEST_CASE(runs_do_not_depend_on_the_place) {
  Scene here = at_tolerance(1e-5, scene({pushed(Circle{0.5}, {-1.0, -1.0}, {0.0, -20.0}),
                                         pushed(Ellipse{0.6, 0.3}, {0.4, -1.2}, {0.0, -20.0})},
                                        {}, {outer_wall(Circle{2.5}, automatic_nodes)}));
  here.contact = ContactSettings{.minimum_separation = 0.05};
  here.time = TimeSettings{.t_final = 9.0, .dt = 0.3, .method = SteppingMethod::euler};
  const RecordedRun expected = recorded_run(here);
  BOOST_TEST(expected.steps.back().contacts > 0);
  for (const double diameters : {10.0, 1e3, 1e6}) {
    const Complex shift = std::polar(diameters, 0.7);
    const RecordedRun found = recorded_run(moved(here, shift));
    BOOST_TEST_REQUIRE(found.frames.size() == expected.frames.size());
    for (std::size_t k = 0; k < 2; ++k) {
      const BodyState &a = expected.frames.back().bodies[k], &b = found.frames.back().bodies[k];
      BOOST_TEST(std::abs(b.position - shift - a.position) <= 1e-9 + 1e-13 * diameters);
      BOOST_TEST(std::abs(b.orientation - a.orientation) <= 1e-9 + 1e-13 * diameters);
    }
  }
}

// U = F / (4 pi) [ln(R / a) - (R^2 - a^2) / (R^2 + a^2)], for any ratio R / a.
BOOST_AUTO_TEST_CASE(a_disk_in_a_container_of_any_size) {
  for (const double ratio : {3.0, 100.0, 1e4}) {
    for (const double radius : {1e-4, 1.0}) {
      const Complex centre{3.0, -7.0};
      const Scene concentric =
          scene({body(Circle{radius}, automatic_nodes, centre, 0.0, {{0.0, 1.0}, 0.0})}, {},
                {outer_wall(Circle{ratio * radius}, automatic_nodes, {}, centre)});
      const double square = ratio * ratio;
      const double exact =
          (std::log(ratio) - (square - 1.0) / (square + 1.0)) / (4.0 * std::numbers::pi);
      BOOST_TEST(Solved(concentric).motion(0).velocity.imag() == exact,
                 boost::test_tools::tolerance(1e-10));
      BOOST_TEST(!std::isnan(answers(concentric)[0]));
    }
  }
}

// A tiny disk beside a sinking disk moves with the flow that the sinking disk causes alone.
BOOST_AUTO_TEST_CASE(a_speck_beside_a_body) {
  const Body large = pushed(Circle{1.0}, {5.0, 2.0}, {0.0, -1.0});
  const Wall container = outer_wall(Circle{4.0}, automatic_nodes, {}, {5.5, 2.0});
  const Solved alone(scene({large}, {}, {container}));
  for (const double distance : {2.0, 1.3}) {
    const Complex place = large.position + std::polar(distance, 2.0);
    const Scene both = scene({large, body(Circle{1e-4}, automatic_nodes, place)}, {}, {container});
    const Complex flow = alone.velocity(ComplexVector::Constant(1, place))[0];
    const Solved solved(both);
    // By Faxen's law, this difference is of the order of radius^2.
    BOOST_TEST(std::abs(solved.motion(1).velocity - flow) < 1e-8);
    BOOST_TEST(std::abs(solved.motion(0).velocity - alone.motion(0).velocity) < 1e-8);
    BOOST_TEST(!std::isnan(answers(both)[0]));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
