#include "suspension/component_data.hpp"

#include <utility>

#include "suspension/background_flow.hpp"

namespace stokesbook {

namespace {

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

ComponentKind kind_of(const Body& body) {
  return body.held ? ComponentKind::prescribed : ComponentKind::free_body;
}

ComponentKind kind_of(const Wall& wall) {
  return wall.role == WallRole::outer ? ComponentKind::enclosing_wall : ComponentKind::prescribed;
}

Side side_of(ComponentKind kind) {
  return kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
}

ComplexVector wall_velocity(const WallMotion& motion, const Curve& curve, Complex position) {
  return std::visit(WallVelocity{curve, position}, motion);
}

BackgroundOnBody background_on_body(const BackgroundFlow& flow, const Component& body) {
  const ComplexVector centre = ComplexVector::Constant(1, body.centre);
  const ComplexVector offsets = body.curve.x.array() - body.centre;
  const RigidMotion carried{background_velocity(flow, centre)[0],
                            0.5 * background_derivatives(flow, centre)[0].vorticity};
  const ComplexVector about = background_about(flow, body.centre, offsets);
  ComplexVector strain = about - imaginary * carried.omega * offsets;
  // What rounding leaves of a flow that is rigid there, such as a rotation, is no strain.
  constexpr double rounding = 1e-14;
  if (strain.cwiseAbs().maxCoeff() <= rounding * about.cwiseAbs().maxCoeff()) strain.setZero();
  return {carried, std::move(strain)};
}

RigidMotion rigid_motion(const WallMotion& motion) {
  if (const auto* rotating = std::get_if<RotatingWall>(&motion)) return {0.0, rotating->omega};
  if (const auto* translating = std::get_if<TranslatingWall>(&motion)) {
    return {translating->velocity, 0.0};
  }
  return {};
}

}  // namespace stokesbook
