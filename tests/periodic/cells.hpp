#pragma once

#include <optional>
#include <vector>

#include "closure/rigid_modes.hpp"
#include "fmm/fmm.hpp"
#include "periodic/lattice.hpp"

namespace stokesbook::test {

/// A rigid body in a periodic cell.
struct CellBody {
  Curve curve;
  Complex centre;  ///< centroid of the curve
  Complex force;   ///< on the fluid; of free bodies
  double torque = 0.0;
  std::optional<RigidMotion> held = {};  ///< motion of a held body
};

/// Rigid bodies in a linear flow through periodic cells.
struct Cell {
  Lattice lattice;
  std::vector<CellBody> bodies;
  double viscosity = 1.0;
  double vorticity = 0.0;      ///< of the linear flow
  Complex strain = {};         ///< \f$ e_{11} - e_{22} + 2ie_{12} \f$ of the linear flow
  Complex mean_velocity = {};  ///< u_c, unless the pressure gradient is given
  std::optional<Complex> pressure_gradient = {};  ///< P, with held bodies
  Complex origin = {};                            ///< x_0, where the linear flow is at rest

  Complex linear_velocity(Complex z) const {
    return 0.5 * (imaginary * vorticity * (z - origin) + strain * std::conj(z - origin));
  }
};

/// Motion, load and stresslet of a body in the solution of a cell.
struct CellMotion {
  Complex velocity;
  double omega = 0.0;
  Complex force;
  double torque = 0.0;
  Complex stresslet;
};

/// The solution of a cell.
struct CellSolution {
  std::vector<CellMotion> bodies;
  Complex mean_velocity;
  ComplexVector velocity;  ///< at the targets
};

/// Solves the boundary integral equation of a cell by GMRES, without near corrections.
CellSolution solve(const Cell& cell, const FmmSettings& settings,
                   const ComplexVector& targets = {});

}  // namespace stokesbook::test
