// Applies and assembles the null-space fix N_0 of an enclosing wall (04.6), and computes the net
// flux of the boundary data (04.2).
#include "null_space/null_space.hpp"

#include "double_layer/double_layer.hpp"

namespace stokesbook {

namespace {

// Integrates v . n over a curve.
double flux(const Curve& curve, const ComplexVector& v) {
  return normals(curve).conjugate().cwiseProduct(v).real().dot(weights(curve));
}

}  // namespace

ComplexVector null_space_velocity(const Curve& wall, const ComplexVector& density) {
  // N_0 eta = -n (1 / |Gamma_0|) int n . eta ds (04.6).
  return (-flux(wall, density) / perimeter(wall)) * normals(wall);
}

Eigen::MatrixXd null_space_matrix(const Curve& wall) {
  const Eigen::VectorXd w = weights(wall);
  const ComplexVector normal = normals(wall);
  // The column n times the row -n w / |Gamma_0|.
  return -interleaved(normal) * interleaved(normal.cwiseProduct(w) / w.sum()).transpose();
}

double net_flux(const StokesProblem& problem) {
  // Q = int g . n ds over all curves (04.2); the motion of a free body carries no flux.
  double sum = 0.0;
  for (const Component& component : problem.components) {
    if (component.velocity.size() == 0) continue;
    sum += flux(component.curve, component.velocity);
  }
  return sum;
}

double flux_scale(const StokesProblem& problem) {
  double scale = 0.0;
  for (const Component& component : problem.components) {
    if (component.velocity.size() == 0) continue;
    scale += component.velocity.cwiseAbs().dot(weights(component.curve));
  }
  return scale;
}

}  // namespace stokesbook
