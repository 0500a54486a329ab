#pragma once

#include "suspension/solver/solver.hpp"
#include "suspension/system/clusters.hpp"

namespace stokesbook::test {

/// @name Scenes of bodies that nearly touch, with automatic nodes
/// @{

/// Five disks of radius 1 in a row, in shear.
Scene disk_chain(double gap);

/// A disk of radius 1 among rings of six, twelve, ... that touch their neighbours but for a gap, in
/// shear; resolved to a tolerance.
Scene disk_hexagon(int rings, double gap, double tolerance = 1e-6);

/// Disks of radius 1 at random, with gaps of 0.001 or more, in shear: hard disks at an area
/// fraction of 0.6 after many random moves, the same on every machine.
Scene disk_packing(int count);

/// The 48 ellipses of the published Taylor-Green run at its start, resolved to a tolerance.
Scene ellipses_in_vortices(double tolerance = 1e-4);

/// @}

/// The same scene with a preconditioner.
Scene with_preconditioner(Scene scene, PreconditionerKind preconditioner);

/// The system of a scene's start at the resolution with which its solver begins.
struct Discretised {
  SuspensionSolver solver;
  Configuration configuration;
  Discretisation discretisation;
  LinearSystem discrete;

  explicit Discretised(const Scene& scene);
  Discretised(const Scene& scene, ClusterForm form);  // clusters in this form
};

}  // namespace stokesbook::test
