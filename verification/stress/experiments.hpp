#pragma once

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "study/study.hpp"
#include "support/exact_derivatives.hpp"
#include "support/once.hpp"
#include "support/over_nodes.hpp"
#include "support/solved_flow.hpp"

namespace stokesbook::verification::stress {

using std::numbers::pi;
using test::linear_velocity;
using test::Once;

/// @name Experiments of the study
/// @{
study::Experiment methods_on_the_surface();
study::Experiment rates_on_the_surface();
study::Experiment distances();
study::Experiment spacings();
study::Experiment loads_of_tractions();
study::Experiment eccentric();
study::Experiment dissipation_of_gaps();
study::Experiment quadrature();
study::Experiment stresslets();
study::Experiment orbits();
study::Experiment aspect_ratios();
study::Experiment excess();
study::Experiment container();
study::Experiment dilute();
/// @}

inline constexpr double viscosity = 1.3;  ///< of the fluid, where it matters

/// Measures a number at each of the points, the same in a quick study and a full one.
template <class Number>
study::Measure over(const std::vector<double>& points, const Number& number) {
  return [=](study::Size) {
    std::vector<study::Measurement> measurements;
    for (const double x : points) measurements.push_back({.x = x, .error = number(x)});
    return measurements;
  };
}

/// Returns the sum over all components.
inline double total(const std::vector<double>& terms) {
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

/// Returns the point inside an ellipse whose preimage under z = (a + b) / 2 (w + m / w), m = (a -
/// b) / (a + b), is at the depth d inside the unit circle, |w| = e^{-d}.
inline Complex point_at_depth(const Ellipse& ellipse, double depth, double angle) {
  const Complex w = std::polar(std::exp(-depth), angle);
  return 0.5 * ((ellipse.a + ellipse.b) * w + (ellipse.a - ellipse.b) / w);
}

/// A planted defect: the pseudo-traction -p n + mu du/dn instead of the traction. Its force is
/// right, but its torque is wrong. In complex notation 2 du/dn = q conj(n) + i w n.
inline ComplexVector pseudo_traction(const StokesProblem& problem,
                                     const std::vector<FlowDerivatives>& at_nodes) {
  ComplexVector result(node_offsets(problem).back());
  Eigen::Index i = 0;
  for (const Component& component : problem.components) {
    for (const Complex n : normals(component.curve)) {
      const FlowDerivatives& at = at_nodes[static_cast<std::size_t>(i)];
      result[i++] =
          problem.viscosity *
          (-at.pressure * n + 0.5 * (at.strain * std::conj(n) + imaginary * at.vorticity * n));
    }
  }
  return result;
}

}  // namespace stokesbook::verification::stress
