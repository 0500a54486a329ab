// Measures Newton's method with one row for each contact: the deepest vertex, or the volume (10.8).
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double landing_separation = 0.01;

// Represents an ellipse that moves onto a held ellipse. The displacement and rotation u satisfy
// 0 <= g perpendicular to lambda >= 0, u = u* + W J' lambda.
class Landing {
 public:
  /// @param depth  approximate depth at which the ellipse would end without contact
  explicit Landing(double depth) : step_(approach()) {
    const Step deep = step_to(free_);
    const double time =
        first_time(violations(deep, {{landing_separation}, 1e-6, RowChoice::every}));
    free_ *= time + (1.0 - time) * depth / -deepest(free_, RowChoice::deepest).gap;
  }

  Vector3d free_motion() const { return free_; }

  /// Returns the absolute value of the least gap.
  double error(const Vector3d& u) const { return std::abs(deepest(u, RowChoice::deepest).gap); }

  /// Takes one step of Newton's method in the total multiplier.
  Vector3d newton(const Vector3d& u, RowChoice rows) const {
    const ContactRow row = deepest(u, rows);
    const Wrench& on_a = row.derivative.on_a;
    const Vector3d j{on_a.force.real(), on_a.force.imag(), on_a.torque};
    const double b = row.gap + j.dot(free_ - u);
    return free_ + std::max(0.0, -b / j.dot(mobility_ * j)) * mobility_ * j;
  }

 private:
  // Returns the row with the least gap, of contacts that are violated or near.
  ContactRow deepest(const Vector3d& u, RowChoice rows) const {
    const Step step = step_to(u);
    ContactRow least{};
    least.gap = std::numeric_limits<double>::infinity();
    for (const Contact& contact :
         interferences(step.shapes, step.paths, {{landing_separation}, 1e-13, rows}).contacts) {
      for (const ContactRow& row : contact.rows) {
        if (row.gap < least.gap) least = row;
      }
    }
    return least;
  }

  Step step_to(const Vector3d& u) const {
    Step step = step_;
    step.paths[0].displacement = {u[0], u[1]};
    step.paths[0].rotation = u[2];
    return step;
  }

  static Step approach() {
    static const auto ellipse = body(Ellipse{1.0, 0.6}, 8192);
    return {{ellipse, ellipse},
            {{{{0.3, 1.8}, 0.5}, {0.0, 0.0}, 0.0}, {{{0.0, 0.0}, -0.2}, {0.0, 0.0}, 0.0}}};
  }

  Step step_;
  Vector3d free_{0.6, -0.9, 0.3};
  // mobility of a body that moves more easily along one direction than across it
  Matrix3d mobility_{{0.625, 0.375, 0.0}, {0.375, 0.625, 0.0}, {0.0, 0.0, 1.0}};
};

Measure after_one_step(RowChoice rows) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double p = 8e-3; p < (size == Size::full ? 0.3 : 0.04); p *= std::sqrt(2.0)) {
      const Landing landing(p);
      const Vector3d u = landing.newton(landing.free_motion(), rows);
      measurements.push_back(
          {.x = landing.error(landing.free_motion()), .error = landing.error(u)});
    }
    return measurements;
  };
}

Measure iterations(RowChoice rows) {
  return [=](Size) {
    const Landing landing(1e-2);
    Vector3d u = landing.free_motion();
    const double first = landing.error(u);
    std::vector<Measurement> measurements;
    for (int k = 1; k <= 6; ++k) {
      u = landing.newton(u, rows);
      measurements.push_back({.x = static_cast<double>(k), .error = landing.error(u) / first});
    }
    return measurements;
  };
}

}  // namespace

Experiment one_newton_step() {
  return {
      .key = "newton_step",
      .title = "Distance of the gap from zero after one step of Newton's method",
      .x = "depth p",
      .error = "distance of the gap from zero after the step",
      .lines = {
          {.key = "deepest",
           .label = "row of the deepest vertex",
           .measure = after_one_step(RowChoice::deepest),
           .claim = Claim{.id = "10_8",
                          .statement = "With the deepest vertex Newton's method is of "
                                       "order 2.",
                          .law = Algebraic{-2.0, 0.15},
                          .window = {.to = 0.04},
                          .reason = "the gap of the deepest vertex has a derivative that is not "
                                    "zero at the solution; the next one is deeper by the square of "
                                    "the correction. Depths above half the separation, below which "
                                    "the distance at the end counts, and small against the bodies",
                          .api = {"stokesbook::RowChoice"}},
           .control = Control{"the volume instead", after_one_step(RowChoice::aggregate)}},
          {.key = "aggregate",
           .label = "row of the volume",
           .measure = after_one_step(RowChoice::aggregate)}}};
}

Experiment newton_iterations() {
  return {
      .key = "newton",
      .title = "Newton's method for one contact",
      .x = "iterations k",
      .error = "distance of the gap from zero, over the first one",
      .axes = Axes::semi_log,
      .lines = {{.key = "aggregate",
                 .label = "row of the volume",
                 .measure = iterations(RowChoice::aggregate),
                 .claim = Claim{.id = "10_9",
                                .statement = "With the volume a third of the depth is left by "
                                             "each iteration.",
                                .law = Geometric{std::log(3.0)},
                                .reason = "V is in proportion to p^(3/2), of which a Newton "
                                          "step takes 2/3 of p",
                                .api = {"stokesbook::RowChoice"}},
                 .control = Control{"the deepest vertex instead", iterations(RowChoice::deepest)}},
                {.key = "deepest",
                 .label = "row of the deepest vertex",
                 .measure = iterations(RowChoice::deepest)}}};
}

}  // namespace stokesbook::verification::stiv
