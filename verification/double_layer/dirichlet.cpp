// Solves Dirichlet problems (02.10). The rate of convergence follows from the nearest of three
// singularities: the flow's sources, the targets' preimages, and the shape's own. Also completes
// the layer for a body with force and torque (02.13).
#include "support/dirichlet.hpp"

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

/// Describes a flow with one source of velocity outside the fluid, and the targets of the
/// comparison.
struct Problem {
  Ellipse ellipse;
  Side side;
  Complex source;     ///< complex parameter of the source's place
  double height;      ///< imaginary part of the targets' preimages
  Index oversampled;  ///< nodes of the evaluation relative to those of the solve

  test::ExactFlow flow() const { return {{{continued(ellipse, source), {0.5, -0.3}, 0.0}}}; }
};

const Ellipse four_to_one{4.0, 1.0};
const Problem wall_near{two_to_one, Side::fluid_inside, {0.9, -0.15}, 0.52, 1};
const Problem wall_far{two_to_one, Side::fluid_inside, {0.9, -0.3}, 0.52, 1};
const Problem body_near{two_to_one, Side::fluid_outside, {0.9, 0.2}, -1.0, 1};
const Problem body_centre{two_to_one,
                          Side::fluid_outside,
                          {0.5 * std::numbers::pi, 0.5 * kernel_distance(two_to_one)},
                          -1.2,
                          1};
const Problem slender_wall{four_to_one, Side::fluid_inside, {0.9, -1.2}, 0.2, 16};

ComplexVector evaluate(const Curve& curve, const ComplexVector& density, const Problem& problem) {
  const Index n = problem.oversampled * curve.size();
  return plain_rule(sample(problem.ellipse, n, curve.side), resample(density, n),
                    points_at(problem.ellipse, problem.height));
}

/// Returns the error of the velocity; `layer` returns the matrix of the double layer on a curve.
template <class Layer>
double error_with(const Layer& layer, const Problem& problem, Index n) {
  const test::ExactFlow flow = problem.flow();
  const Curve curve = sample(problem.ellipse, n, problem.side);
  const Eigen::VectorXd density =
      test::solve(test::completed_system(curve, layer(curve)), interleaved(flow.velocity(curve.x)));
  return relative_error(evaluate(curve, deinterleaved(density), problem),
                        flow.velocity(points_at(problem.ellipse, problem.height)));
}

using Error = double (*)(const Problem&, Index);

double error(const Problem& problem, Index n) {
  return error_with([](const Curve& curve) { return double_layer_matrix(curve); }, problem, n);
}

/// A planted defect: the normal points into the fluid, so that the system is that of the curve's
/// other side.
double inward_normal(const Problem& problem, Index n) {
  Problem other = problem;
  other.side = problem.side == Side::fluid_inside ? Side::fluid_outside : Side::fluid_inside;
  return error(other, n);
}

/// A planted defect: the diagonal has the opposite sign of the curvature.
double wrong_diagonal(const Problem& problem, Index n) {
  return error_with(with_wrong_diagonal, problem, n);
}

Line source_line(const std::string& key, const std::string& id, const std::string& label,
                 const Problem& problem, double rate, double power, const std::string& reason,
                 const std::string& defect, Error defective) {
  return {
      .key = key,
      .label = label,
      .measure = errors_at(rate, [=](Index n) { return error(problem, n); }),
      .claim = Claim{.id = id,
                     .statement = "A Dirichlet problem, " + label +
                                  ", converges at the rate of the nearest singularity.",
                     .law = Geometric{rate, 0.03, power},
                     .window = {.from = 4.0 / rate, .floor = 1e-14},
                     .reason = reason,
                     .api = {"stokesbook::double_layer_matrix"}},
      .control = Control{defect, errors_at(rate, [=](Index n) { return defective(problem, n); })}};
}

