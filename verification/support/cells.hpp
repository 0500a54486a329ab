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

/// Makes a free body without loads.
CellBody cell_body(const Shape& shape, Complex centre, double angle, Eigen::Index n);

/// Makes a cell with one free disk of n nodes, which covers a part of the cell's area.
Cell disk_in_a_cell(Complex a1, Complex a2, double area_fraction, Eigen::Index n);

/// Sets the flow u = (y, 0) about the origin of the linear flow.
void set_shear(Cell& cell);

/// Makes a general cell with a general linear flow and three free bodies, whose loads balance.
Cell three_bodies(Eigen::Index n);

/// Makes a unit cell with a held worm that is longer than the cell, and crosses its edges.
Cell worm_in_a_cell(Eigen::Index n);

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
///
/// @param  images  those of images_in() if empty; a plan of images may have a planted defect
/// @throws std::runtime_error when the residual exceeds 1e-12
CellSolution solve(const Cell& cell, const FmmSettings& settings, const ComplexVector& targets = {},
                   FmmImagePlan images = {});

}  // namespace stokesbook::test
