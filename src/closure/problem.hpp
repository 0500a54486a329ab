#pragma once

#include <optional>
#include <vector>

#include "trapezoid/curve.hpp"

namespace stokesbook {

/// @addtogroup closure
/// @{

/// What is given on a component of the boundary, and what comes out.
enum class ComponentKind {
  free_body,       ///< force and torque given; velocity and omega come out
  prescribed,      ///< velocity given at the nodes; force and torque come out (inner walls, held
                   ///< bodies)
  enclosing_wall,  ///< velocity given at the nodes; it surrounds the fluid
};

/// One closed curve of the boundary with its data.
struct Component {
  ComponentKind kind = ComponentKind::free_body;  ///< what is given
  Curve curve;                                    ///< placed nodes; side fits the kind
  Complex centre;          ///< c, inside the curve: forces act here, torques are about it; length
  Complex force;           ///< on the fluid, force / length (free bodies)
  double torque = 0.0;     ///< on the fluid about the centre, force (free bodies)
  ComplexVector velocity;  ///< at the nodes, length / time (prescribed and enclosing_wall)
};

/// A boundary value problem of Stokes flow around rigid bodies and walls, at one instant.
struct StokesProblem {
  std::vector<Component> components;  ///< densities are ordered by component, then node
  double viscosity = 1.0;             ///< mu, force time / length^2
  ComplexVector background;  ///< undisturbed velocity at all nodes, length / time; empty: none
  std::optional<double> gauge_length;  ///< unbounded fluid: Stokeslets are -log(r / gauge_length)
};

/// Returns the position of each component's first node in the vector of all nodes.
///
/// @param  problem  components in order
/// @return          one entry a component, and one more with the number of all nodes
std::vector<Eigen::Index> node_offsets(const StokesProblem& problem);

/// Collects the curves of all components.
///
/// @param  problem  components in order
/// @return          one entry a component
std::vector<Curve> curves_of(const StokesProblem& problem);

/// Tells whether a wall encloses the fluid.
///
/// @param  problem  its components
/// @return          true when one is an enclosing wall
bool is_bounded(const StokesProblem& problem);

/// Adds up the forces given on free bodies.
///
/// @param  problem  its components
/// @return          total force on the fluid, force / length
Complex total_given_force(const StokesProblem& problem);

/// Tells whether the forces given on free bodies have a sum other than zero.
///
/// @param  problem  its components
/// @return          true when the sum exceeds 1e-12 of the forces' magnitudes added up, more than
///                  rounding leaves of forces that balance
bool has_net_force(const StokesProblem& problem);

/// Tells whether the velocity of the fluid at infinity is an unknown: that is so in an unbounded
/// fluid without a gauge length where a velocity is prescribed. It takes the value for which the
/// net force is zero, and cancels any uniform velocity of the background.
///
/// @param  problem  its components
/// @return          true when Completion::uniform_velocity is solved for
bool has_free_uniform_velocity(const StokesProblem& problem);

/// @}

}  // namespace stokesbook
