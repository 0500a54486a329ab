// Builds the node sets of the study with their direct sums, and counts operations of the fast
// multipole method.
#include "set_ups.hpp"

#include <cmath>
#include <numbers>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::fmm {

using Eigen::Index;

Summed::Summed(const std::vector<Curve>& of)
    : curves(of), density(test::random_vector(all_nodes(of).size(), 3)) {
  const ComplexVector nodes = all_nodes(curves);
  elsewhere = nodes(Eigen::seqN(0, 300, nodes.size() / 300)) + 0.1 * test::random_vector(300, 4);
  evaluate();
}

void Summed::evaluate() {
  const StressletSum sum(curves);
  velocity = sum(density);
  derivatives = sum.derivatives(elsewhere, density);
}

std::vector<Curve> as_nodes(const ComplexVector& points) {
  return {test::cloud(points, 1e-9)};
}

std::vector<Curve> square(Index n) {
  return as_nodes(test::points_in_a_square(n));
}

std::vector<Curve> ellipses(Index n) {
  constexpr Index nodes = 64;
  return test::ellipses(static_cast<int>(std::lround(std::sqrt(n / nodes))), nodes);
}

std::vector<Curve> crowd(Index n) {
  return as_nodes(test::crowding_points(n));
}

const Summed& summed_square() {
  static const Summed sum(square(5000));
  return sum;
}

const Summed& summed_ellipses() {
  static const Summed sum(ellipses(5000));
  return sum;
}

const Summed& summed_crowd() {
  static const Summed sum(crowd(5000));
  return sum;
}

const Summed& summed_slender_body() {
  static const Summed sum = [] {
    constexpr Index n = 4096;
    Summed slender({sample(Ellipse{1.0, 0.01}, n, Side::fluid_outside)});
    for (Index i = 0; i < n; ++i) {
      const double t = 80.0 * std::numbers::pi * static_cast<double>(i) / n;
      slender.density[i] = {std::cos(t) + 0.2, std::sin(2.0 * t + 1.0)};
    }
    slender.evaluate();
    return slender;
  }();
  return sum;
}

double velocity_error(const Summed& exact, const FmmSettings& settings) {
  return test::relative_error(Fmm(exact.curves, {}, settings).velocity(exact.density),
                              exact.velocity);
}

double derivative_error(const Summed& exact, const FmmSettings& settings) {
  const Fmm plan(exact.curves, {}, exact.elsewhere, settings);
  return test::relative_error(plan.derivatives(exact.density), exact.derivatives);
}

double point_force_error(const Summed& exact, const FmmSettings& settings) {
  const ComplexVector points = all_nodes(exact.curves), &force = exact.density;
  const Eigen::VectorXd torque = force.real().reverse();
  ComplexVector velocity = ComplexVector::Zero(exact.elsewhere.size());
  for (Index i = 0; i < velocity.size(); ++i) {
    for (Index j = 0; j < points.size(); ++j) {
      const Complex r = exact.elsewhere[i] - points[j];
      velocity[i] += stokeslet(r, force[j], 1.0, 1.0) + rotlet(r, torque[j], 1.0);
    }
  }
  const Fmm plan({}, points, exact.elsewhere, settings);
  return test::relative_error(plan.velocity({ComplexVector(0), force, torque}), velocity);
}

FmmSettings of_order(int order) {
  return {order, 2 * order + 32};
}

double operations(const Fmm& plan, int order) {
  const double p = order;
  double pairs = 0.0, conversions = 0.0;
  const std::vector<Box>& boxes = plan.targets().boxes;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    conversions += static_cast<double>(plan.interactions().far[b].size());
    for (const Range range : plan.interactions().near[b]) {
      pairs += static_cast<double>(boxes[b].size() * (range.last - range.first));
    }
  }
  const auto moves = static_cast<double>(boxes.size() + plan.sources().boxes.size() - 2);
  const auto points = static_cast<double>(plan.targets().size() + plan.sources().size());
  return pairs + 0.5 * p * p * conversions + 0.25 * p * p * moves + 1.5 * p * points;
}

}  // namespace stokesbook::verification::fmm
