#pragma once

#include "scenes.hpp"

namespace stokesbook::test {

/// Load and flux inside of circles about a centre, measured from the velocity on these circles.
///
/// Averages over a circle of radius r are exact for every Stokes flow in an annulus:
/// <u> = c - F log(r) / (4 pi mu) + d r^2, <u_theta> = A r + L / (4 pi mu r), <u_r> = Q / (2 pi r),
/// with the force F, the torque L about the centre and the flux Q inside the circle. The averages
/// require no derivative, pressure or density, so the measurement does not depend on how a solver
/// computes loads.
struct Enclosed {
  Load load;
  double flux = 0.0;
  double residual = 0.0;  ///< misfit of the three laws on a fourth circle, length / time
};

/// Mean velocity, mean azimuthal and mean radial velocity on a circle.
struct CircleAverage {
  Complex velocity;
  double azimuthal = 0.0, radial = 0.0;
};

CircleAverage circle_average(const Solved& solved, Complex centre, double radius);

/// Measures load and flux from circles in an annulus between two radii, which must lie in the
/// fluid.
Enclosed enclosed_by(const Solved& solved, Complex centre, double inner, double outer);

}  // namespace stokesbook::test
