// Turns bodies and walls of a scene into data of the boundary value problem (chapter 12).
#include "suspension/bodies/component_data.hpp"

#include "suspension/bodies/background_flow.hpp"

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

RigidMotion carried_by(const BackgroundFlow& flow, Complex centre) {
  const ComplexVector point = ComplexVector::Constant(1, centre);
  return {background_velocity(flow, point)[0],
          0.5 * background_derivatives(flow, point)[0].vorticity};
}

ComplexVector strain_on(const BackgroundFlow& flow, const Component& body) {
  const ComplexVector offsets = body.curve.x.array() - body.centre;
  const ComplexVector about = background_about(flow, body.centre, offsets);
  ComplexVector strain = about - imaginary * carried_by(flow, body.centre).omega * offsets;
  // A flow that is rigid there, such as a rotation, has no strain but what rounding leaves.
  constexpr double rounding = 1e-14;
  if (strain.cwiseAbs().maxCoeff() <= rounding * about.cwiseAbs().maxCoeff()) strain.setZero();
  return strain;
}

RigidMotion rigid_motion(const WallMotion& motion) {
  if (const auto* rotating = std::get_if<RotatingWall>(&motion)) return {0.0, rotating->omega};
  if (const auto* translating = std::get_if<TranslatingWall>(&motion)) {
    return {translating->velocity, 0.0};
  }
  return {};
}

}  // namespace stokesbook
