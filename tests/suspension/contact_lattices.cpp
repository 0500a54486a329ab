// Tests many simultaneous contacts, more than the bodies have degrees of freedom: the contact
// forces need not be unique, but the motions are (chapters 11 and 12).

#include <boost/test/unit_test.hpp>

#include "contact_checks.hpp"
#include "contact_setup.hpp"
#include "lcp/lemke.hpp"
#include "lcp/newton.hpp"
#include "suspension/contact/contact_mobility.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook::test {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Forces = Eigen::SparseMatrix<double>;

// Returns the unit forces between neighbours of a lattice of disks, one column per pair. Pairs of
// held disks have no column.
Forces forces_between(const std::vector<Body>& bodies, double pitch) {
  std::vector<Eigen::Triplet<double>> entries;
  int m = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const Complex apart = bodies[a].position - bodies[b].position;
      if (std::abs(apart) > 1.1 * pitch || (bodies[a].held && bodies[b].held)) continue;
      const Complex normal = apart / std::abs(apart);
      for (const auto& [body, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
        const auto first = static_cast<int>(3 * body);
        entries.emplace_back(first, m, sign * normal.real());
        entries.emplace_back(first + 1, m, sign * normal.imag());
      }
      ++m;
    }
  }
  Forces forces(static_cast<Index>(3 * bodies.size()), m);
  forces.setFromTriplets(entries.begin(), entries.end());
  return forces;
}

// Checks one long step of lattice disks whose loads press them together. Two solvers of the LCP of
// all contacts must find the same motions, although Newton's method begins with forces that are all
// too large. The run must find the same motions up to nonlinear effects within the step. The matrix
// may be singular, and Newton's method then stagnates at the errors that GMRES leaves in it. They are
// small enough without a preconditioner.
void check_unique_motions(const Scene& scene, double pitch, Index contacts, double not_linear) {
  const std::vector<Body>& bodies = scene.bodies;
  const double room = pitch - 2.0 - scene.contact->minimum_separation;
  Scene plain = scene;
  plain.solver.preconditioner = PreconditionerKind::none;
  const SuspensionSolver solver(plain);
  const Configuration start = solver.start().configuration;
  const Solution free = solver.solve(solver.instant(start));
  const Forces forces = forces_between(bodies, pitch);
  BOOST_REQUIRE(forces.cols() == contacts);
  MobilityColumns none;
  none.tolerance = 0.0;
  ContactMobility respond(solver, free, none);
  const MatrixXd response = respond(forces);
  const MatrixXd unsymmetric = forces.transpose() * response;
  const VectorXd free_velocity = to_rate(free);
  const LcpProblem problem{0.5 * (unsymmetric + unsymmetric.transpose()),
                           (forces.transpose() * free_velocity).array() + room / *scene.time->dt};
  // Where the forces are not unique, the matrix is singular and Newton's method converges only
  // linearly.
  const LcpResult by_pivots = lemke(problem),
                  by_newton = fischer_newton(
                      problem, {.tolerance = 1e-9,
                                .guess = VectorXd::Constant(contacts, by_pivots.z.maxCoeff())});
  BOOST_REQUIRE((by_pivots.status == LcpStatus::solved));
  BOOST_REQUIRE((by_newton.status == LcpStatus::solved));
  const VectorXd pivots = free_velocity + response * by_pivots.z,
                 newton = free_velocity + response * by_newton.z;
  const double scale = free_velocity.cwiseAbs().maxCoeff();
  BOOST_TEST((pivots - newton).cwiseAbs().maxCoeff() < 1e-6 * scale);
  const RecordedRun run = recorded_run(scene);
  check_contact(scene, run);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto first = static_cast<Index>(3 * k);
    const Complex velocity = run.frames[0].bodies[k].velocity;
    BOOST_TEST(std::abs(velocity - Complex(pivots[first], pivots[first + 1])) < not_linear * scale);
  }
}

std::vector<Complex> hexagon(int rings, double pitch) {
  std::vector<Complex> positions;
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      if (std::abs(i + j) > rings) continue;
      positions.push_back(pitch * Complex(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j));
    }
  }
  return positions;
}

// Presses the disks of a square lattice towards its middle.
void squeeze_square_lattice(int side) {
  constexpr double separation = 0.5;
  std::vector<Body> bodies;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const Complex position =
          (2.0 + separation) * Complex(i - 0.5 * (side - 1), j - 0.5 * (side - 1));
      bodies.push_back(pushed(Circle{1.0}, position, -20.0 * position));
    }
  }
  check_unique_motions(over(loaded(bodies, separation), 0.1, 0.1), 2.0 + separation,
                       2 * side * (side - 1), 2e-4);
}

// Presses nineteen disks of a hexagon, which are in contact, towards its middle.
Scene pressed_hexagon(double load) {
  std::vector<Body> bodies;
  for (const Complex position : hexagon(2, 2.1)) {
    bodies.push_back(pushed(Circle{1.0}, position, -load * position));
  }
  return over(loaded(bodies, 0.1), 0.1, 0.1);
}

}  // namespace

// Nineteen disks in a hexagon are pressed towards its middle: 42 contacts, but the centres have
// only 38 degrees of freedom.
BOOST_AUTO_TEST_CASE(motions_are_unique_where_forces_are_not) {
  check_unique_motions(pressed_hexagon(500.0), 2.1, 42, 5e-3);
}

// Motions of bodies that press on each other change far more than the velocities from which the
// forces follow. For slightly other loads, other errors of the columns lead to other forces.
BOOST_AUTO_TEST_CASE(motions_are_accurate_where_forces_are_not_unique) {
  const Scene accurate = solved_to(pressed_hexagon(500.0), 1e-5);
  const SuspensionSolver solver(accurate);
  double free_speed = 0.0;
  for (const RigidMotion& motion : solver.solve(solver.start()).motions) {
    free_speed = std::max(free_speed, std::abs(motion.velocity));
  }
  const Frame expected = recorded_run(accurate).frames[0];
  for (const double load : {500.4582093798172, 500.24729126622327, 499.7379646270919}) {
    const Frame frame = recorded_run(pressed_hexagon(load)).frames[0];
    for (std::size_t k = 0; k < accurate.bodies.size(); ++k) {
      BOOST_TEST(std::abs(frame.bodies[k].velocity - expected.bodies[k].velocity) <
                 1e-3 * free_speed);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_square_lattice_is_squeezed) {
  squeeze_square_lattice(4);
}

BOOST_AUTO_TEST_CASE(a_hundred_disks_in_a_square_lattice_are_squeezed,
                     *boost::unit_test::label("full")) {
  squeeze_square_lattice(10);
}

// Free disks alone have at most 3n - 6 contacts, the number of edges of a planar graph. Seven free
// disks among twelve held ones have 30 contacts, more than their 21 degrees of freedom. The pitch
// leaves 1e-5 of room: otherwise errors of the mobility could make the LCP of all contacts
// unsolvable.
BOOST_AUTO_TEST_CASE(motions_are_unique_with_more_contacts_than_ways_to_move,
                     *boost::unit_test::label("full")) {
  const double pitch = 2.1 + 1e-5;
  std::vector<Body> bodies;
  for (const Complex position : hexagon(2, pitch)) {
    const bool is_free = std::abs(position) < 1.1 * pitch;
    bodies.push_back(is_free ? pushed(Circle{1.0}, position, {100.0, -500.0})
                             : held(Circle{1.0}, position));
  }
  check_unique_motions(over(solved_to(loaded(bodies, 0.1), 1e-7), 0.1, 0.1), pitch, 30, 1e-5);
}

}  // namespace stokesbook::test
