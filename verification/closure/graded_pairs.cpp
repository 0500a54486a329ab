// Two circles that nearly touch: nodes that crowd at the gap, and the double layer between the
// circles by the Cauchy scheme, so that the density alone is left to be resolved.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "experiments.hpp"
#include "near_singular/cauchy.hpp"
#include "support/closed_forms.hpp"
#include "trapezoid/grading.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

/// The double layer of a curve at targets, by the Cauchy scheme, as a matrix for interleaved
/// densities.
MatrixXd cauchy_block(const Curve& curve, const ComplexVector& targets) {
  const Index n = curve.size();
  MatrixXcd units = MatrixXcd::Zero(n, 2 * n);
  for (Index j = 0; j < n; ++j) units.row(j).segment(2 * j, 2) << 1.0, imaginary;
  const CauchyCurve cauchy(curve);
  const CauchyData data = cauchy.data(units);
  MatrixXd block(2 * targets.size(), 2 * n);
  for (Index i = 0; i < targets.size(); ++i) {
    for (Index column = 0; column < 2 * n; ++column) {
      const Complex velocity = cauchy.velocity(data, column, targets[i]);
      block.col(column).segment(2 * i, 2) << velocity.real(), velocity.imag();
    }
  }
  return block;
}

/// How one of two circles moves along their line of centres, away from the other.
struct Speeds {
  double in_extension,  ///< over strain rate and radius
      of_pull;          ///< over force / (4 pi mu)
};

/// Two unit circles, each with its parameter 0 at the gap.
struct NearlyTouching {
  double gap;
  Complex along = std::polar(1.0, 0.35);

  /// How deep below the real t axis reflections pile up.
  double depth() const { return std::asinh(std::sqrt(gap * (1.0 + 0.25 * gap))); }
  Grading grading() const { return {{{0.0, depth()}}}; }
  /// Of the error in the number of graded nodes.
  double rate() const { return graded_depth(grading(), 0.0, depth()); }

  StokesProblem problem(Index n, const Grading& nodes) const {
    const Curve circle = sample(Circle{1.0}, n, Side::fluid_outside, nodes);
    StokesProblem pair;
    for (const double sign : {1.0, -1.0}) {
      Component body;
      body.centre = sign * (1.0 + 0.5 * gap) * along;
      body.curve = place(circle, body.centre, std::arg(-sign * along));
      pair.components.push_back(body);
    }
    return pair;
  }

  Speeds exact() const {
    const CirclePair pair{1.0, gap};
    return {pair.speed_in_extension(1.0), pair.speed_of_pull(4.0 * std::numbers::pi, 1.0)};
  }
};

Speeds computed(const NearlyTouching& circles, double nodes, const Grading& grading) {
  StokesProblem pair = circles.problem(count(nodes), grading);
  const auto form = ClosureForm::scaled_bordered;
  DenseSystem system = assemble(pair, form);
  const Index n = 2 * count(nodes);
  const auto &one = pair.components[0].curve, &other = pair.components[1].curve;
  system.matrix.block(0, n, n, n) = cauchy_block(other, one.x);
  system.matrix.block(n, 0, n, n) = cauchy_block(one, other.x);
  const auto speed = [&](const StokesProblem& problem) {
    const Eigen::VectorXd density = solve(system.matrix, assemble(problem, form).rhs);
    return dot(complete_dense(problem, form, density).motions[0].velocity, circles.along);
  };
  StokesProblem in_extension = pair, pulled = pair;
  in_extension.background = circles.along * circles.along * all_nodes(pair).conjugate();
  pulled.components[0].force = 4.0 * std::numbers::pi * circles.along;
  pulled.components[1].force = -pulled.components[0].force;
  return {speed(in_extension), speed(pulled)};
}

/// The larger of the speeds' errors, each over its exact speed.
double relative_error(const NearlyTouching& circles, double nodes, const Grading& grading) {
  const Speeds exact = circles.exact(), got = computed(circles, nodes, grading);
  return std::max(std::abs(got.in_extension / exact.in_extension - 1.0),
                  std::abs(got.of_pull / exact.of_pull - 1.0));
}

/// The larger of the speeds' errors, over the scales of all velocities.
double scaled_error(const NearlyTouching& circles, double nodes, const Grading& grading) {
  const Speeds exact = circles.exact(), got = computed(circles, nodes, grading);
  return std::max(std::abs(got.in_extension - exact.in_extension),
                  std::abs(got.of_pull - exact.of_pull));
}

/// Even number of nodes that meets a tolerance of velocities over their scale a hundredfold, at an
/// error of 150 d e^{-rate N}.
double nodes_for(double tolerance, double depth, double rate) {
  return 2.0 * std::ceil(0.5 * std::log(100.0 * 150.0 * depth / tolerance) / rate);
}