/// @name A body that exerts a force and a torque
/// @{
constexpr double viscosity = 1.3, gauge = 1.0;
const Complex load_point = continued(two_to_one, {0.9, 0.2}), load_force{1.0, 0.5};
constexpr double load_torque = -0.7;

Complex loaded_flow(Complex z) {
  return stokeslet(z - load_point, load_force, viscosity, gauge) +
         rotlet(z - load_point, load_torque, viscosity);
}

/// Returns the Stokeslet and the rotlet at the centre of the body with the same force and torque,
/// times a factor.
Complex completing_flow(Complex z, double factor) {
  return factor * (stokeslet(z, load_force, viscosity, gauge) +
                   rotlet(z, load_torque + cross(load_point, load_force), viscosity));
}

double error_of_completion(Index n, double factor) {
  const Curve body = sample(two_to_one, n, Side::fluid_outside);
  const auto remainder = [=](Complex z) { return loaded_flow(z) - completing_flow(z, factor); };
  const ComplexVector density = test::density_of(body, body.x.unaryExpr(remainder));
  const ComplexVector targets = points_at(two_to_one, -1.0);
  return relative_error(plain_rule(body, density, targets) + targets.unaryExpr([=](Complex z) {
    return completing_flow(z, factor);
  }),
                        targets.unaryExpr(&loaded_flow));
}

Measure errors_of_completion(double factor) {
  return errors_at(0.2, [=](Index n) { return error_of_completion(n, factor); });
}
/// @}

}  // namespace

Experiment dirichlet() {
  const std::string source_reason = "the boundary data have a double pole at the source's preimage";
  return {
      .key = "dirichlet",
      .title = "Dirichlet problems with a source at a known place",
      .x = "nodes N",
      .error = "error of the velocity, relative to the largest",
      .axes = Axes::semi_log,
      .lines = {source_line("wall_near", "02_19", "inside 2:1, source at distance 0.15", wall_near,
                            0.15, 1.0, source_reason, "the normal into the fluid", inward_normal),
                source_line("wall_far", "02_20", "inside 2:1, source at distance 0.3", wall_far,
                            0.3, 1.0, source_reason,
                            "the diagonal with the other sign of the curvature", wrong_diagonal),
                source_line("body_near", "02_21", "outside 2:1, source at distance 0.2", body_near,
                            0.2, 1.0, source_reason, "the normal into the fluid", inward_normal),
                source_line("body_centre", "02_22", "outside 2:1, source at the centre",
                            body_centre, 0.5 * kernel_distance(two_to_one), 1.0,
                            "no point inside has preimages farther away than half of ln(1/m)",
                            "the diagonal with the other sign of the curvature", wrong_diagonal),
                source_line("slender", "02_23", "inside 4:1, source at distance 1.2", slender_wall,
                            kernel_distance(four_to_one), 1.0,
                            "the shape itself: the kernel's double pole at ln(1/m)",
                            "the diagonal with the other sign of the curvature", wrong_diagonal)}};
}

Experiment completion() {
  return {
      .key = "completion",
      .title = "A body that exerts a force and a torque",
      .x = "nodes N",
      .error = "error of the velocity, relative to the largest",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "completed",
           .label = "double layer, Stokeslet and rotlet",
           .measure = errors_of_completion(1.0),
           .claim = Claim{.id = "02_24",
                          .statement = "Completed by a Stokeslet and a rotlet the double layer "
                                       "represents flows with force and torque.",
                          .law = Geometric{0.2, 0.03},
                          .window = {.from = 20.0, .floor = 1e-14},
                          .reason = "the boundary data have a simple pole and a logarithm at "
                                    "the distance 0.2 of the load's preimage",
                          .api = {"stokesbook::stokeslet", "stokesbook::rotlet"}},
           .control = Control{"1 in place of 1/(4 pi mu)",
                              errors_of_completion(4.0 * std::numbers::pi * viscosity)}},
          {.key = "alone", .label = "double layer alone", .measure = errors_of_completion(0.0)}}};
}

}  // namespace stokesbook::verification::double_layer
