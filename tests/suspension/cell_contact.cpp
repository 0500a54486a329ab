// Tests contact in periodic cells: pairs of a body and an image, own images, and steps in which the
// lattice moves. Gaps are checked with all images of all bodies, without the search of chapter 10.
#include <cmath>
#include <numbers>
#include <random>

#include <omp.h>

#include "double_layer/double_layer.hpp"
#include "scenes.hpp"
#include "support/exact_gaps.hpp"
#include "support/recorded_run.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/solver/rheology.hpp"
#include "suspension/solver/tracers.hpp"

namespace stokesbook::test {

namespace {

// Gaps may be smaller than the separation by this factor of the separation.
constexpr double accepted = 2e-5;

Scene in_cell(Scene scene, Complex a1, Complex a2) {
  scene.cell.emplace();
  scene.cell->vectors << a1.real(), a1.imag(), a2.real(), a2.imag();
  return scene;
}

Body automatic(const Shape& shape, Complex position, double orientation = 0.0,
               const Load& load = {}) {
  return body(shape, automatic_nodes, position, orientation, load);
}

// Two disks in a sheared cell. Disk 0 nearly touches the image of disk 1 that is moved by -a2.
Scene pair_of_images() {
  Scene pair =
      in_cell(in_contact(ShearFlow{1.0},
                         {automatic(Circle{0.2}, {0.1, -0.35}),
                          automatic(Circle{0.2}, {0.6899137802864845, 0.3600862197135155})},
                         0.01),
              1.0, {0.3, 1.0});
  pair.solver.tolerance = 1e-11;
  return pair;
}

// Returns the least gap of all disks in a frame and of all their images in a rectangular cell that
// a shear of rate 1 deforms.
double least_disk_gap(const Scene& scene, const Frame& frame) {
  const Complex a1{scene.cell->vectors(0, 0), scene.cell->vectors(0, 1)};
  const Complex a2{scene.cell->vectors(1, 0) + frame.t * scene.cell->vectors(1, 1),
                   scene.cell->vectors(1, 1)};
  const auto radius = [&](std::size_t k) { return std::get<Circle>(scene.bodies[k].shape).radius; };
  double least = 1e300;
  for (std::size_t a = 0; a < frame.bodies.size(); ++a) {
    for (std::size_t b = 0; b <= a; ++b) {
      const Complex apart = frame.bodies[a].position - frame.bodies[b].position;
      const double rows = std::round(apart.imag() / a2.imag());
      for (double k = rows - 2.0; k <= rows + 2.0; ++k) {
        const double columns = std::round((apart - k * a2).real() / a1.real());
        for (double j = columns - 2.0; j <= columns + 2.0; ++j) {
          const double distance = std::abs(apart - j * a1 - k * a2);
          if (a != b || distance > 1e-9) least = std::min(least, distance - radius(a) - radius(b));
        }
      }
    }
  }
  return least;
}

// Checks that the forces between bodies and images balance, and so do their torques about a common
// point.
void check_balance(const Scene& scene, const Frame& frame) {
  Complex net{};
  double torque = 0.0, largest = 0.0, farthest = 0.0;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    const Complex force = body.force - scene.bodies[k].force;
    net += force;
    torque += body.torque + cross(body.position, force);
    farthest = std::max(farthest, std::abs(body.position));
  }
  for (const ContactForce& contact : frame.contacts) {
    torque -= cross(contact.shift, contact.force * contact.normal);
    largest = std::max(largest, contact.force);
    BOOST_TEST(contact.force > 0.0);
  }
  BOOST_TEST(std::abs(net) <= 1e-12 * largest);
  BOOST_TEST(std::abs(torque) <= 1e-12 * largest * (farthest + 1.0));
}

// Disks of radius 1 on a hexagonal lattice, each moved a little, with the area fraction 0.55.
Scene crowd(int columns, int rows, unsigned seed, double separation) {
  const double pitch = 2.0 * std::sqrt(std::numbers::pi / std::sqrt(12.0) / 0.55);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  std::vector<Body> bodies;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Complex place{pitch * (column + 0.5 * (row % 2)), pitch * std::sqrt(0.75) * row};
      const double x = shift(random), y = shift(random);
      bodies.push_back(automatic(Circle{1.0}, place + Complex{x, y}));
    }
  }
  Scene scene = in_cell(in_contact(ShearFlow{1.0}, bodies, separation), pitch * columns,
                        {0.0, pitch * std::sqrt(0.75) * rows});
  scene.solver.tolerance = 1e-3;
  return scene;
}