Line convergence(const std::string& key, const std::string& label, double gap, bool graded,
                 const std::vector<double>& nodes) {
  const NearlyTouching circles{gap};
  const Grading grading = graded ? circles.grading() : Grading{};
  return {.key = key, .label = label, .measure = at(nodes, [=](double n) {
                                        return relative_error(circles, n, grading);
                                      })};
}

Line tolerance_line(const std::string& key, const std::string& id, double gap,
                    const std::string& label) {
  const NearlyTouching circles{gap};
  const double depth = circles.depth(), rate = circles.rate();
  const auto error = [=](const Grading& grading) {
    return [=](double tolerance) {
      return scaled_error(circles, nodes_for(tolerance, depth, rate), grading);
    };
  };
  const std::vector<double> tolerances = log_points(1e-12, 1e-4, 9);
  return {.key = key,
          .label = label,
          .measure = at(tolerances, error(circles.grading())),
          .claim = Claim{.id = id,
                         .statement = "Nodes that crowd at a gap need the numbers that the depth "
                                      "of the reflections' limit point asks for.",
                         .law = ErrorBelowTolerance{1.0, 1e-6},
                         .reason = "the estimate 150 d e^{-r N} of equidistant nodes, with the "
                                   "depth r in the new parameter in the exponent; a margin of 100",
                         .api = {"stokesbook::graded_depth", "stokesbook::Grading"}},
          .control = Control{"as many equidistant nodes", at(tolerances, error({}))}};
}

constexpr double enough_nodes = 96.0;

Measure over_gaps(const std::function<double(const NearlyTouching&, const Grading&)>& number,
                  bool graded) {
  return at(log_points(1e-8, 1e-2, 13), [=](double gap) {
    const NearlyTouching circles{gap};
    return number(circles, graded ? circles.grading() : Grading{});
  });
}

double speed_of_pull(const NearlyTouching& circles, const Grading& grading) {
  return computed(circles, enough_nodes, grading).of_pull;
}

double error_at_enough_nodes(const NearlyTouching& circles, const Grading& grading) {
  return relative_error(circles, enough_nodes, grading);
}

}  // namespace

Experiment graded_pairs() {
  const std::vector<double> few = node_counts(8, 80, 19), many = node_counts(16, 176, 11);
  return {.key = "graded",
          .title = "Two circles that nearly touch, equidistant nodes and crowding ones",
          .x = "nodes of each circle N",
          .error = "relative error of the speed along the line of centres",
          .axes = Axes::semi_log,
          .lines = {convergence("even_tenth", "gap 0.1, equidistant", 0.1, false, many),
                    convergence("even_hundredth", "gap 0.01, equidistant", 1e-2, false, many),
                    convergence("hundredth", "gap 0.01, crowding", 1e-2, true, few),
                    convergence("myriadth", "gap 1e-4, crowding", 1e-4, true, few),
                    convergence("millionth", "gap 1e-6, crowding", 1e-6, true, few)}};
}

Experiment graded_tolerances() {
  return {.key = "graded_tolerances",
          .title = "Crowding nodes in numbers that a tolerance asks for",
          .x = "tolerance T",
          .error = "error of the speeds over the scale of velocities",
          .lines = {tolerance_line("hundredth", "03_38", 1e-2, "gap 0.01"),
                    tolerance_line("myriadth", "03_39", 1e-4, "gap 1e-4"),
                    tolerance_line("millionth", "03_40", 1e-6, "gap 1e-6")}};
}

Experiment lubrication() {
  return {
      .key = "lubrication",
      .title = "Two circles of 96 crowding nodes over six decades of their gap",
      .x = "gap over radius g",
      .error = "speed of the pull, and relative error of the speeds",
      .lines = {{.key = "speed",
                 .label = "speed over force / (4 pi mu)",
                 .measure = over_gaps(speed_of_pull, true),
                 .claim = Claim{.id = "03_41",
                                .statement = "Circles pulled apart move at speeds that fall as "
                                             "the power 3/2 of their gap.",
                                .law = Algebraic{-1.5, 0.01},
                                .reason = "a - tanh(2 a) / 2 = (4 / 3) a^3 with a^2 = g: "
                                          "lubrication",
                                .api = {"stokesbook::sample", "stokesbook::Grading"}},
                 .control = Control{"as many equidistant nodes", over_gaps(speed_of_pull, false)}},
                {.key = "error",
                 .label = "relative error",
                 .measure = over_gaps(error_at_enough_nodes, true),
                 .claim = Claim{.id = "03_42",
                                .statement = "What is left is rounding, which grows as the "
                                             "inverse square of the gap.",
                                .law = Algebraic{2.0, 0.3},
                                .reason = "the condition number grows as g^(-1/2), the speed "
                                          "falls as g^(3/2)",
                                .api = {"stokesbook::Grading"}},
                 .control = Control{"as many equidistant nodes",
                                    over_gaps(error_at_enough_nodes, false)}}}};
}

}  // namespace stokesbook::verification::closure
