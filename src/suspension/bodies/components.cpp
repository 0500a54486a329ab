// Presents the bodies and the walls of a scene as components of one kind (chapter 12).
#include "suspension/bodies/components.hpp"

namespace stokesbook {

std::string ComponentView::name() const {
  return (body != nullptr ? "body " : "wall ") + std::to_string(number);
}

ComponentCounts count_components(const Scene& scene) {
  ComponentCounts counts;
  for (const Body& body : scene.bodies) {
    ++(body.held ? counts.held : counts.free);
    if (std::holds_alternative<Circle>(body.shape)) ++counts.circles;
  }
  for (const Wall& wall : scene.walls) {
    ++(wall.role == WallRole::outer ? counts.outer : counts.inner);
    if (std::holds_alternative<Circle>(wall.shape)) ++counts.circles;
  }
  return counts;
}

ComponentView component_of(const Scene& scene, std::size_t k) {
  if (k < scene.bodies.size()) {
    const Body& body = scene.bodies[k];
    const ComponentKind kind = body.held ? ComponentKind::prescribed : ComponentKind::free_body;
    return {&body, nullptr, k, kind, body.shape, body.n_nodes, {body.position, body.orientation}};
  }
  const std::size_t number = k - scene.bodies.size();
  const Wall& wall = scene.walls[number];
  const ComponentKind kind =
      wall.role == WallRole::outer ? ComponentKind::enclosing_wall : ComponentKind::prescribed;
  return {
      nullptr, &wall, number, kind, wall.shape, wall.n_nodes, {wall.position, wall.orientation}};
}

std::string name_pair(const Scene& scene, std::size_t a, std::size_t b) {
  return component_of(scene, a).name() + " and " + component_of(scene, b).name();
}

std::string name_image_pair(const Scene& scene, std::size_t a, std::size_t b) {
  return component_of(scene, a).name() +
         (a == b ? " and its own image" : " and an image of " + component_of(scene, b).name());
}

Side side_of(ComponentKind kind) {
  return kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
}

}  // namespace stokesbook
