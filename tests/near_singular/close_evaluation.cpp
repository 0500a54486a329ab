// The Cauchy scheme gives the velocity of an exact flow to rounding, from three node spacings away
// down to the nodes themselves, inside and outside.
#include <cmath>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::ExactFlow;
using test::largest;

namespace {

const ExactFlow inner_poles{{{{0.1, 0.01}, {0.5, -0.3}, 0.4}, {{-0.2, -0.01}, {0.1, 0.8}, -0.1}}};
const ExactFlow outer_poles{{{{3.0, 1.0}, {0.5, -0.3}, 0.4}, {{-1.5, 2.5}, {0.1, 0.8}, -0.1}}, 0.7};
const ExactFlow extension{{}, 1.0};

struct Case {
  std::string name;
  Shape shape;
  Side side;
  Index n;
  const ExactFlow& flow;
};
// Node counts that resolve the density of the flow to rounding.
const std::vector<Case> cases = {
    {"ellipse 2:1", Ellipse{1.0, 0.5}, Side::fluid_outside, 128, inner_poles},
    {"ellipse 5:1", Ellipse{1.5, 0.3}, Side::fluid_outside, 400, inner_poles},
    {"star", Star{1.0, 0.2, 5}, Side::fluid_outside, 400, inner_poles},
    {"circular container", Circle{1.0}, Side::fluid_inside, 96, outer_poles},
    {"star-shaped container", Star{1.0, 0.2, 5}, Side::fluid_inside, 400, outer_poles},
    {"container 2:1 in extension", Ellipse{2.0, 1.0}, Side::fluid_inside, 64, extension},
    {"container 10:1", Ellipse{1.0, 0.1}, Side::fluid_inside, 512, outer_poles}};

// One curve with the Cauchy data of a flow's density.
struct Solved {
  explicit Solved(const Case& c)
      : curve(sample(c.shape, c.n, c.side)),
        cauchy(curve),
        data(cauchy.data(test::density_of(curve, c.flow.velocity(curve.x)))) {}
  Complex velocity(Complex target) const { return cauchy.velocity(data, 0, target); }

  Curve curve;
  CauchyCurve cauchy;
  CauchyData data;
};

// Largest error, relative to the flow on the curve, at a distance from points between the nodes.
template <class Distance>
double error_at(const Case& c, const Solved& solved, const Distance& distance) {
  const Curve between = sample(c.shape, 122, c.side);
  const ComplexVector normal = normals(between);
  double error = 0.0;
  for (Index j = 0; j < between.size(); ++j) {
    const double spacing =
        std::abs(between.dx[j]) * 2.0 * std::numbers::pi / static_cast<double>(c.n);
    const Complex target = between.x[j] - distance(spacing) * normal[j];
    error = std::max(error, std::abs(solved.velocity(target) - c.flow.velocity(target)));
  }
  return error / largest(c.flow.velocity(solved.curve.x));
}

// Measured 1e-14 ... 6e-14.
constexpr double accuracy = 2e-13;

}  // namespace

BOOST_AUTO_TEST_CASE(at_any_distance) {
  for (const Case& c : cases) {
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
  for (const Case& c : cases) {
    const Solved solved(c);
    const double size = largest(c.flow.velocity(solved.curve.x));
    for (Index j = 0; j < c.n; ++j) {
      const Complex node = solved.curve.x[j];
      BOOST_TEST(solved.velocity(node) == solved.data.limit(j, 0));
      BOOST_TEST(std::abs(solved.velocity(node) - c.flow.velocity(node)) < accuracy * size);
      // One unit in the last place away: neither a jump nor a division by a small number.
      const Complex beside{std::nextafter(node.real(), 9.0), node.imag()};
      BOOST_TEST(std::abs(solved.velocity(beside) - solved.velocity(node)) < accuracy * size);
    }
  }
}

// Largest error of pressure differences, vorticity and strain, relative to the largest strain.
double derivative_error(const Case& c, const Solved& solved, const ComplexVector& targets) {
  const CauchyDerivativeData data = solved.cauchy.derivative_data(solved.data);
  double error = 0.0, size = 0.0, datum = 0.0;
  for (Index j = 0; j < targets.size(); ++j) {
    const FlowDerivatives found = solved.cauchy.derivatives(data, 0, targets[j]);
    const double pressure = found.pressure - c.flow.pressure(targets[j]);
    if (j == 0 && c.side == Side::fluid_inside) datum = pressure;  // a container's is free
    error = std::max({error, std::abs(pressure - datum),
                      std::abs(found.vorticity - c.flow.vorticity(targets[j])),
                      std::abs(found.strain - c.flow.strain(targets[j]))});
    size = std::max(size, std::abs(c.flow.strain(targets[j])));
  }
  return error / size;
}

// Measured up to 2.5e-12: three differentiations, with N modes each.
BOOST_AUTO_TEST_CASE(derivatives_at_any_distance) {
  for (const Case& c : cases) {
    const Solved solved(c);
    const Curve between = sample(c.shape, 122, c.side);
    for (double distance : {1e-1, 1e-2, 1e-4, 1e-6, 1e-10, 0.0}) {
      if (c.name == "container 10:1" && distance == 1e-1) continue;  // as wide as this
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

BOOST_AUTO_TEST_CASE(one_column_a_density) {
  const Curve curve = sample(Ellipse{1.0, 0.5}, 64, Side::fluid_outside);
  const CauchyCurve cauchy(curve);
  Eigen::MatrixXcd densities(64, 2);
  densities << test::random_vector(64, 1), test::random_vector(64, 2);
  const CauchyData both = cauchy.data(densities);
  const Complex target{0.3, 0.6};
  for (Index column : {0, 1}) {
    const CauchyData alone = cauchy.data(densities.col(column));
    const Complex difference =
        cauchy.velocity(both, column, target) - cauchy.velocity(alone, 0, target);
    BOOST_TEST(std::abs(difference) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(the_unit_of_length_does_not_matter) {
  const auto velocity = [](double scale) {
    const Curve curve = sample(Star{scale, 0.2, 3}, 96, Side::fluid_outside);
    const CauchyCurve cauchy(curve);
    const CauchyData data = cauchy.data(sample(Ellipse{0.3, 0.7}, 96, Side::fluid_outside).x);
    return cauchy.velocity(data, 0, scale * Complex{1.1, 0.4});
  };
  for (double scale : {1e-3, 1e3}) {
    BOOST_TEST(std::abs(velocity(scale) - velocity(1.0)) < 1e-13);
  }
}

BOOST_AUTO_TEST_CASE(far_away_it_is_the_trapezoid_rule) {
  for (const Case& c : cases) {
    if (c.side == Side::fluid_inside) continue;
    const Curve curve = sample(c.shape, c.n, c.side);
    const CauchyCurve cauchy(curve);
    const ComplexVector density = curve.dx.array().square().matrix();
    const ComplexVector targets = ComplexVector{{Complex{3.0, 2.0}, Complex{-0.5, 4.0}}};
    const ComplexVector expected = cauchy.trapezoid_velocity(density, targets);
    const CauchyData data = cauchy.data(density);
    for (Index i : {0, 1}) {
      BOOST_TEST(std::abs(cauchy.velocity(data, 0, targets[i]) - expected[i]) < 1e-13);
    }
  }
}
