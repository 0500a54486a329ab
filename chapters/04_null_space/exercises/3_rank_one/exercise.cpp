// Exercise 04.3: matrices of rank one, added to a singular system.
#include "chapters/exercise.hpp"

#include <cmath>
#include <string>

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::not_done;

// Given: a vector of all nodes from the vectors of component 0, the circle, and 1, the wall.
ComplexVector both(const ComplexVector& circle, const ComplexVector& wall) {
  ComplexVector all(circle.size() + wall.size());
  all << circle, wall;
  return all;
}

// Task 1: \int n . (A n_k) ds / |Gamma_k|.
double share(const StokesProblem& problem, const Eigen::MatrixXd& matrix, std::size_t k) {
  //@ starter
  not_done(problem, matrix, k);  // your code instead of this line
  //@ solution
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector left = both(normals(circle).cwiseProduct(weights(circle)),
                                  normals(wall).cwiseProduct(weights(wall)));
  ComplexVector right = both(normals(circle), normals(wall));
  if (k == 0) right.tail(wall.size()).setZero();
  if (k == 1) right.head(circle.size()).setZero();
  const Eigen::VectorXd image = matrix * interleaved(right);
  return interleaved(left).dot(image) / perimeter(problem.components[k].curve);
  //@ wrong own_curve: the integral is over both curves
  const Curve& curve = problem.components[k].curve;
  const Index size = 2 * curve.size(), first = k == 0 ? 0 : matrix.rows() - size;
  const ComplexVector right = normals(curve), left = right.cwiseProduct(weights(curve));
  const Eigen::VectorXd image = matrix.block(first, first, size, size) * interleaved(right);
  return interleaved(left).dot(image) / perimeter(curve);
  //@ wrong integral: this is the integral, not divided by the length
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector left = both(normals(circle).cwiseProduct(weights(circle)),
                                  normals(wall).cwiseProduct(weights(wall)));
  ComplexVector right = both(normals(circle), normals(wall));
  if (k == 0) right.tail(wall.size()).setZero();
  if (k == 1) right.head(circle.size()).setZero();
  const Eigen::VectorXd image = matrix * interleaved(right);
  return interleaved(left).dot(image);
  //@ end
}

// Task 2: a matrix of rank one that leaves the system singular.
Eigen::MatrixXd useless(const StokesProblem& problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector tangent = imaginary * normals(wall);
  const ComplexVector column = both(ComplexVector::Zero(circle.size()), tangent);
  const ComplexVector row = both(ComplexVector::Zero(circle.size()),
                                 normals(wall).cwiseProduct(weights(wall)) / perimeter(wall));
  return interleaved(column) * interleaved(row).transpose();
  //@ wrong nothing: this adds nothing
  const Index size = 2 * node_offsets(problem).back();
  return Eigen::MatrixXd::Zero(size, size);
  //@ wrong n0: this repairs the system
  const Index size = 2 * node_offsets(problem).back();
  const Curve& wall = problem.components[1].curve;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  matrix.bottomRightCorner(2 * wall.size(), 2 * wall.size()) = null_space_matrix(wall);
  return matrix;
  //@ wrong full_rank: this has more than one independent column
  const Index size = 2 * node_offsets(problem).back();
  return Eigen::MatrixXd::Identity(size, size);
  //@ end
}

// Task 3: a matrix of rank one that takes the net flux off on the circle.
Eigen::MatrixXd elsewhere(const StokesProblem& problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector column = both(-normals(circle), ComplexVector::Zero(wall.size()));
  const ComplexVector row = both(ComplexVector::Zero(circle.size()),
                                 normals(wall).cwiseProduct(weights(wall)) / perimeter(circle));
  return interleaved(column) * interleaved(row).transpose();
  //@ wrong row_on_circle: the row does not see the invisible density
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector column = both(-normals(circle), ComplexVector::Zero(wall.size()));
  const ComplexVector row = both(normals(circle).cwiseProduct(weights(circle)) / perimeter(circle),
                                 ComplexVector::Zero(wall.size()));
  return interleaved(column) * interleaved(row).transpose();
  //@ wrong n0: this takes the flux off on the wall
  const Index size = 2 * node_offsets(problem).back();
  const Curve& wall = problem.components[1].curve;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  matrix.bottomRightCorner(2 * wall.size(), 2 * wall.size()) = null_space_matrix(wall);
  return matrix;
  //@ wrong everywhere: this takes the flux off on both curves
  const Curve &circle = problem.components[0].curve, &wall = problem.components[1].curve;
  const ComplexVector column = both(-normals(circle), -normals(wall));
  const ComplexVector row = both(ComplexVector::Zero(circle.size()),
                                 normals(wall).cwiseProduct(weights(wall)) / perimeter(wall));
  return interleaved(column) * interleaved(row).transpose();
  //@ end
}

// Task 4: "nothing", "right", "sign", "unscaled" or "inner".
std::string diagnose(const StokesProblem& problem, const Eigen::MatrixXd& matrix) {
  //@ starter
  not_done(problem, matrix);  // your code instead of this line
  //@ solution
  const double circle = share(problem, matrix, 0), wall = share(problem, matrix, 1);
  const auto near = [](double x, double y) { return std::abs(x - y) < 0.1; };
  if (near(circle, -1.0)) return "inner";
  if (near(wall, 0.0)) return "nothing";
  if (near(wall, -1.0)) return "right";
  return wall > 0.0 ? "sign" : "unscaled";
  //@ wrong wall_only: found nothing, but it was inner
  const double wall = share(problem, matrix, 1);
  const auto near = [](double x, double y) { return std::abs(x - y) < 0.1; };
  if (near(wall, 0.0)) return "nothing";
  if (near(wall, -1.0)) return "right";
  return wall > 0.0 ? "sign" : "unscaled";
  //@ wrong regular_is_right: found right, but it was sign
  const double circle = share(problem, matrix, 0), wall = share(problem, matrix, 1);
  if (std::abs(circle + 1.0) < 0.1) return "inner";
  return std::abs(wall) < 0.1 ? "nothing" : "right";
  //@ end
}
