// Checks solutions of the boundary integral equation in cells: drag of arrays of disks (Sangani and
// Acrivos), a worm that crosses the edges of its cell, sheared arrays of disks, three loaded
// bodies, and invariances.
#include <cmath>
#include <numbers>

#include <boost/test/unit_test.hpp>

#include "fmm/fmm.hpp"
#include "support/cells.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using std::numbers::pi;
using test::Cell;
using test::CellBody;
using test::CellMotion;
using test::CellSolution;
using test::disk_in_a_cell;
using test::set_shear;
using test::three_bodies;

namespace {

// All near images are summed directly; the order suffices for rounding.
constexpr FmmSettings direct{44, 100000};

void check(Complex found, Complex exact, double tolerance) {
  BOOST_TEST(std::abs(found - exact) < tolerance * (1.0 + std::abs(exact)));
}

void check_motions(const CellSolution& found, const std::vector<CellMotion>& exact,
                   double tolerance) {
  for (std::size_t k = 0; k < exact.size(); ++k) {
    BOOST_TEST_CONTEXT("body " << k + 1) {
      check(found.bodies[k].velocity, exact[k].velocity, tolerance);
      check(found.bodies[k].omega, exact[k].omega, tolerance);
      check(found.bodies[k].stresslet, exact[k].stresslet, tolerance);
    }
  }
}

}  // namespace

// The drag D = F / (mu U) of held disks in a square array, U the mean velocity.
BOOST_AUTO_TEST_CASE(square_array_drag) {
  const std::pair<double, double> rows[] = {
      {0.05, 15.5578223189023}, {0.2, 51.5269489617989}, {0.4, 217.894314722122}};
  for (const auto& [area_fraction, drag] : rows) {
    Cell cell = disk_in_a_cell({1.0, 0.0}, {0.0, 1.0}, area_fraction, 80);
    cell.bodies[0].held = RigidMotion{};
    cell.mean_velocity = 1.0;
    check(-solve(cell, direct).bodies[0].force, drag, 1e-11);
    cell.pressure_gradient = -1.0;
    const CellSolution driven = solve(cell, direct);
    check(driven.mean_velocity, 1.0 / drag, 1e-12);
    check(driven.bodies[0].force, -1.0, 1e-13);
  }
}

// The double layer of the curve crosses the edges of the cell.
BOOST_AUTO_TEST_CASE(worm_array) {
  Cell cell = test::worm_in_a_cell(140);
  cell.pressure_gradient = -1.0;
  const CellSolution along = solve(cell, direct, ComplexVector{{Complex{0.1, 0.4}}});
  check(along.mean_velocity, {0.008234042360237, 0.002263863756014}, 1e-10);
  check(along.velocity[0], {0.016778793238148, 0.005152952236958}, 1e-10);
  cell.pressure_gradient = -imaginary;
  check(solve(cell, direct).mean_velocity, {0.002263863756014, 0.002195437715081}, 1e-10);
}

// One free disk per unit cell in the shear u = (y, 0): omega, and the stresslet S_11 + i S_12. The
// lattice is sheared by gamma.
BOOST_AUTO_TEST_CASE(sheared_array) {
  struct Row {
    double area_fraction, gamma, omega, s11, s12;
  };
  const Row rows[] = {{0.1, 0.0, -0.5, 0.0, 0.1922241876481},
                      {0.1, 0.3, -0.4934949184144, -0.0103051546494, 0.2041224204697},
                      {0.3, 0.0, -0.5, 0.0, 0.5981159774156},
                      {0.3, 0.3, -0.4784535908960, -0.1280598791163, 0.7140916371852},
                      {0.3, 0.5, -0.4683058369728, 0.0, 0.7652219275542},
                      {0.3, 1.3, -0.4784535908960, -0.1280598791163, 0.7140916371852},
                      {0.3, -0.3, -0.4784535908960, 0.1280598791163, 0.7140916371852}};
  for (const Row& row : rows) {
    BOOST_TEST_CONTEXT("area fraction " << row.area_fraction << ", gamma " << row.gamma) {
      Cell cell = disk_in_a_cell({1.0, 0.0}, {row.gamma, 1.0}, row.area_fraction, 80);
      set_shear(cell);
      const CellMotion found = solve(cell, direct).bodies[0];
      BOOST_TEST(std::abs(found.omega - row.omega) < 2e-12);
      check(found.stresslet, {row.s11, row.s12}, 2e-12);
      // The velocity is that of the mean flow at the centre.
      check(found.velocity, cell.linear_velocity(cell.bodies[0].centre), 2e-12);
    }
  }
}