// Counts the contacts with a force in all frames, and checks gaps and forces.
std::size_t checked_contacts(const Scene& scene, const RecordedRun& run) {
  std::size_t contacts = 0;
  for (const Frame& frame : run.frames) {
    const double separation = scene.contact->minimum_separation;
    BOOST_TEST(least_disk_gap(scene, frame) >= (1.0 - accepted) * separation);
    check_balance(scene, frame);
    contacts += frame.contacts.size();
  }
  for (const StepInfo& step : run.steps) {
    BOOST_TEST(step.force_imbalance <= 1e-12);
    BOOST_TEST(step.torque_imbalance <= 1e-12);
  }
  return contacts;
}

bool are_same_bits(const Frame& p, const Frame& q) {
  bool are_same = p.t == q.t && p.contacts.size() == q.contacts.size();
  for (std::size_t k = 0; k < p.bodies.size(); ++k) {
    const BodyState &a = p.bodies[k], &b = q.bodies[k];
    are_same = are_same && a.position == b.position && a.orientation == b.orientation &&
               a.velocity == b.velocity && a.omega == b.omega && a.force == b.force;
  }
  return are_same;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_contact)

// The force between a disk and an image that keeps their gap: published in no paper, computed with
// another program and 160 and 200 nodes. The image moves with its own velocity.
BOOST_AUTO_TEST_CASE(one_force_between_a_disk_and_an_image) {
  const SuspensionSolver solver(pair_of_images());
  const Solution free = solver.solve(solver.start());
  const Placement start{configuration_of(solver, initial_state(solver)),
                        lattice_at(solver.scene(), 0.0)};
  const double dt = 0.01;
  const CloserGaps none;
  const ContactStage stage{.t = 0.0,
                           .dt = dt,
                           .start = start,
                           .acting = start,
                           .end_lattice = lattice_at(solver.scene(), dt),
                           .share = 1.0,
                           .known_velocity = {},
                           .closer = none,
                           .most_iterations = 9,
                           .free_velocity = to_rate(free)};
  ContactMobility mobility(solver, free, {}, 1e-12);
  const ContactOutcome outcome = SuspensionContact(solver).resolve(stage, mobility);
  BOOST_TEST_REQUIRE(outcome.is_resolved());
  BOOST_TEST_REQUIRE(outcome.forces.size() == 1);
  const ContactForce& contact = outcome.forces[0];
  BOOST_TEST(contact.image.first == 0);
  BOOST_TEST(contact.image.second == -1);
  BOOST_TEST(std::abs(contact.shift + Complex{0.3, 1.0}) < 1e-15);
  BOOST_TEST(std::abs(contact.normal - std::polar(1.0, 0.75 * std::numbers::pi)) < 1e-12);
  BOOST_TEST(outcome.imbalance.torque < 1e-14);
  // The row and the mobility, at the start: the rate of the gap and the force that cancels it.
  const Eigen::VectorXd row = outcome.result.force_gradient.row(0).transpose();
  const Eigen::VectorXd response = mobility(outcome.result.force_gradient.transpose());
  const Complex image_velocity = -1.0;  // G w
  const double rate = row.dot(to_rate(free)) - dot(contact.normal, image_velocity);
  const double force = -rate / row.dot(response);
  BOOST_TEST(std::abs(rate + 0.005244509741) < 1e-10);
  BOOST_TEST(std::abs(row.dot(response) - 0.002180603750) < 1e-10);
  BOOST_TEST(std::abs(force - 2.405072329390) < 1e-8);
  const Eigen::VectorXd velocity = to_rate(free) + force * response;
  BOOST_TEST(std::abs(velocity[0] + 0.429268643985) < 1e-9);
  BOOST_TEST(std::abs(velocity[1] - 0.065688246158) < 1e-9);
  BOOST_TEST(std::abs(velocity[2] + 0.457366255890) < 1e-9);
  BOOST_TEST(std::abs(velocity[3] - 0.439354863699) < 1e-9);
  BOOST_TEST(std::abs(velocity[5] + 0.457366255890) < 1e-9);
  // The force of a step cancels the rate up to the length of the step.
  BOOST_TEST(std::abs(contact.force - force) < 0.1 * force);
  // Contact adds its stress to that of the fluid.
  const Complex apart = start.paths[0].position - start.paths[1].position - contact.shift;
  const auto viscosity = [&](const Solution& solution, double of_contact) {
    return 1.0 + Rheometer(solver)(solution).stresslet.imag() -
           of_contact * contact.normal.real() * apart.imag();
  };
  BOOST_TEST(std::abs(viscosity(free, 0.0) - 1.961285049696) < 1e-9);
  const Solution loaded = mobility.loaded_solution(Eigen::VectorXd::Constant(1, force));
  BOOST_TEST(std::abs(viscosity(loaded, force) - 1.973898474955) < 1e-8);
}

