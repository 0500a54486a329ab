#pragma once

#include <cstddef>
#include <string>

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// A body or a wall of a scene, by what all components have. It refers to the scene, which must
/// outlive it.
struct ComponentView {
  const Body* body;    ///< none for a wall
  const Wall* wall;    ///< none for a body
  std::size_t number;  ///< among the bodies or among the walls, from 0
  ComponentKind kind;  ///< free_body, prescribed or enclosing_wall
  const Shape& shape;  ///< in its own frame
  int n_nodes;         ///< as the scene gives it, or automatic_nodes
  Pose start;          ///< where the component is at the start

  /// Names the component for messages and tables.
  /// @return "body 3" or "wall 0"
  std::string name() const;

  /// Returns whether the solver chooses the number of nodes.
  /// @return true for automatic_nodes
  bool has_automatic_nodes() const { return n_nodes == automatic_nodes; }
};

/// Counts the components of a scene.
///
/// @param  scene  of bodies and walls
/// @return        number of bodies and walls
std::size_t count_components(const Scene& scene);

/// Returns a component of a scene.
///
/// @param  scene  of bodies and walls
/// @param  k      bodies first, then walls, in the scene's order
/// @return        the component
ComponentView component_of(const Scene& scene, std::size_t k);

/// Returns the side of a component's curve on which the fluid lies.
///
/// @param  kind  of the component
/// @return       inside of an enclosing wall, outside of all else
Side side_of(ComponentKind kind);

/// Returns the rigid motion that a held body or a wall is given.
///
/// @param  component  that is not free
/// @return            motion about the component's position; zero for fixed walls and for motions
///                    that leave the curve in place
RigidMotion prescribed_motion(const ComponentView& component);

/// Evaluates the velocity that a held body or a wall is given at its nodes.
///
/// @param  component  that is not free
/// @param  curve      N placed nodes
/// @param  position   of the component, about which it rotates, length
/// @return            velocities at the N nodes, length / time
ComplexVector prescribed_velocity(const ComponentView& component, const Curve& curve,
                                  Complex position);

/// @}

}  // namespace stokesbook
