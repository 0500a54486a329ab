// Sums the stresslets at the nodes of many curves, by the fast multipole method and directly, and
// compares the sums (chapter 08).

#include <iostream>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"

int main() {
  using namespace stokesbook;
  const Curve ellipse = sample(Ellipse{.a = 0.4, .b = 0.2}, 64, Side::fluid_outside);
  std::vector<Curve> curves;
  for (int k = 0; k < 100; ++k) {
    curves.push_back(place(ellipse, Complex(k % 10, k / 10), 0.3 * k));
  }
  const ComplexVector density = all_nodes(curves).array().sin();

  const double tolerance = 1e-9;
  const Fmm fast_sum(curves, ComplexVector(), FmmSettings::for_tolerance(tolerance));
  const ComplexVector velocity = fast_sum.velocity(density);  // once per density
  const ComplexVector direct = StressletSum(curves)(density);
  const double error = (velocity - direct).norm() / direct.norm();
  std::cout << density.size() << " nodes, relative error " << error << '\n';
  return error < tolerance ? 0 : 1;
}
