#pragma once

#include "suspension/solver/solver.hpp"
#include "suspension/system/preconditioner.hpp"

namespace stokesbook::test {

/// @name Scenes of bodies that nearly touch, with automatic nodes
/// @{

/// Five disks of radius 1 in a row, in shear.
Scene disk_chain(double gap);

/// A disk of radius 1 surrounded by rings of 6, 12, ... disks, in shear, solved to a tolerance.
/// Neighbours are a gap apart.
Scene disk_hexagon(int rings, double gap, double tolerance = 1e-6);

/// Disks of radius 1 at random places, with gaps of at least 0.001, in shear: hard disks at an area
/// fraction of 0.6 after many random moves, the same on every machine.
Scene disk_packing(int count);

/// The start of the published Taylor-Green run of 48 ellipses, solved to a tolerance.
Scene ellipses_in_vortices(double tolerance = 1e-4);

/// @}

/// The same scene with a preconditioner.
Scene with_preconditioner(Scene scene, PreconditionerKind preconditioner);

/// The linear system of a scene's start, at the resolution with which its solver begins.
struct Discretised {
  SuspensionSolver solver;
  Configuration configuration;
  Discretisation discretisation;
  LinearSystem discrete;

  explicit Discretised(const Scene& scene);
  Discretised(const Scene& scene, ClusterForm form);  // preconditioned by clusters of this form
};

}  // namespace stokesbook::test
