// Exercise 02.3: which mistake is in a double layer's matrix?
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "double_layer/double_layer.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: the mean of v.(D v) over the curve, v = (1, 0).
double share(const Curve& curve, const Eigen::MatrixXd& matrix) {
  //@ starter
  not_done(curve, matrix);  // your code instead of this line
  //@ solution
  const ComplexVector v = ComplexVector::Ones(curve.size());
  const Eigen::VectorXd velocity = matrix * interleaved(v);
  return weights(curve).dot(deinterleaved(velocity).real()) / perimeter(curve);
  //@ wrong unweighted: this is the mean over the nodes
  const ComplexVector v = ComplexVector::Ones(curve.size());
  const Eigen::VectorXd velocity = matrix * interleaved(v);
  return deinterleaved(velocity).real().mean();
  //@ end
}

// Task 2: largest modulus of D v + s v/2, v = (1, 0), where the curvature has the wrong sign.
double sign_error(const Curve& curve) {
  //@ starter
  not_done(curve);  // your code instead of this line
  //@ solution
  const Eigen::VectorXd w = weights(curve), kappa = curvatures(curve);
  double largest = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) {
    const double along = curve.dx[j].real() / std::abs(curve.dx[j]);
    largest = std::max(largest, std::abs(kappa[j] * along) * w[j] / pi);
  }
  return largest;
  //@ wrong once: this is the error of a missing diagonal
  const Eigen::VectorXd w = weights(curve), kappa = curvatures(curve);
  double largest = 0.0;
  for (Eigen::Index j = 0; j < curve.size(); ++j) {
    const double along = curve.dx[j].real() / std::abs(curve.dx[j]);
    largest = std::max(largest, std::abs(kappa[j] * along) * w[j] / (2.0 * pi));
  }
  return largest;
  //@ end
}

// Task 3: the density that -1/2 + D of an ellipse takes to zero, D with the wrong normal; its
// largest modulus is 1.
ComplexVector invisible_density(const Curve& body) {
  //@ starter
  not_done(body);  // your code instead of this line
  //@ solution
  return imaginary * body.dx / body.dx.cwiseAbs().maxCoeff();
  //@ wrong normal: on an ellipse |x'| is missing
  return normals(body);
  //@ wrong rigid_motion: rigid motions are what the right normal is blind to
  return ComplexVector::Ones(body.size());
  //@ wrong tangent: this is the tangent
  return body.dx.cwiseQuotient(body.dx.cwiseAbs());
  //@ end
}

// Task 4: "right", "normal", "pi", "curvature" or "diagonal".
std::string diagnose(const Curve& curve, const Eigen::MatrixXd& matrix) {
  //@ starter
  not_done(curve, matrix);  // your code instead of this line
  //@ solution
  const double ratio = share(curve, matrix) / (-0.5 * curve.sign());
  if (ratio < 0.0) return "normal";
  if (ratio > 2.0) return "pi";
  const ComplexVector v = ComplexVector::Ones(curve.size());
  const Eigen::VectorXd residual = matrix * interleaved(v) + 0.5 * curve.sign() * interleaved(v);
  const double size = deinterleaved(residual).cwiseAbs().maxCoeff() / sign_error(curve);
  return size > 0.75 ? "curvature" : size > 0.25 ? "diagonal" : "right";
  //@ wrong bodies_only: found normal, but the mistake is right
  const double ratio = share(curve, matrix) / 0.5;
  if (ratio < 0.0) return "normal";
  if (ratio > 2.0) return "pi";
  const ComplexVector v = ComplexVector::Ones(curve.size());
  const Eigen::VectorXd residual = matrix * interleaved(v) - 0.5 * interleaved(v);
  const double size = deinterleaved(residual).cwiseAbs().maxCoeff() / sign_error(curve);
  return size > 0.75 ? "curvature" : size > 0.25 ? "diagonal" : "right";
  //@ wrong coarse: found right, but the mistake is curvature
  const double ratio = share(curve, matrix) / (-0.5 * curve.sign());
  return ratio < 0.0 ? "normal" : ratio > 2.0 ? "pi" : "right";
  //@ end
}
