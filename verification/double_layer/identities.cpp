// Tests the double layer of rigid motions, which is 1, 1/2 or 0 times the motion (02.7), and the
// flux that the layer carries (02.11).
#include "double_layer/double_layer.hpp"
#include "experiments.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

const Ellipse three_to_one{3.0, 1.0};

Curve body(Index n) {
  return sample(three_to_one, n, Side::fluid_outside);
}

ComplexVector rigid_motion(const ComplexVector& x) {
  return (Complex{0.6, -0.8} + 1.5 * imaginary * (x.array() - Complex{0.3, 0.2})).matrix();
}

/// Returns the error of D v = share * v off the curve, relative to the largest v on the curve.
double error_off_curve(const Curve& curve, const ComplexVector& v, double height, double share) {
  const ComplexVector targets = points_at(three_to_one, height);
  return test::largest(plain_rule(curve, v, targets) - share * rigid_motion(targets)) /
         test::largest(v);
}

double error_off_curve(Index n, double height, double share) {
  return error_off_curve(body(n), rigid_motion(body(n).x), height, share);
}

/// A planted defect: the normal points out of the body.
double error_with_turned_normal(Index n, double height, double share) {
  Curve turned = body(n);
  turned.side = Side::fluid_inside;
  return error_off_curve(turned, rigid_motion(turned.x), height, share);
}

/// A planted defect: the first node counts twice.
double error_with_node_twice(Index n, double height, double share) {
  ComplexVector v = rigid_motion(body(n).x);
  v[0] *= 2.0;
  return error_off_curve(body(n), v, height, share);
}

/// Returns the error of D v = v/2 on the curve, by the matrix of D.
double error_on_curve(const Curve& curve, const Eigen::MatrixXd& layer) {
  const ComplexVector v = rigid_motion(curve.x);
  const Eigen::VectorXd velocity = layer * interleaved(v);
  return relative_error(deinterleaved(velocity), 0.5 * v);
}

/// Returns the error of the flux of jump * eta + D eta, which must be -int eta.n (02.11): the
/// largest over all densities |eta| <= 1 at the nodes, relative to the length of the curve.
double flux_error(Index n, double jump) {
  const Curve curve = body(n);
  const ComplexVector weighted_normal = normals(curve).cwiseProduct(weights(curve));
  const Eigen::VectorXd flux = interleaved(weighted_normal);
  const Eigen::VectorXd difference =
      (jump + 1.0) * flux + double_layer_matrix(curve).transpose() * flux;
  return deinterleaved(difference).cwiseAbs().sum() / perimeter(curve);
}

Claim rigid_claim(const std::string& id, const std::string& statement, double rate,
                  const std::string& reason) {
  return {.id = id,
          .statement = statement,
          .law = Geometric{rate, 0.03, 1.0},
          .window = {.from = 4.0 / rate, .floor = 1e-15},
          .reason = reason,
          .api = {"stokesbook::double_layer_matrix"}};
}

}  // namespace

Experiment identities() {
  constexpr double inside = 0.2, outside = -0.4;
  const double kernel = kernel_distance(three_to_one);
  return {
      .key = "identities",
      .title = "Rigid motions and flux, body 3:1",
      .x = "nodes N",
      .error = "largest error, relative to the largest density",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "inside",
           .label = "D v = v inside the body",
           .measure = errors_at(inside, [](Index n) { return error_off_curve(n, inside, 1.0); }),
           .claim = rigid_claim("02_11",
                                "A rigid motion's double layer is the motion inside a body, with "
                                "the error N e^{-0.2 N} of targets at distance 0.2.",
                                inside, "Gauss' identity of the stresslet; preimage at 0.2"),
           .control = Control{"the normal out of the body",
                              errors_at(inside,
                                        [](Index n) {
                                          return error_with_turned_normal(n, inside, 1.0);
                                        })}},
          {.key = "outside",
           .label = "D v = 0 in the fluid",
           .measure = errors_at(-outside, [](Index n) { return error_off_curve(n, outside, 0.0); }),
           .claim = rigid_claim("02_12",
                                "A rigid motion's double layer is zero in the fluid, with the "
                                "error N e^{-0.4 N} of targets at distance 0.4.",
                                -outside, "Gauss' identity of the stresslet; preimage at 0.4"),
           .control =
               Control{"the first node counted twice",
                       errors_at(-outside,
                                 [](Index n) { return error_with_node_twice(n, outside, 0.0); })}},
          {.key = "on",
           .label = "D v = v/2 on the curve",
           .measure = errors_at(
               kernel,
               [](Index n) { return error_on_curve(body(n), double_layer_matrix(body(n))); }),
           .claim = rigid_claim("02_13",
                                "On an ellipse it is half of the motion, with an error N m^N, "
                                "m = (a - b) / (a + b).",
                                kernel,
                                "the kernel of an ellipse has a double pole at the "
                                "distance ln(1/m)"),
           .control = Control{"the diagonal with the other sign of the curvature",
                              errors_at(kernel,
                                        [](Index n) {
                                          return error_on_curve(body(n),
                                                                with_wrong_diagonal(body(n)));
                                        })}},
          {.key = "flux",
           .label = "flux of the limit, worst density",
           .measure = errors_at(kernel, [](Index n) { return flux_error(n, -0.5); }),
           .claim = rigid_claim("02_14",
                                "A body's double layer carries the flux -int eta.n for any "
                                "density, smooth or not.",
                                kernel,
                                "the normal is a left eigenvector of D; one integration "
                                "over targets, whose kernel has the same poles"),
           .control = Control{"the jump of the other side",
                              errors_at(kernel, [](Index n) { return flux_error(n, 0.5); })}}}};
}

}  // namespace stokesbook::verification::double_layer
