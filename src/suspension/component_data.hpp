#pragma once

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Kind of boundary component that a body is.
ComponentKind kind_of(const Body& body);

/// Kind of boundary component that a wall is.
ComponentKind kind_of(const Wall& wall);

/// Evaluates a wall's velocity at its nodes.
///
/// @param  motion    kind and strength
/// @param  curve     placed nodes
/// @param  position  of the wall, about which it rotates, length
/// @return           velocities, length / time
ComplexVector wall_velocity(const WallMotion& motion, const Curve& curve, Complex position);

/// Returns the rigid motion that carries a wall; zero for fixed walls and for motions that leave
/// the curve in place.
RigidMotion rigid_motion(const WallMotion& motion);

/// @}

}  // namespace stokesbook
