// Checks each step from sources to velocities separately against the kernels: expansion about the
// sources (08.6), translation, conversion (08.10), translation of the local expansion (08.13),
// evaluation.
#include "fmm/translations.hpp"

#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;

namespace {

constexpr int order = 40;  // truncation errors are below rounding in all of these tests
constexpr double rounding = 2e-14;

Box disk(Complex centre, double radius) {
  Box box;
  box.centre = centre;
  box.radius = radius;
  return box;
}

Expansion zero() {
  return Expansion::Zero(4, order + 1);
}

// Holds some nodes and a point force in a disk, and evaluates their exact flow.
struct Sources {
  explicit Sources(const Box& disk, unsigned seed = 1) : box(disk) {
    const ComplexVector random = random_vector(12, seed), n = random_vector(12, seed + 1),
                        e = random_vector(12, seed + 2);
    const ComplexVector places = (box.centre + 0.7 * box.radius * random.array()).matrix();
    x = places.real();
    y = places.imag();
    nx = n.real();
    ny = n.imag();
    ex = e.real();
    ey = e.imag();
    least2 = Eigen::VectorXd::Zero(12);
    point = {box.centre + 0.7 * box.radius * random_vector(1, seed + 3)[0], {0.3, -0.8}, 1.7};
  }

  StressletBlock block() const {
    return {x.data(),      y.data(), nx.data(), ny.data(),
            least2.data(), x.size(), ex.data(), ey.data()};
  }

  Expansion multipole() const {
    Expansion sum = zero();
    p2m(box, block(), sum);
    p2m(box, point, sum);
    return sum;
  }

  Complex velocity(Complex z) const {
    Complex u = stokeslet(z - point.position, point.force, 1.0, 1.0) +
                rotlet(z - point.position, point.torque, 1.0);
    for (Index j = 0; j < x.size(); ++j) {
      u += std::numbers::pi * stresslet(z - Complex{x[j], y[j]}, {nx[j], ny[j]}, {ex[j], ey[j]});
    }
    return u;
  }

  FlowDerivatives flow(Complex z) const {
    FlowDerivatives sum = stokeslet_derivatives(z - point.position, point.force, 1.0);
    sum += rotlet_derivatives(z - point.position, point.torque, 1.0);
    for (Index j = 0; j < x.size(); ++j) {
      sum += stresslet_derivatives(z - Complex{x[j], y[j]}, {nx[j], ny[j]},
                                   std::numbers::pi * Complex{ex[j], ey[j]});
    }
    return sum;
  }

  Box box;
  Eigen::VectorXd x, y, nx, ny, ex, ey, least2;
  PointForce point;
};

// Evaluates a multipole expansion by its definition (08.5), (08.6).
Complex multipole_velocity(const Box& box, const Expansion& expansion, Complex z) {
  const Complex zeta = z - box.centre;
  const Complex a{expansion(0, 0), expansion(1, 0)}, b{expansion(2, 0), expansion(3, 0)};
  Complex phi = a * std::log(zeta), slope = a / zeta, psi = b * std::log(zeta) - b;
  for (Index k = 1; k < expansion.cols(); ++k) {
    const Complex power = std::pow(box.radius / zeta, static_cast<double>(k));
    phi += power * Complex{expansion(0, k), expansion(1, k)};
    slope -= static_cast<double>(k) / zeta * power * Complex{expansion(0, k), expansion(1, k)};
    psi += power * Complex{expansion(2, k), expansion(3, k)};
  }
  return phi - zeta * std::conj(slope) - std::conj(psi);
}

Complex local_velocity(const Box& box, const Expansion& expansion, Complex z) {
  VectorGroup targets, sum;
  targets.x.fill(z.real());
  targets.y.fill(z.imag());
  l2p(box, expansion, targets, sum);
  BOOST_TEST((sum.x[0] == sum.x[15] && sum.y[0] == sum.y[15]));
  return {sum.x[0], sum.y[0]};
}

// Returns points of the box's disk.
ComplexVector points_of(const Box& box) {
  return (box.centre + box.radius / std::numbers::sqrt2 * random_vector(20, 6).array()).matrix();
}

void check(Complex found, Complex exact) {
  BOOST_TEST(std::abs(found - exact) < rounding * (1.0 + std::abs(exact)));
}

}  // namespace

BOOST_AUTO_TEST_CASE(sources_to_multipole) {
  const Sources sources(disk({0.3, -0.2}, 0.9));
  for (const Complex z : points_of(disk({9.0, 4.0}, 2.0))) {
    check(multipole_velocity(sources.box, sources.multipole(), z), sources.velocity(z));
  }
}

// Translates (08.12) by shifts of any length, including zero.
BOOST_AUTO_TEST_CASE(multipole_to_multipole) {
  const Translations translations(order);
  for (const double shift : {0.0, 1e-9, 0.01, 0.03, 0.6, 1.5}) {
    const Sources sources(disk({0.3, -0.2}, 0.7));
    const Box parent = disk(sources.box.centre + std::polar(shift, 2.0), 0.7 + shift);
    Expansion sum = zero();
    translations.m2m(sources.box, sources.multipole(), parent, sum);
    for (const Complex z : points_of(disk({20.0, 4.0}, 2.0))) {
      check(multipole_velocity(parent, sum, z), sources.velocity(z));
    }
  }
}

