#pragma once

#include "closure/rigid_modes.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// Returns the prescribed rigid motion of a held body or a wall about its position; zero for walls
/// whose velocity is not rigid, and whose curves do not move.
RigidMotion prescribed_motion(const ComponentView& component);

/// Evaluates the velocities that a scene gives at the nodes of a component for the flow amplitude
/// 1: the velocity of the fluid on a wall or held body, or the slip on a free body.
///
/// Equidistant rows of VelocityData are interpolated by a trigonometric polynomial, with an error
/// that falls geometrically for analytic velocities, uneven rows with an error of fourth order.
/// @param  placed  the nodes in the plane, at the pose
/// @return        in the laboratory frame, length / time; empty for a free body without slip
/// @par Cost      O(N); for M rows of VelocityData O(N M)
ComplexVector boundary_velocity(const ComponentView& component, const DiscretisedShape& discretised,
                                const Curve& placed, const Pose& pose);

}  // namespace stokesbook
