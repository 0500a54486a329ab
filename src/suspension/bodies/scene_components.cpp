#include "suspension/bodies/scene_components.hpp"

namespace stokesbook {

std::string component_name(const Scene& scene, std::size_t component) {
  const std::size_t bodies = scene.bodies.size();
  return component < bodies ? "body " + std::to_string(component)
                            : "wall " + std::to_string(component - bodies);
}

int given_nodes(const Scene& scene, std::size_t component) {
  const std::size_t bodies = scene.bodies.size();
  return component < bodies ? scene.bodies[component].n_nodes
                            : scene.walls[component - bodies].n_nodes;
}

}  // namespace stokesbook
