#pragma once

#include "suspension/solver/solver.hpp"
#include "suspension/system/preconditioner.hpp"

namespace stokesbook::test {

/// @name Scenes of bodies that nearly touch, with automatic nodes
/// @{

/// Returns a scene of five disks of radius 1 in a row, in shear.
Scene disk_chain(double gap);

/// Returns a scene of a disk of radius 1 in shear, surrounded by rings of 6, 12, ... equal disks.
/// All neighbours have the same gap. The solver has the given tolerance.
Scene disk_hexagon(int rings, double gap, double tolerance = 1e-6);

/// Returns a scene of disks of radius 1 in shear, at random positions with gaps of at least 0.001.
/// The disks start on a lattice with an area fraction of 0.6. Random moves of one disk at a time
/// then change the positions. The result is the same on every machine.
Scene disk_packing(int count);

/// Returns a scene of disks of radius 1 in the places of boxed_packing() with gaps of at least
/// 0.001, at rest under normally distributed forces, whose sum is zero, and torques. The solver has
/// the tolerance 1e-5.
Scene loaded_packing(int count, double fraction, unsigned seed = 1);

/// Returns a scene of ellipses with the semi-axes 3 and 1 at random in a square box, with gaps of
/// at least 0.001, under the loads of loaded_packing(). The solver has the tolerance 1e-5.
Scene loaded_ellipses(int count, double fraction);

/// Returns a scene of disks of radius 1 in a row, at rest under loads of alternating signs. The
/// solver has the tolerance 1e-5.
Scene loaded_line(int count, double gap);

/// Returns a scene of ellipses with the semi-axes `aspect` and 1, or disks of radius 1, that settle
/// in a round container. The solver has the tolerance 1e-5.
/// @param  fraction  area fraction in the container
/// @param  gap       least gap of two bodies, and of a body and the wall
Scene settling_in_container(double aspect, int count, double fraction, double gap);

/// Returns the start of the published Taylor-Green run of 48 ellipses. The solver has the given
/// tolerance.
Scene ellipses_in_vortices(double tolerance = 1e-4);

/// @}

/// Returns the same scene in a shear flow, without loads.
Scene sheared(Scene scene);

/// Returns the same scene with a minimum separation, which contact maintains.
Scene with_contact(Scene scene, double separation);

/// Returns the same scene with the given preconditioner.
Scene with_preconditioner(Scene scene, PreconditionerKind preconditioner);

/// Holds the linear system of a scene at its start, at the first resolution of the solver.
struct Discretised {
  SuspensionSolver solver;
  Configuration configuration;
  Discretisation discretisation;
  LinearSystem discrete;

  explicit Discretised(const Scene& scene);
  Discretised(const Scene& scene, ClusterForm form);  // preconditioned by clusters of this form
};

}  // namespace stokesbook::test