// A body may be given by any of its images. The power of a force that keeps a gap is almost zero.
BOOST_AUTO_TEST_CASE(another_image_of_a_body) {
  Scene given = over(pair_of_images(), 0.2, 0.1, SteppingMethod::heun);
  given.solver.tolerance = 1e-7;
  Scene moved = given;
  const Complex a1 = 1.0, a2{0.3, 1.0};
  moved.bodies[1].position += 3.0 * a1 - 2.0 * a2;
  const RecordedRun run = recorded_run(given), other = recorded_run(moved);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const Frame &p = run.frames[i], &q = other.frames[i];
    BOOST_TEST_REQUIRE(p.contacts.size() == 1);
    BOOST_TEST_REQUIRE(q.contacts.size() == 1);
    BOOST_TEST(q.contacts[0].image.first == -3);
    BOOST_TEST(q.contacts[0].image.second == 1);
    BOOST_TEST(std::abs(p.contacts[0].force - q.contacts[0].force) < 1e-6);
    const Complex w = 3.0 * a1 - 2.0 * (a2 + p.t);
    BOOST_TEST(std::abs(q.bodies[1].position - p.bodies[1].position - w) < 1e-9);
    BOOST_TEST(std::abs(q.bodies[0].position - p.bodies[0].position) < 1e-9);
    BOOST_TEST(least_disk_gap(given, p) >= (1.0 - accepted) * 0.01);
    check_balance(moved, q);
  }
  for (const StepInfo& step : run.steps) BOOST_TEST(std::abs(step.contact_power) < 0.1);
}

