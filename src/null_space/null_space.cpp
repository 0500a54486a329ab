// Applies and assembles the null-space fix N_0 of an enclosing wall (04.6), and computes the net
// flux of the boundary data (04.2).
#include "null_space/null_space.hpp"

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;

ComplexVector null_space_velocity(const Curve& wall, const ComplexVector& density) {
  const Eigen::VectorXd w = weights(wall);
  const ComplexVector normal = normals(wall);
  // N_0 eta = -n (1 / |Gamma_0|) int n . eta ds (04.6).
  const double flux = (normal.conjugate().cwiseProduct(density)).real().dot(w);
  return (-flux / w.sum()) * normal;
}

Eigen::MatrixXd null_space_matrix(const Curve& wall) {
  const Eigen::VectorXd w = weights(wall);
  const ComplexVector normal = normals(wall);
  // The column n times the row -n w / |Gamma_0|.
  const ComplexVector weighted = normal.cwiseProduct(w) / w.sum();
  return -interleaved(normal) * interleaved(weighted).transpose();
}

double net_flux(const StokesProblem& problem) {
  // Q = int g . n ds over all curves (04.2); the motion of a free body carries no flux.
  double flux = 0.0;
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) continue;
    const ComplexVector normal = normals(component.curve);
    flux +=
        (normal.conjugate().cwiseProduct(component.velocity)).real().dot(weights(component.curve));
  }
  return flux;
}

double flux_scale(const StokesProblem& problem) {
  double scale = 0.0;
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) continue;
    scale += component.velocity.cwiseAbs().dot(weights(component.curve));
  }
  return scale;
}

}  // namespace stokesbook
