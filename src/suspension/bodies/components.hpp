#pragma once

#include <cstddef>
#include <string>

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The properties that bodies and walls of a scene have in common. The view refers to the scene,
/// which must outlive the view.
struct ComponentView {
  const Body* body;    ///< null for a wall
  const Wall* wall;    ///< null for a body
  std::size_t number;  ///< among the bodies or among the walls, from 0
  ComponentKind kind;  ///< free_body, prescribed or enclosing_wall
  const Shape& shape;  ///< in its own frame
  int n_nodes;         ///< number of nodes given in the scene, or automatic_nodes
  Pose start;          ///< pose at the start

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
/// @return       inside for an enclosing wall, outside for all other components
Side side_of(ComponentKind kind);

/// Returns the prescribed rigid motion of a held body or a wall.
///
/// @param  component  held body or wall
/// @return            motion about the component's position; zero for fixed walls, and for walls
///                    with a LinearWall or RadialWall velocity, whose curves do not move
RigidMotion prescribed_motion(const ComponentView& component);

/// Evaluates the prescribed velocity of a held body or a wall at its nodes.
///
/// @param  component  held body or wall
/// @param  curve      N placed nodes
/// @param  position   of the component, the centre of its rotation, length
/// @return            velocities at the N nodes, length / time
ComplexVector prescribed_velocity(const ComponentView& component, const Curve& curve,
                                  Complex position);

/// @}

}  // namespace stokesbook
