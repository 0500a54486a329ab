// Presents the bodies and the walls of a scene as components of one kind, and evaluates the
// prescribed velocities of held bodies and walls (chapter 12).
#include "suspension/bodies/components.hpp"

#include "suspension/bodies/background_flow.hpp"

namespace stokesbook {

namespace {

// Evaluates the velocity of each kind of wall motion at the nodes x of the curve.
struct WallVelocity {
  const Curve& curve;
  Complex position;

  ComplexVector operator()(const FixedWall&) const { return ComplexVector::Zero(curve.size()); }
  ComplexVector operator()(const RotatingWall& motion) const {
    return (imaginary * motion.omega * (curve.x.array() - position)).matrix();
  }
  ComplexVector operator()(const TranslatingWall& motion) const {
    return ComplexVector::Constant(curve.size(), motion.velocity);
  }
  ComplexVector operator()(const LinearWall& motion) const {
    return background_velocity(LinearFlow{motion.gradient}, curve.x);
  }
  ComplexVector operator()(const RadialWall& motion) const {
    return -motion.speed * normals(curve);
  }
};

}  // namespace

std::string ComponentView::name() const {
  return (body != nullptr ? "body " : "wall ") + std::to_string(number);
}

std::size_t count_components(const Scene& scene) {
  return scene.bodies.size() + scene.walls.size();
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

Side side_of(ComponentKind kind) {
  return kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
}

RigidMotion prescribed_motion(const ComponentView& component) {
  if (component.body != nullptr) return {component.body->velocity, component.body->omega};
  const WallMotion& motion = component.wall->motion;
  if (const auto* rotating = std::get_if<RotatingWall>(&motion)) return {0.0, rotating->omega};
  if (const auto* translating = std::get_if<TranslatingWall>(&motion)) {
    return {translating->velocity, 0.0};
  }
  return {};
}

ComplexVector prescribed_velocity(const ComponentView& component, const Curve& curve,
                                  Complex position) {
  if (component.wall != nullptr) {
    return std::visit(WallVelocity{curve, position}, component.wall->motion);
  }
  const auto& [velocity, omega] = prescribed_motion(component);
  // U + omega (x - c)^perp (03.1), with z^perp = i z.
  return (velocity + imaginary * omega * (curve.x.array() - position)).matrix();
}

}  // namespace stokesbook