BOOST_AUTO_TEST_CASE(three_loaded_bodies) {
  Cell cell = three_bodies(72);
  const ComplexVector origin = ComplexVector::Zero(1);
  const CellSolution balanced = solve(cell, direct, origin);
  check(balanced.velocity[0], {0.198124534010342, -0.14422252760137}, 1e-10);
  check_motions(balanced,
                {{{0.39601410182238, -0.06581598561613},
                  -0.44525750242194,
                  {},
                  0.0,
                  {0.5286313435274, 0.6429297159740}},
                 {{0.36960241794474, -0.42898128674961},
                  -0.73474765620486,
                  {},
                  0.0,
                  {0.3752488101818, 0.5694440451738}},
                 {{-0.43450987131629, -0.16322306429734},
                  -0.45084613631613,
                  {},
                  0.0,
                  {0.1818482256441, 0.6784713645989}}},
                1e-10);
  cell.bodies[2].force = {0.4, -1.0};
  const CellSolution net = solve(cell, direct, origin);
  check(net.velocity[0], {0.183373034927, -0.154671973769201}, 1e-10);
  const std::vector<CellMotion> motions = {{{0.38247565798551, -0.07156265243420},
                                            -0.42679767388143,
                                            {},
                                            0.0,
                                            {0.4963497092340, 0.6420373219116}},
                                           {{0.34615696960301, -0.41969417595166},
                                            -0.70914623880336,
                                            {},
                                            0.0,
                                            {0.3947726074469, 0.5350745870436}},
                                           {{-0.39853694849390, -0.17357522244044},
                                            -0.45172059205954,
                                            {},
                                            0.0,
                                            {0.1925221089259, 0.6670942196603}}};
  check_motions(net, motions, 1e-10);
  // If these motions are given, the same loads result.
  Cell held = cell;
  for (std::size_t k = 0; k < 3; ++k) {
    held.bodies[k].held = RigidMotion{net.bodies[k].velocity, net.bodies[k].omega};
  }
  const CellSolution back = solve(held, direct);
  for (std::size_t k = 0; k < 3; ++k) {
    check(back.bodies[k].force, cell.bodies[k].force, 1e-10);
    check(back.bodies[k].torque, cell.bodies[k].torque, 1e-10);
    check(back.bodies[k].stresslet, net.bodies[k].stresslet, 1e-10);
  }
}

// The disk is held; either the mean velocity or the mean gradient of the pressure is given.
BOOST_AUTO_TEST_CASE(held_and_free_bodies) {
  Cell cell = three_bodies(72);
  cell.bodies[2].held = RigidMotion{{0.2, 0.1}, 0.7};
  const CellSolution stream = solve(cell, direct);
  check(stream.bodies[2].force, {18.6464917809842, 6.5803182049997}, 1e-10);
  check(stream.bodies[2].torque, 2.3170286884095, 1e-10);
  check_motions(stream,
                {{{0.08431332706598, -0.31564055738483},
                  -0.05247769039774,
                  {},
                  0.0,
                  {0.2435973287418, 1.1975496286535}},
                 {{0.08035611130093, -0.09500853260671},
                  -0.49186002351603,
                  {},
                  0.0,
                  {0.8049932216459, -0.4776480031145}}},
                1e-10);
  cell.pressure_gradient = Complex{0.5, -0.25};
  const CellSolution driven = solve(cell, direct);
  check(driven.mean_velocity, {0.66510429030832, 0.08633742673165}, 1e-10);
  check(driven.bodies[2].force, {1.365, -1.7325}, 1e-12);
  check(driven.bodies[2].torque, 2.4351935014331, 1e-10);
  check_motions(driven,
                {{{0.91622189262635, 0.18541066923533},
                  -0.43867857017727,
                  {},
                  0.0,
                  {0.4001898559697, 0.6184250833834}},
                 {{0.85592229623693, -0.09983717110596},
                  -0.71215579344184,
                  {},
                  0.0,
                  {0.6010252618627, 0.7347801057106}}},
                1e-10);
}

