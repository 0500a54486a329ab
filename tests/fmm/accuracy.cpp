// Checks that the FMM meets the tolerance on every kind of set, against the direct sum (08.1) and
// the kernels.
#include <string>

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;
using test::relative_error;

namespace {

constexpr double tolerances[] = {1e-3, 1e-6, 1e-9, 1e-12};

// Checks velocities at the nodes, and velocities and derivatives at other points.
void check_tolerances(const std::vector<Curve>& curves, const ComplexVector& density) {
  const StressletSum sum(curves);
  const ComplexVector exact = sum(density), nodes = all_nodes(curves);
  const ComplexVector elsewhere = nodes.head(500) + 0.1 * random_vector(500, 4);
  const auto exact_derivatives = sum.derivatives(elsewhere, density);
  for (const double tolerance : tolerances) {
    const FmmSettings settings = FmmSettings::for_tolerance(tolerance);
    BOOST_TEST(relative_error(Fmm(curves, {}, settings).velocity(density), exact) < tolerance);
    const Fmm at_points(curves, {}, elsewhere, settings);
    BOOST_TEST(relative_error(at_points.velocity(density), sum(elsewhere, density)) <
               10.0 * tolerance);
    BOOST_TEST(relative_error(at_points.derivatives(density), exact_derivatives) <
               100.0 * tolerance);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(sets_of_points) {
  for (const test::PointSet& set : test::point_sets(5000)) {
    if (set.name == std::string("coincident")) continue;  // ill_cases.cpp
    BOOST_TEST_CONTEXT(set.name) {
      check_tolerances({test::cloud(set.points, 1e-9)}, random_vector(5000, 3));
    }
  }
}

BOOST_AUTO_TEST_CASE(ellipses) {
  const std::vector<Curve> curves = test::ellipses(8, 128);
  check_tolerances(curves, random_vector(8 * 8 * 128, 3));
  ComplexVector smooth(8 * 8 * 128);
  for (Index i = 0; i < smooth.size(); ++i) {
    const double t = 2.0 * std::numbers::pi * static_cast<double>(i) / 128.0;
    smooth[i] = {std::cos(t) + 0.3, std::sin(2.0 * t + 1.0) + 0.1 * std::cos(t / 128.0)};
  }
  check_tolerances(curves, smooth);
}

// The boxes are few and have similar errors: this case requires the highest order.
BOOST_AUTO_TEST_CASE(one_slender_body) {
  const std::vector<Curve> curves = {sample(Ellipse{1.0, 0.01}, 4096, Side::fluid_outside)};
  ComplexVector wavy(4096);
  for (Index i = 0; i < 4096; ++i) {
    const double t = 80.0 * std::numbers::pi * static_cast<double>(i) / 4096.0;
    wavy[i] = {std::cos(t) + 0.2, std::sin(2.0 * t + 1.0)};
  }
  check_tolerances(curves, wavy);
  check_tolerances(curves, random_vector(4096, 3));
}

// Nodes, forces and torques act together, in several fields at once.
BOOST_AUTO_TEST_CASE(nodes_and_points) {
  const std::vector<Curve> curves = test::ellipses(4, 64);
  const Index n = 16 * 64, m = 1000;
  const ComplexVector points = (5.0 * random_vector(m, 1).array() + Complex{4.0, 4.0}).matrix();
  Eigen::MatrixXcd density(n, 7), force(m, 7);
  Eigen::MatrixXd torque(m, 7);
  for (unsigned field = 0; field < 7; ++field) {
    density.col(field) = random_vector(n, 10 + field);
    force.col(field) = 1e-3 * random_vector(m, 20 + field);
    torque.col(field) = 1e-3 * random_vector(m, 30 + field).real();
  }
  const ComplexVector targets = (6.0 * random_vector(200, 2).array() + Complex{4.0, 4.0}).matrix();
  const StressletSum sum(curves);
  std::vector<ComplexVector> exact;
  std::vector<std::vector<FlowDerivatives>> exact_derivatives;
  for (Index field = 0; field < 7; ++field) {
    exact.push_back(sum(targets, density.col(field)));
    exact_derivatives.push_back(sum.derivatives(targets, density.col(field)));
    for (Index i = 0; i < targets.size(); ++i) {
      FlowDerivatives& flow = exact_derivatives.back()[static_cast<std::size_t>(i)];
      for (Index j = 0; j < m; ++j) {
        const Complex r = targets[i] - points[j];
        exact.back()[i] +=
            stokeslet(r, force(j, field), 1.0, 1.0) + rotlet(r, torque(j, field), 1.0);
        flow += stokeslet_derivatives(r, force(j, field), 1.0);
        flow += rotlet_derivatives(r, torque(j, field), 1.0);
      }
    }
  }
  const FmmStrengths strengths(density, force, torque);
  for (const double tolerance : tolerances) {
    const Fmm at_targets(curves, points, targets, FmmSettings::for_tolerance(tolerance));
    FmmWorkspace work = at_targets.workspace(7);
    const Eigen::MatrixXcd velocity = at_targets.velocity(strengths, work);
    const std::vector<FlowDerivatives> derivatives = at_targets.derivatives(strengths, work);
    for (Index field = 0; field < 7; ++field) {
      const auto k = static_cast<std::size_t>(field);
      BOOST_TEST(relative_error(velocity.col(field), exact[k]) < tolerance);
      const auto first = derivatives.begin() + field * targets.size();
      BOOST_TEST(relative_error({first, first + targets.size()}, exact_derivatives[k]) <
                 100.0 * tolerance);
    }
  }
}

// Fields that are summed at once equal fields that are summed one by one.
BOOST_AUTO_TEST_CASE(fields_do_not_mix) {
  const std::vector<Curve> curves = test::ellipses(3, 64);
  Eigen::MatrixXcd density(9 * 64, 7);
  for (unsigned field = 0; field < 7; ++field) density.col(field) = random_vector(9 * 64, field);
  const Fmm fmm(curves, {}, {8, 20});
  const Eigen::MatrixXcd together = fmm.velocity(density);
  for (Index field = 0; field < 7; ++field) {
    BOOST_TEST(relative_error(together.col(field), fmm.velocity(density.col(field))) < 1e-14);
  }
}
