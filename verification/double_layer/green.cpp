// Tests Green's representation u = S[sigma n] - D[u] (02.5) of an exact flow about a body: the sum
// is the flow outside, and zero inside.
#include "experiments.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

constexpr double fluid_viscosity = 1.3, stokeslet_gauge = 0.7;
const test::ExactFlow outer_flow{{{continued(two_to_one, {0.9, 0.4}), {0.5, -0.3}, 0.4}}};

/// Holds the factors of the single layer that the defects change.
struct Factors {
  double single_layer = 1.0;
  double stokeslet_viscosity = fluid_viscosity;
};

double error(Index n, double height, double share, const Factors& factors) {
  const Curve body = sample(two_to_one, n, Side::fluid_outside);
  const ComplexVector normal = normals(body), targets = points_at(two_to_one, height);
  const Eigen::VectorXd w = weights(body);
  const ComplexVector single_layer = targets.unaryExpr([&](Complex target) {
    Complex u{};
    for (Index j = 0; j < n; ++j) {
      const Complex force = w[j] * fluid_viscosity * outer_flow.traction(body.x[j], normal[j]);
      u += stokeslet(target - body.x[j], force, factors.stokeslet_viscosity, stokeslet_gauge);
    }
    return u;
  });
  const ComplexVector velocity =
      factors.single_layer * single_layer - plain_rule(body, outer_flow.velocity(body.x), targets);
  return test::largest(velocity - share * outer_flow.velocity(targets)) /
         test::largest(outer_flow.velocity(body.x));
}

Measure errors_of(double height, double share, const Factors& factors = {}) {
  return errors_at(std::abs(height), [=](Index n) { return error(n, height, share, factors); });
}

Claim representation(const std::string& id, const std::string& statement, double rate) {
  return {.id = id,
          .statement = statement,
          .law = Geometric{rate, 0.03, 1.0},
          .window = {.from = 4.0 / rate, .floor = 1e-15},
          .reason =
              "reciprocal theorem; the preimages of the targets are the nearest "
              "singularities",
          .api = {"stokesbook::stokeslet", "stokesbook::stresslet"}};
}

}  // namespace

Experiment green() {
  constexpr double inside = 0.15, outside = -0.25;
  return {.key = "green",
          .title = "Green's representation",
          .x = "nodes N",
          .error = "error of S[σn] - D[u], relative to the largest u",
          .axes = Axes::semi_log,
          .lines = {{.key = "fluid",
                     .label = "u in the fluid",
                     .measure = errors_of(outside, 1.0),
                     .claim = representation("02_17",
                                             "S[sigma n] - D[u] is the flow outside a body, with "
                                             "the error N e^{-0.25 N} of targets at distance 0.25.",
                                             -outside),
                     .control = Control{"S[sigma n] with the other sign",
                                        errors_of(outside, 1.0, {.single_layer = -1.0})}},
                    {.key = "body",
                     .label = "0 inside the body",
                     .measure = errors_of(inside, 0.0),
                     .claim = representation("02_18",
                                             "S[sigma n] - D[u] is zero inside the body, with the "
                                             "error N e^{-0.15 N} of targets at distance 0.15.",
                                             inside),
                     .control = Control{"1/(4 pi) in place of 1/(4 pi mu)",
                                        errors_of(inside, 0.0, {.stokeslet_viscosity = 1.0})}}}};
}

}  // namespace stokesbook::verification::double_layer
