#pragma once

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Returns the kind of boundary component that a body is.
///
/// @param  body  free or held
/// @return       free_body or prescribed
ComponentKind kind_of(const Body& body);

/// Returns the kind of boundary component that a wall is.
///
/// @param  wall  outer or inner
/// @return       enclosing_wall or prescribed
ComponentKind kind_of(const Wall& wall);

/// Returns the side of a component's curve on which the fluid lies.
///
/// @param  kind  of the component
/// @return       inside of an enclosing wall, outside of all else
Side side_of(ComponentKind kind);

/// Evaluates a wall's velocity at its nodes.
///
/// @param  motion    kind and strength
/// @param  curve     N placed nodes
/// @param  position  of the wall, about which it rotates, length
/// @return           velocities at the N nodes, length / time
ComplexVector wall_velocity(const WallMotion& motion, const Curve& curve, Complex position);

/// Returns the rigid motion that carries a wall.
///
/// @param  motion  kind and strength
/// @return         motion about the wall's position; zero for fixed walls and for motions that
///                 leave the curve in place
RigidMotion rigid_motion(const WallMotion& motion);

/// Returns how an undisturbed flow carries a body.
///
/// @param  flow    kind and strength
/// @param  centre  of the body, length
/// @return         velocity and turn of the flow at the centre
RigidMotion carried_by(const BackgroundFlow& flow, Complex centre);

/// Returns what is left of an undisturbed flow on a free body without carried_by(). What a solver
/// solves for depends on this part only, so that its accuracy does not depend on how fast the flow
/// carries the body.
///
/// @param  flow  kind and strength
/// @param  body  its curve of N nodes and its centre
/// @return       velocities at the N nodes, length / time
ComplexVector strain_on(const BackgroundFlow& flow, const Component& body);

/// @}

}  // namespace stokesbook
