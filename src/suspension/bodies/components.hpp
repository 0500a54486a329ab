#pragma once

#include <cstddef>
#include <string>

#include "closure/problem.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

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

  /// Names the component for messages and tables: "body 3" or "wall 0".
  std::string name() const;

  /// Returns whether the solver chooses the number of nodes.
  bool has_automatic_nodes() const { return n_nodes == automatic_nodes; }
};

/// The numbers of components of each kind in a scene.
struct ComponentCounts {
  std::size_t free = 0,  ///< free bodies
      held = 0,          ///< held bodies
      inner = 0,         ///< inner walls
      outer = 0,         ///< enclosing walls
      circles = 0;       ///< components of any kind whose shape is a circle

  /// Counts the components of all kinds.
  std::size_t all() const { return free + held + inner + outer; }
};

/// Counts the components of a scene by kind.
ComponentCounts count_components(const Scene& scene);

/// Returns component k of a scene; bodies come first, then walls, in the scene's order.
ComponentView component_of(const Scene& scene, std::size_t k);

/// Names two components of a scene for messages: "body 3 and wall 0".
std::string name_pair(const Scene& scene, std::size_t a, std::size_t b);

/// Names a component and an image of a component in a periodic cell: "body 3 and an image of body
/// 5", "body 3 and its own image".
std::string name_image_pair(const Scene& scene, std::size_t a, std::size_t b);

/// Returns the side of a component's curve on which the fluid lies: inside an enclosing wall,
/// outside all other components.
Side side_of(ComponentKind kind);

}  // namespace stokesbook
