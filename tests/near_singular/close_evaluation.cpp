// Checks that the Cauchy scheme (06.13), (06.14) gives the velocity of an exact flow to rounding,
// from three node spacings away down to the nodes themselves, inside and outside.
#include <cmath>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_derivatives.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::inner_poles;
using test::largest;
using test::outer_poles;

namespace {

const ExactFlow extension{{}, 1.0};

struct SolvedCase {
  std::string name;
  Shape shape;
  Side side;
  Index n;
  const ExactFlow& flow;
};
// The node counts resolve the density of the flow to rounding.
const std::vector<SolvedCase> solved_cases = {
    {"ellipse 2:1", Ellipse{1.0, 0.5}, Side::fluid_outside, 128, inner_poles},
    {"ellipse 5:1", Ellipse{1.5, 0.3}, Side::fluid_outside, 400, inner_poles},
    {"star", Star{1.0, 0.2, 5}, Side::fluid_outside, 400, inner_poles},
    {"circular container", Circle{1.0}, Side::fluid_inside, 96, outer_poles},
    {"star-shaped container", Star{1.0, 0.2, 5}, Side::fluid_inside, 400, outer_poles},
    {"container 2:1 in extension", Ellipse{2.0, 1.0}, Side::fluid_inside, 64, extension},
    {"container 10:1", Ellipse{1.0, 0.1}, Side::fluid_inside, 512, outer_poles}};

// Holds one curve, with the Cauchy data of a flow's density.
struct Solved {
  explicit Solved(const SolvedCase& c)
      : curve(sample(c.shape, c.n, c.side)),
        cauchy(curve),
        data(cauchy.data(test::density_of(curve, c.flow.velocity(curve.x)))) {}
  ComplexVector velocity(const ComplexVector& targets) const {
    return cauchy.velocity(data, 0, targets);
  }

  Curve curve;
  CauchyCurve cauchy;
  CauchyData data;
};

// Returns the largest error, relative to the flow on the curve, at a distance from the curve at
// points between the nodes.
template <class Distance>
double error_at(const SolvedCase& c, const Solved& solved, const Distance& distance) {
  const Curve between = sample(c.shape, 122, c.side);
  const ComplexVector normal = normals(between);
  ComplexVector targets(between.size());
  for (Index j = 0; j < between.size(); ++j) {
    const double spacing =
        std::abs(between.dx[j]) * 2.0 * std::numbers::pi / static_cast<double>(c.n);
    targets[j] = between.x[j] - distance(spacing) * normal[j];
  }
  return largest(solved.velocity(targets) - c.flow.velocity(targets)) /
         largest(c.flow.velocity(solved.curve.x));
}

// The measured errors are 1e-14 ... 6e-14.
constexpr double accuracy = 2e-13;

}  // namespace

