// Computes the stresslet of a component from its density, or from its traction (07.14).
#include "stress/stresslet.hpp"

namespace stokesbook {

Complex body_stresslet(const Curve& curve, const ComplexVector& density, double mu) {
  const ComplexVector weighted_normal = normals(curve).cwiseProduct(weights(curve));
  return -mu * weighted_normal.cwiseProduct(density).sum();
}

Complex stresslet_of_traction(const Curve& curve, Complex centre, const ComplexVector& traction) {
  const ComplexVector force = traction.cwiseProduct(weights(curve));
  return -0.5 * force.cwiseProduct((curve.x.array() - centre).matrix()).sum();
}

}  // namespace stokesbook
