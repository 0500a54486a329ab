#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// The kind of a component of the boundary: its given data and its results.
enum class ComponentKind {
  free_body,       ///< force, torque and slip are given; velocity and omega are results
  prescribed,      ///< the velocity at the nodes is given; force and torque are results (inner
                   ///< walls, held bodies)
  enclosing_wall,  ///< the velocity at the nodes is given; the wall surrounds the fluid
};

/// One closed curve of the boundary with its data.
struct Component {
  ComponentKind kind = ComponentKind::free_body;  ///< given data and results
  Curve curve;                                    ///< nodes in the plane; its side fits the kind
  Complex centre;       ///< c, inside the curve: force acts at c, torque is about c; length
  Complex force;        ///< on the fluid, force / length (free bodies)
  double torque = 0.0;  ///< on the fluid about the centre, force (free bodies)
  /// At the nodes, length / time: the given velocity (prescribed and enclosing_wall), or the slip
  /// relative to the rigid motion (free bodies; empty: no slip).
  ComplexVector velocity;
};

/// Returns true for bodies and inner walls, false for an enclosing wall.
inline bool is_inner(const Component& component) {
  return component.kind != ComponentKind::enclosing_wall;
}

/// Returns whether the fluid slips on a free body.
inline bool has_slip(const Component& component) {
  return component.kind == ComponentKind::free_body && component.velocity.size() > 0;
}

/// A cell of a lattice. The components of a problem repeat with the vectors of the lattice.
struct PeriodicCell {
  Complex a1;  ///< a vector of the lattice, length
  Complex a2;  ///< another vector, not parallel to the first one, length
  /// Mean gradient P of the pressure, force / length^3. With it, the mean velocity over the cell,
  /// bodies included, is a result; without it, that of the background is given.
  std::optional<Complex> pressure_gradient = {};

  double area() const { return std::abs(cross(a1, a2)); }  ///< returns V, length^2
};

/// A boundary value problem of Stokes flow around rigid bodies and walls, at one instant.
struct StokesProblem {
  std::vector<Component> components;  ///< densities are ordered by component, then node
  double viscosity = 1.0;             ///< mu, force time / length^2
  ComplexVector background;  ///< undisturbed velocity at all nodes, length / time; empty if zero
  std::optional<double> gauge_length;     ///< ell of (02.2) in an unbounded fluid, length
  std::optional<PeriodicCell> cell = {};  ///< empty: nothing repeats
};

/// Returns the position of each component's first node in the vector of all nodes, and after them
/// the number of all nodes.
std::vector<Eigen::Index> node_offsets(const StokesProblem& problem);

/// Collects the curves of all components.
std::vector<Curve> curves_of(const StokesProblem& problem);

/// Returns whether a wall encloses the fluid.
bool is_bounded(const StokesProblem& problem);

/// Adds up the forces on the fluid that are given on free bodies, force / length.
Complex total_given_force(const StokesProblem& problem);

/// Returns whether the forces given on free bodies have a sum other than zero: a modulus above
/// 1e-12 times the sum of the moduli, which is more than rounding leaves of forces that balance.
bool has_net_force(const StokesProblem& problem);

/// Returns whether the velocity of the fluid at infinity, Completion::uniform_velocity, is an
/// unknown of the system.
///
/// The velocity at infinity is unknown in an unbounded fluid without a gauge length if a component
/// has a prescribed velocity. The velocity found is the one for which the net force is zero; it
/// cancels any uniform velocity of the background. In a periodic cell, the mean velocity is unknown
/// if the mean gradient of the pressure is given.
bool has_free_uniform_velocity(const StokesProblem& problem);

}  // namespace stokesbook