BOOST_AUTO_TEST_CASE(at_any_distance) {
  for (const SolvedCase& c : solved_cases) {
    const Solved solved(c);
    for (double spacings : {3.0, 1.0, 0.5, 0.1}) {
      BOOST_TEST_CONTEXT(c.name << ", distance " << spacings << " h") {
        BOOST_TEST(error_at(c, solved, [&](double h) { return spacings * h; }) < accuracy);
      }
    }
    for (double distance : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 0.0}) {
      BOOST_TEST_CONTEXT(c.name << ", distance " << distance) {
        BOOST_TEST(error_at(c, solved, [&](double) { return distance; }) < accuracy);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(on_the_nodes_and_next_to_them) {
  for (const SolvedCase& c : solved_cases) {
    const Solved solved(c);
    const ComplexVector& nodes = solved.curve.x;
    const double size = largest(c.flow.velocity(nodes));
    const ComplexVector at_nodes = solved.velocity(nodes);
    BOOST_TEST(largest(at_nodes - solved.data.limit) < 1e-15 * size);
    BOOST_TEST(largest(at_nodes - c.flow.velocity(nodes)) < accuracy * size);
    // The targets are one unit in the last place away: a jump or a small divisor would be visible.
    const ComplexVector beside = nodes.unaryExpr([](Complex node) {
      return Complex{std::nextafter(node.real(), 9.0), node.imag()};
    });
    BOOST_TEST(largest(solved.velocity(beside) - at_nodes) < accuracy * size);
    // The value at a target does not depend on the other targets of the same call.
    BOOST_TEST(solved.velocity(nodes.segment(1, 1))[0] == at_nodes[1]);
  }
}

double derivative_error(const SolvedCase& c, const Solved& solved, const ComplexVector& targets) {
  const CauchyDerivativeData data = solved.cauchy.derivative_data(solved.data);
  return test::derivative_error(solved.cauchy.derivatives(data, 0, targets), c.flow, targets,
                                c.side);
}

// The measured errors are up to 2.5e-12, because N modes are differentiated three times.
BOOST_AUTO_TEST_CASE(derivatives_at_any_distance) {
  for (const SolvedCase& c : solved_cases) {
    const Solved solved(c);
    const Curve between = sample(c.shape, 122, c.side);
    for (double distance : {1e-1, 1e-2, 1e-4, 1e-6, 1e-10, 0.0}) {
      if (c.name == "container 10:1" && distance == 1e-1) continue;  // too narrow
      const ComplexVector targets = between.x - distance * normals(between);
      BOOST_TEST_CONTEXT(c.name << ", distance " << distance) {
        BOOST_TEST(derivative_error(c, solved, targets) < 1e-11);
      }
    }
    BOOST_TEST_CONTEXT(c.name << ", nodes") {
      BOOST_TEST(derivative_error(c, solved, solved.curve.x) < 1e-11);
    }
  }
}

// The rows compute the same map as data() and velocity(), also next to the curve and on a node.
BOOST_AUTO_TEST_CASE(rows_of_the_cauchy_scheme) {
  for (const SolvedCase& c : solved_cases) {
    if (c.n > 128) continue;
    const CauchyCurve cauchy(sample(c.shape, c.n, c.side));
    const Curve between = sample(c.shape, 10, c.side);
    ComplexVector targets(20);
    targets << between.x - 1e-3 * normals(between), cauchy.curve().x.head(10);
    const ComplexVector density = test::random_vector(c.n, 3);
    const Eigen::VectorXd product = cauchy.velocity_rows(targets) * interleaved(density);
    const ComplexVector expected = cauchy.velocity(cauchy.data(density), 0, targets);
    BOOST_TEST(largest(deinterleaved(product) - expected) < 1e-12 * largest(expected));
  }
}

BOOST_AUTO_TEST_CASE(without_stored_matrices) {
  for (const SolvedCase& c : solved_cases) {
    const Solved stored(c);
    const CauchyCurve streamed(stored.curve, KernelStorage::streamed);
    Eigen::MatrixXcd densities(c.n, 2);
    densities << test::density_of(stored.curve, c.flow.velocity(stored.curve.x)), stored.curve.x;
    const CauchyData expected = stored.cauchy.data(densities), data = streamed.data(densities);
    const auto difference = [](const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
      return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
    };
    BOOST_TEST_CONTEXT(c.name) {
      BOOST_TEST(difference(data.limit, expected.limit) < accuracy);
      BOOST_TEST(difference(data.phi, expected.phi) < accuracy);
      // The derivative multiplies rounding by up to N / 2, and more at the tips.
      BOOST_TEST(difference(data.dphi, expected.dphi) < 1e-10);
      const ComplexVector targets = stored.curve.x.head(2);
      BOOST_TEST((streamed.velocity_rows(targets) - stored.cauchy.velocity_rows(targets)).norm() ==
                 0.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(one_column_a_density) {
  const Curve curve = sample(Ellipse{1.0, 0.5}, 64, Side::fluid_outside);
  const CauchyCurve cauchy(curve);
  Eigen::MatrixXcd densities(64, 2);
  densities << test::random_vector(64, 1), test::random_vector(64, 2);
  const CauchyData both = cauchy.data(densities);
  const ComplexVector target = ComplexVector{{Complex{0.3, 0.6}}};
  for (Index column : {0, 1}) {
    const CauchyData alone = cauchy.data(densities.col(column));
    BOOST_TEST(largest(cauchy.velocity(both, column, target) - cauchy.velocity(alone, 0, target)) <
               1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_unit_of_length_does_not_matter) {
  const auto velocity = [](double scale) {
    const Curve curve = sample(Star{scale, 0.2, 3}, 96, Side::fluid_outside);
    const CauchyCurve cauchy(curve);
    const CauchyData data = cauchy.data(sample(Ellipse{0.3, 0.7}, 96, Side::fluid_outside).x);
    return cauchy.velocity(data, 0, ComplexVector{{scale * Complex{1.1, 0.4}}})[0];
  };
  for (double scale : {1e-3, 1e3}) {
    BOOST_TEST(std::abs(velocity(scale) - velocity(1.0)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(far_away_it_is_the_trapezoid_rule) {
  for (const SolvedCase& c : solved_cases) {
    if (c.side == Side::fluid_inside) continue;
    const Curve curve = sample(c.shape, c.n, c.side);
    const CauchyCurve cauchy(curve);
    const ComplexVector density = curve.dx.array().square().matrix();
    const ComplexVector targets = ComplexVector{{Complex{3.0, 2.0}, Complex{-0.5, 4.0}}};
    const CauchyData data = cauchy.data(density);
    BOOST_TEST(largest(cauchy.velocity(data, 0, targets) -
                       StressletSum({curve})(targets, density)) < 1e-13);
    const std::vector<FlowDerivatives> close =
        cauchy.derivatives(cauchy.derivative_data(data), 0, targets);
    const std::vector<FlowDerivatives> plain = StressletSum({curve}).derivatives(targets, density);
    for (std::size_t i : {0U, 1U}) {
      BOOST_TEST(std::abs(close[i].pressure - plain[i].pressure) < 1e-11);
      BOOST_TEST(std::abs(close[i].vorticity - plain[i].vorticity) < 1e-11);
      BOOST_TEST(std::abs(close[i].strain - plain[i].strain) < 1e-11);
    }
  }
}