namespace {

// Centres and angles of two disks.
using State = Eigen::Array<Complex, 2, 2>;

State two_disks() {
  State start;
  start << Complex{-0.4, -0.2}, 0.0, Complex{0.45, 0.25}, 0.0;
  return start;
}

// Returns the rates of two disks of different size in a lattice that the shear u = (y, 0) has moved
// since t = 0. The centres of the state are not wrapped: images move with the shear of the places
// where they are, so that no rate jumps where a wrapped centre does.
State rates(double t, const State& state) {
  const Lattice lattice({2.0, 0.0}, {2.0 * t, 2.0});
  Cell cell{lattice, {}};
  set_shear(cell);
  for (const int k : {0, 1}) {
    const double radius = k == 0 ? 0.45 : 0.3;
    cell.bodies.push_back(
        test::cell_body(Circle{radius}, lattice.wrap(state(k, 0), 0.0), state(k, 1).real(), 64));
  }
  const CellSolution solution = solve(cell, {36, 100000});
  State result;
  for (const int k : {0, 1}) {
    const auto i = static_cast<std::size_t>(k);
    const Complex image = state(k, 0) - cell.bodies[i].centre;
    result(k, 0) = solution.bodies[i].velocity + cell.linear_velocity(image);
    result(k, 1) = solution.bodies[i].omega;
  }
  return result;
}

// Follows the disks by the classical Runge-Kutta method.
State follow(State state, double begin, double end, int steps) {
  const double h = (end - begin) / steps;
  for (int n = 0; n < steps; ++n) {
    const double t = begin + n * h;
    const State k1 = rates(t, state), k2 = rates(t + 0.5 * h, state + 0.5 * h * k1),
                k3 = rates(t + 0.5 * h, state + 0.5 * h * k2), k4 = rates(t + h, state + h * k3);
    state += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return state;
}

}  // namespace

// Two disks at t = 1 and 2, by a method of order 8 with a tolerance of 1e-13.
BOOST_AUTO_TEST_CASE(two_disks_in_a_moving_lattice, *boost::unit_test::label("full")) {
  const State at_1 = follow(two_disks(), 0.0, 1.0, 60);
  check(at_1(0, 0), {-0.52257668231, -0.19013503631}, 3e-10);
  check(at_1(1, 0), {0.51919155905, 0.23100115076}, 3e-10);
  check(at_1(0, 1), -0.40531414102, 3e-10);
  check(at_1(1, 1), -0.33557138324, 3e-10);
  const State at_2 = follow(at_1, 1.0, 2.0, 60);
  check(at_2(0, 0), {-0.647780930222, -0.216018090324}, 3e-10);
  check(at_2(1, 0), {0.595320235774, 0.281206037565}, 3e-10);
  check(at_2(0, 1), -0.815806609746, 3e-10);
  check(at_2(1, 1), -0.686857478702, 3e-10);
}

// An image of the second disk moves with its lattice vector, while its wrapped centre jumps.
BOOST_AUTO_TEST_CASE(an_image_in_a_moving_lattice) {
  State image = two_disks();
  image(1, 0) += Complex{-4.0, 2.0};
  State found = follow(image, 0.0, 1.0, 5);
  found(1, 0) -= Complex{-2.0, 2.0};
  const State exact = follow(two_disks(), 0.0, 1.0, 5);
  BOOST_TEST((found - exact).abs().maxCoeff() < 1e-13);
  BOOST_TEST(std::abs(exact(1, 0) - Complex{0.51919155905, 0.23100115076}) < 1e-4);
}

// Every description of the same physical problem gives the same motions.
BOOST_AUTO_TEST_CASE(invariances) {
  Cell cell = three_bodies(40);
  cell.bodies[2].force = {0.4, -1.0};
  const CellSolution exact = solve(cell, direct);
  const Complex a1{2.2, 0.1}, a2{0.5, 1.9};
  const auto motions = [&](Cell changed) { return solve(changed, direct).bodies; };
  const auto compare = [&](const std::vector<CellMotion>& found, Complex turn = 1.0) {
    for (std::size_t k = 0; k < 3; ++k) {
      check(found[k].velocity / turn, exact.bodies[k].velocity, 1e-12);
      check(found[k].omega, exact.bodies[k].omega, 1e-12);
      check(found[k].stresslet / (turn * turn), exact.bodies[k].stresslet, 1e-12);
    }
  };
  BOOST_TEST_CONTEXT("a body moved by a lattice vector") {
    Cell moved = cell;
    const Complex w = a1 - 2.0 * a2;
    moved.bodies[1].curve = place(moved.bodies[1].curve, w, 0.0);
    moved.bodies[1].centre += w;
    std::vector<CellMotion> found = motions(moved);
    found[1].velocity -= cell.linear_velocity(w) - cell.linear_velocity(0.0);
    compare(found);
  }
  BOOST_TEST_CONTEXT("everything moved, far from the origin") {
    for (const Complex shift : {Complex{0.7, -0.4}, Complex{300.0, 1000.0}}) {
      Cell moved = cell;
      moved.origin += shift;
      for (CellBody& some : moved.bodies) {
        some.curve = place(some.curve, shift, 0.0);
        some.centre += shift;
      }
      compare(motions(moved));
    }
  }
  BOOST_TEST_CONTEXT("another basis") {
    for (const Lattice& lattice :
         {Lattice(a1, a2 + a1), Lattice(a1 + 3.0 * a2, 2.0 * a1 + 7.0 * a2)}) {
      Cell other = cell;
      other.lattice = lattice;
      compare(motions(other));
    }
  }
  BOOST_TEST_CONTEXT("frame turned") {
    Cell turned = cell;
    const Complex turn = std::polar(1.0, 0.6);
    turned.lattice = Lattice(turn * a1, turn * a2);
    turned.strain *= turn * turn;
    turned.mean_velocity *= turn;
    for (CellBody& some : turned.bodies) {
      some.curve = place(some.curve, 0.0, 0.6);
      some.centre *= turn;
      some.force *= turn;
    }
    compare(motions(turned), turn);
  }
  BOOST_TEST_CONTEXT("two cells as one") {
    Cell twice = cell;
    twice.lattice = Lattice(2.0 * a1, a2);
    for (const CellBody& some : cell.bodies) {
      twice.bodies.push_back(some);
      twice.bodies.back().curve = place(some.curve, a1, 0.0);
      twice.bodies.back().centre += a1;
    }
    compare(motions(twice));
  }
}
