// Tests Lorentz reciprocity: two problems on the same bodies exchange velocities and loads,
// whichever of the two is given on each body. The far effect of loads equals the effect of a
// distant flow on the loaded bodies.

#include "units.hpp"

namespace stokesbook::test {
namespace {

// Holds some random bodies and loads the others; at least one body is of each kind.
Scene with_random_data(Scene scene, std::mt19937_64& random) {
  const std::size_t count = scene.bodies.size();
  for (std::size_t k = 0; k < count; ++k) {
    Body& body = scene.bodies[k];
    const Load load = random_load(random);
    const RigidMotion motion = random_motion(random);
    body.held = k == 0 || (k + 1 < count && random() % 2 == 0);
    if (body.held) {
      body.velocity = motion.velocity;
      body.omega = motion.omega;
    } else {
      body.force = load.force;
      body.torque = load.torque;
    }
  }
  std::shuffle(scene.bodies.begin(), scene.bodies.end(), random);
  return scene;
}

double power(const RigidMotion& motion, const Load& load) {
  return dot(motion.velocity, load.force) + motion.omega * load.torque;
}

// Returns the power of the loads of one problem in the motions of the other one, summed over all
// components.
double mutual_power(const Solved& moving, const Solved& loading) {
  double sum = 0.0;
  for (std::size_t k = 0; k < moving.solution.motions.size(); ++k) {
    sum += power(moving.motion(k), loading.load(k));
  }
  return sum;
}

void check_exchange(const Scene& first, const Scene& second) {
  for (const Units& units : two_units) {
    const Solved a(in_units(first, units)), b(in_units(second, units));
    const double scale = units.force() * units.velocity();
    const double ab = mutual_power(a, b), ba = mutual_power(b, a);
    BOOST_TEST(std::abs(ab - ba) < 1e-10 * (std::abs(ab) + scale));
  }
}

// Returns the same bodies with other data. Only the data are shuffled; the bodies stay in place.
Scene same_places(const Scene& places, std::mt19937_64& random) {
  Scene result = places;
  std::vector<Body> data = with_random_data(places, random).bodies;
  for (std::size_t k = 0; k < data.size(); ++k) {
    Body& body = result.bodies[k];
    body.held = data[k].held;
    body.force = data[k].force;
    body.torque = data[k].torque;
    body.velocity = data[k].velocity;
    body.omega = data[k].omega;
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(reciprocity)

// The net force vanishes and the uniform velocity is free.
BOOST_AUTO_TEST_CASE(unbounded) {
  std::mt19937_64 random(31);
  for (int trial = 0; trial < 3; ++trial) {
    const Scene places = resolved(scene(random_bodies(random)));
    check_exchange(same_places(places, random), same_places(places, random));
  }
}

// With a gauge length the net force need not vanish.
BOOST_AUTO_TEST_CASE(unbounded_with_gauge) {
  std::mt19937_64 random(32);
  const Scene places = with_gauge(resolved(scene(random_bodies(random))), 50.0);
  check_exchange(same_places(places, random), same_places(places, random));
}

// The enclosing wall contributes with its motion and its load.
BOOST_AUTO_TEST_CASE(bounded) {
  std::mt19937_64 random(33);
  for (int trial = 0; trial < 2; ++trial) {
    Scene first = resolved(
        scene(random_bodies(random), {}, {outer_wall(Ellipse{4.2, 3.6}, 0, {}, {0.1, 0.2}, 0.5)}));
    Scene second = same_places(first, random);
    first = same_places(first, random);
    first.walls[0].motion = RotatingWall{0.8};
    second.walls[0].motion = TranslatingWall{{-0.3, 1.1}};
    check_exchange(first, second);
  }
}

// One problem has loads F, L on free bodies in a fluid at rest, the other load-free bodies in a
// straining flow E. The power of the loads in the motions relative to the flow at the centres
// equals the negative power of the flow on the stresslets: sum [(U - E c).F + omega L] = -sum E :
// S.
BOOST_AUTO_TEST_CASE(loads_and_distant_flows) {
  std::mt19937_64 random(34);
  const double e11 = 0.7, e12 = -0.4;
  Eigen::Matrix2d gradient;
  gradient << e11, e12, e12, -e11;
  for (int trial = 0; trial < 3; ++trial) {
    Scene loaded = resolved(with_gauge(scene(random_bodies(random)), 20.0));
    Scene carried = loaded;
    carried.gauge_length.reset();
    carried.flow = LinearFlow{gradient};
    for (Body& body : loaded.bodies) {
      const Load load = random_load(random);
      body.force = load.force;
      body.torque = load.torque;
    }
    for (const Units& units : two_units) {
      const Solved by_loads(in_units(loaded, units)), by_flow(in_units(carried, units));
      double work = 0.0, strained = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Complex c = by_loads.solution.instant.configuration[k].position;
        const Complex drift = units.rate * Complex{e11, e12} * std::conj(c);
        const RigidMotion& motion = by_flow.motion(k);
        work += power({motion.velocity - drift, motion.omega}, by_loads.load(k));
        strained += 2.0 * units.rate * dot({e11, e12}, by_loads.stresslet(k));
      }
      BOOST_TEST(std::abs(work + strained) < 1e-11 * units.force() * units.velocity());
      BOOST_TEST(std::abs(work) > 1e-3 * units.force() * units.velocity());
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