// By Euler's method the power of a step is the work of its forces on both members of a contact over
// their displacements, of which the lattice causes a part. Bodies that slide past each other at a
// kept gap take out F d^2 / (2 R) with the distance R of their centres.
BOOST_AUTO_TEST_CASE(power_includes_the_motion_of_images) {
  const Complex a1 = 1.0, a2{0.3, 1.0};
  Scene scene = over(pair_of_images(), 0.2, 0.1);
  scene.solver.tolerance = 1e-5;
  scene.bodies[1].position += 3.0 * a1 - 2.0 * a2;
  const RecordedRun run = recorded_run(scene);
  BOOST_TEST_REQUIRE(run.steps.size() >= 2);
  BOOST_TEST_REQUIRE(run.frames.size() == run.steps.size() + 1);
  for (std::size_t k = 0; k < run.steps.size(); ++k) {
    const StepInfo& step = run.steps[k];
    BOOST_TEST_REQUIRE(run.frames[k].contacts.size() == 1);
    const ContactForce& contact = run.frames[k].contacts[0];
    const auto apart = [&](const Frame& frame) {
      const Complex w = static_cast<double>(contact.image.first) * a1 +
                        static_cast<double>(contact.image.second) * (a2 + frame.t);
      return frame.bodies[0].position - frame.bodies[1].position - w;
    };
    const Complex before = apart(run.frames[k]), slid = apart(run.frames[k + 1]) - before;
    const double work = contact.force * dot(contact.normal, slid);
    BOOST_TEST(step.dt * step.contact_power == work, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(work == -contact.force * std::norm(slid) / (2.0 * std::abs(before)),
               boost::test_tools::tolerance(1e-3));
    BOOST_TEST(step.energy_injected == 0.0);
  }
}

// A load turns an ellipse until it touches its own image. Contact is then a torque, which stops the
// rotation.
BOOST_AUTO_TEST_CASE(own_image) {
  const double separation = 0.05;
  const Scene scene = over(
      in_cell(in_contact(ShearFlow{1.0},
                         {automatic(Ellipse{0.55, 0.2}, {0.2, 0.1}, 0.3, {{}, -5.0})}, separation),
              1.0, {0.2, 1.4}),
      0.5, 0.1);
  const RecordedRun run = recorded_run(scene);
  const auto gap = [&](double orientation) {
    const PlacedShape here{Ellipse{0.55, 0.2}, {}, orientation};
    PlacedShape image = here;
    image.position = 1.0;
    return exact_gap(here, image);
  };
  const Frame& end = run.frames.back();
  const BodyState& body = end.bodies[0];
  BOOST_TEST_REQUIRE(end.contacts.size() == 1);
  const ContactForce& contact = end.contacts[0];
  BOOST_TEST(contact.b.number == 0);
  BOOST_TEST(contact.image.first == 1);
  BOOST_TEST(contact.image.second == 0);
  BOOST_TEST(std::abs(gap(body.orientation) - separation) < 1e-3 * separation);
  BOOST_TEST(std::abs(body.omega) < 1e-4);
  BOOST_TEST(body.force == 0.0);
  const double lever = cross(contact.shift, contact.normal), h = 1e-4;
  const double slope = (gap(body.orientation + h) - gap(body.orientation - h)) / (2.0 * h);
  BOOST_TEST(lever == slope, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(body.torque + 5.0 == contact.force * lever, boost::test_tools::tolerance(1e-12));
}

// A disk rests on the tips of a long ellipse and of its image: two contacts of one pair of bodies.
BOOST_AUTO_TEST_CASE(two_images_of_one_neighbour) {
  const double separation = 0.02;
  const Ellipse ellipse{0.4, 0.1};
  double low = 0.0, high = 0.4;
  for (int i = 0; i < 50; ++i) {
    const double y = 0.5 * (low + high);
    const double gap = exact_gap({ellipse, {}, 0.0}, {Circle{0.15}, {0.5, y}, 0.0});
    (gap < separation ? low : high) = y;
  }
  Scene scene = in_cell(in_contact(QuiescentFlow{},
                                   {automatic(ellipse, {}, 0.0, {{0.0, 2.0}, 0.0}),
                                    automatic(Circle{0.15}, {0.5, high}, 0.0, {{0.0, -2.0}, 0.0})},
                                   separation),
                        1.0, {0.0, 2.0});
  const RecordedRun run = recorded_run(over(scene, 0.02, 0.01));
  const Frame& start = run.frames.front();
  BOOST_TEST_REQUIRE(start.contacts.size() == 2);
  BOOST_TEST(start.contacts[0].image.first == 0);
  BOOST_TEST(start.contacts[1].image.first == -1);
  for (const ContactForce& contact : start.contacts) {
    // Both forces carry the load together.
    BOOST_TEST(-2.0 * contact.force * contact.normal.imag() == 2.0,
               boost::test_tools::tolerance(1e-3));
  }
  for (const BodyState& body : start.bodies) {
    BOOST_TEST(std::abs(body.force) < 2e-3);
    BOOST_TEST(std::abs(body.velocity) < 1e-3);
  }
  check_balance(scene, start);
}

// With a given gradient of the pressure, contact forces do not change the total force.
BOOST_AUTO_TEST_CASE(pressure_presses_on_a_held_body) {
  Scene scene = in_cell(
      in_contact(QuiescentFlow{},
                 {automatic(Circle{0.2}, {0.27, 0.0}), automatic(Circle{0.2}, {-0.3, 0.02})}, 0.02),
      1.0, imaginary);
  scene.bodies[1].held = true;
  const Complex gradient{-300.0, 10.0};
  scene.cell->pressure_gradient = gradient;
  std::size_t contacts = 0;
  for (const Frame& frame : recorded_run(over(scene, 0.01, 0.001)).frames) {
    for (const ContactForce& contact : frame.contacts) {
      BOOST_TEST(contact.image.first == 1);
      BOOST_TEST(std::abs(frame.bodies[0].force) > 0.1);
      ++contacts;
    }
    BOOST_TEST(std::abs(frame.bodies[0].force + frame.bodies[1].force - gradient) < 1e-9);
  }
  BOOST_TEST(contacts > 0);
}

BOOST_AUTO_TEST_CASE(starts_too_close_to_images_are_refused) {
  const auto error_of = [](const Scene& scene) {
    try {
      recorded_run(over(scene, 0.1, 0.1));
    } catch (const ConfigurationError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Scene pair = pair_of_images();
  pair.contact->minimum_separation = 0.02;
  BOOST_TEST(error_of(pair).starts_with(
      "pairs are closer at the start than contact.minimum_separation = 0.02: body 0 and an image "
      "of body 1 are 0.01 apart"));
  pair.bodies[0].position += Complex{0.02, 0.0};
  BOOST_TEST(
      error_of(pair).starts_with("bodies overlap at the start: body 0 and an image of body 1 by "));
  pair.bodies = {automatic(Circle{0.495}, 0.0)};
  BOOST_TEST(error_of(pair).find("body 0 and its own image are 0.01 apart") != std::string::npos);
}

// Pairs that begin closer than the separation keep their gap, also after a resume.
BOOST_AUTO_TEST_CASE(resumed_runs_continue_bit_for_bit) {
  Scene scene = over(crowd(2, 2, 1, 0.3), 0.6, 0.1, SteppingMethod::heun);
  // Body 0 begins near an image of body 1.
  scene.bodies[0].position = scene.bodies[1].position - scene.cell->vectors(0, 0) + 2.2;
  scene.contact->allow_close = true;
  const SuspensionSolver solver(scene);
  std::vector<Checkpoint> checkpoints;
  Frame whole, resumed;
  std::size_t contacts = 0;
  const auto run = [&](Frame& last, std::vector<Checkpoint>* kept, const Checkpoint* from) {
    Observer observer;
    observer.frame = [&](const Frame& frame) {
      last = frame;
      contacts += frame.contacts.size();
    };
    if (kept != nullptr) {
      observer.checkpoint = [&](const Checkpoint& at) { kept->push_back(at); };
    }
    Simulation simulation(solver, observer);
    if (from != nullptr) simulation.resume(*from);
    simulation.run();
  };
  run(whole, &checkpoints, nullptr);
  BOOST_TEST(contacts > 5);
  const Eigen::VectorXd& closer = checkpoints[1].history.at("closer");
  BOOST_TEST_REQUIRE(closer.size() >= 5);
  BOOST_TEST(closer[2] == -1.0);
  run(resumed, nullptr, &checkpoints[1]);
  BOOST_TEST(are_same_bits(whole, resumed));
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit_of_contact) {
  const Scene scene = over(crowd(2, 2, 2, 0.3), 0.3, 0.1, SteppingMethod::heun);
  omp_set_num_threads(1);
  const RecordedRun one = recorded_run(scene);
  omp_set_num_threads(2);
  const RecordedRun two = recorded_run(scene);
  omp_set_num_threads(1);
  BOOST_TEST(checked_contacts(scene, one) > 0);
  BOOST_TEST(are_same_bits(one.frames.back(), two.frames.back()));
}

// A dense suspension, sheared beyond the strain at which the reduced basis of the lattice changes.
BOOST_AUTO_TEST_CASE(crowds_in_shear, *boost::unit_test::label("full")) {
  for (const unsigned seed : {1U, 2U}) {
    const Scene scene = over(crowd(3, 4, seed, 0.3), 1.2, 0.1, SteppingMethod::heun);
    const RecordedRun run = recorded_run(scene);
    BOOST_TEST(checked_contacts(scene, run) > 30);
    std::size_t with_images = 0;
    for (const ContactForce& contact : run.frames.back().contacts) {
      with_images += contact.shift == 0.0 ? 0 : 1;
    }
    BOOST_TEST(with_images > 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