// Converts (08.10) any number of boxes at once. The arguments of the logarithms lie on both sides
// of the branch cut.
BOOST_AUTO_TEST_CASE(multipole_to_local) {
  const Translations translations(order);
  const Box target = disk({0.1, 0.2}, 0.8);
  for (const std::size_t count : {1U, 2U, 7U, 8U, 9U, 19U}) {
    std::vector<Sources> sources;
    std::vector<Box> boxes;
    std::vector<Index> list;
    Expansions multipole(static_cast<Index>(count), 2, order);
    for (std::size_t s = 0; s < count; ++s) {
      const double angle = 1.0 + static_cast<double>(s);
      sources.emplace_back(disk(std::polar(7.0, angle), 0.5), static_cast<unsigned>(s));
      boxes.push_back(sources.back().box);
      multipole.clear(static_cast<Index>(s));
      multipole(static_cast<Index>(s), 1) = sources.back().multipole();
      list.push_back(static_cast<Index>(count - 1 - s));
    }
    Expansion sum = zero();
    translations.m2l(boxes, multipole, list, 1, target, sum);
    for (const Complex z : points_of(target)) {
      Complex exact{};
      for (const Sources& some : sources) exact += some.velocity(z);
      check(local_velocity(target, sum, z), exact);
    }
  }
}

namespace {

struct Local {
  Local() : sources(disk({-5.0, 6.0}, 0.9)), box(disk({0.1, 0.2}, 1.2)), expansion(zero()) {
    Expansions multipole(1, 1, order);
    multipole(0, 0) = sources.multipole();
    const std::vector<Index> list{0};
    Translations(order).m2l({sources.box}, multipole, list, 0, box, expansion);
  }

  Sources sources;
  Box box;
  Expansion expansion;
};

}  // namespace

BOOST_AUTO_TEST_CASE(multipole_to_local_as_a_matrix) {
  const Local local;
  const Eigen::VectorXd found = Translations(order).m2l_matrix(local.sources.box, local.box) *
                                Eigen::MatrixXd(local.sources.multipole().matrix()).reshaped();
  const Eigen::VectorXd expected = Eigen::MatrixXd(local.expansion.matrix()).reshaped();
  BOOST_TEST((found - expected).norm() < 1e-14 * expected.norm());
}

BOOST_AUTO_TEST_CASE(local_to_local) {
  const Local local;
  for (const double shift : {0.0, 1e-9, 0.003, 0.03, 0.6}) {
    const Box child = disk(local.box.centre + std::polar(shift, -2.0), 0.5);
    Expansion sum = zero();
    Translations(order).l2l(local.box, local.expansion, child, sum);
    for (const Complex z : points_of(child)) {
      check(local_velocity(child, sum, z), local.sources.velocity(z));
    }
  }
}

BOOST_AUTO_TEST_CASE(local_to_derivatives) {
  const Local local;
  for (const Complex z : points_of(local.box)) {
    const FlowDerivatives found = l2p_derivatives(local.box, local.expansion, z),
                          exact = local.sources.flow(z);
    BOOST_TEST(std::abs(found.pressure - exact.pressure) < rounding);
    BOOST_TEST(std::abs(found.vorticity - exact.vorticity) < rounding);
    BOOST_TEST(std::abs(found.strain - exact.strain) < rounding);
  }
}

// With rho = 1/2 the error is at most p / 2^p of the largest velocity (08.9).
BOOST_AUTO_TEST_CASE(what_is_left_out) {
  const Sources sources(disk({0.0, 0.0}, 1.0));
  const Box target = disk({3.0, 0.0}, 1.0);
  double largest = 0.0;
  for (const Complex z : points_of(target)) {
    largest = std::max(largest, std::abs(sources.velocity(z)));
  }
  for (const int p : {4, 8, 16, 32}) {
    const Translations translations(p);
    Expansions multipole(1, 1, p);
    multipole(0, 0) = sources.multipole().leftCols(p + 1);
    Expansion sum = Expansion::Zero(4, p + 1);
    translations.m2l({sources.box}, multipole, std::vector<Index>{0}, 0, target, sum);
    double error = 0.0;
    for (const Complex z : points_of(target)) {
      error = std::max(error, std::abs(local_velocity(target, sum, z) - sources.velocity(z)));
    }
    BOOST_TEST(error < p * std::pow(0.5, p) * largest);
    BOOST_TEST(error > 1e-6 * std::pow(0.5, p) * largest);
  }
}

BOOST_AUTO_TEST_CASE(orders_out_of_range_are_refused) {
  BOOST_CHECK_THROW(Translations(0), std::invalid_argument);
  BOOST_CHECK_THROW(Translations(61), std::invalid_argument);
  BOOST_TEST(Translations(60).order() == 60);
}
