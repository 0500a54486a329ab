// Measures errors of pressure, vorticity and strain by the distance from the curve (chapter 07).
#include <algorithm>

#include "experiments.hpp"
#include "set_ups.hpp"
#include "support/exact_derivatives.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

using Data = CauchyDerivativeData;
using Defect = void (*)(const Solved&, Data&);

void none(const Solved&, Data&) {}

/// A planted defect: the stress is that of a straight curve, without phi''.
void no_second_derivative(const Solved&, Data& data) {
  data.ddphi.setZero();
}
/// A planted defect: d chi/dt replaces psi' + conj(t) phi''.
void no_tangent(const Solved& solved, Data& data) {
  const ComplexVector turn = solved.curve.dx.conjugate().cwiseQuotient(solved.curve.dx);
  data.stress += data.dphi.cwiseProduct(turn);
}
/// A planted defect: the derivatives are taken with respect to the parameter.
void by_the_parameter(const Solved& solved, Data& data) {
  data.dphi = data.dphi.cwiseProduct(solved.curve.dx);
}
/// A planted defect: the sign is that of the opposite orientation.
void other_sign(const Solved&, Data& data) {
  data.dphi = -data.dphi;
}

Measure derivative_errors(const SetUp& set_up, Defect defect) {
  return [=](Size size) {
    const Solved solved(set_up);
    const CauchyCurve cauchy(solved.curve);
    Data data = cauchy.derivative_data(cauchy.data(solved.density));
    defect(solved, data);
    std::vector<double> distances{1e-10, 1e-6, 1e-3, 1e-2, 0.1, 0.5, 1.0, 3.0};
    if (size == Size::full) {
      distances.insert(distances.end(), {1e-8, 1e-4, 0.03, 2.0});
      std::ranges::sort(distances);
    }
    std::vector<Measurement> measurements;
    for (const double d : distances) {
      const ComplexVector points = solved.points_at(d);
      measurements.push_back({.x = d,
                              .error = test::derivative_error(cauchy.derivatives(data, 0, points),
                                                              set_up.flow, points, set_up.side)});
    }
    return measurements;
  };
}

Line line(const std::string& key, const std::string& id, const std::string& label,
          const SetUp& set_up, const std::string& defect, Defect plant) {
  return {.key = key,
          .label = label,
          .measure = derivative_errors(set_up, none),
          .claim = Claim{.id = id,
                         .statement = "Pressure, vorticity and strain are exact to 1e-10 at every "
                                      "distance from " +
                                      label + ".",
                         .law = Identity{1e-10},
                         .reason = "two derivatives of functions with N/2 modes amplify rounding "
                                   "by N^2/4, here by up to 7e4, times the density's rounding",
                         .api = {"stokesbook::CauchyCurve", "stokesbook::CauchyDerivativeData",
                                 "stokesbook::near_derivative_corrections"}},
          .control = Control{defect, derivative_errors(set_up, plant)}};
}

}  // namespace

Experiment derivatives() {
  return {.key = "derivatives",
          .title = "Pressure, vorticity and strain by the Cauchy scheme",
          .x = "distance in local spacings δ/h",
          .error = "largest error of the three, relative to the largest strain",
          .lines = {line("ellipse", "06_8", "an ellipse 2:1, 128 nodes", ellipse,
                         "the second derivative left out", no_second_derivative),
                    line("star", "06_9", "a star of five arms, 400 nodes", star,
                         "the turn of the tangent left out", no_tangent),
                    line("slender", "06_10", "the inside of an ellipse 10:1, 512 nodes",
                         slender_container, "derivatives by the parameter", by_the_parameter),
                    line("circle", "06_11", "the inside of a circle, 96 nodes", round_container,
                         "pressure and vorticity of the other sign", other_sign)}};
}

}  // namespace stokesbook::verification::near_singular
