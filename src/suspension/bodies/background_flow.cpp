// Evaluates the velocity and the derivatives of the undisturbed flow by the formula of each kind of
// flow, and splits the flow at a body into a rigid motion and a straining part (chapter 12). Points
// and velocities are complex numbers, x = x_1 + i x_2.
#include "suspension/bodies/background_flow.hpp"

#include <cmath>

namespace stokesbook {

namespace {

// Evaluates the velocity u_1 + i u_2 of each kind of flow at x.
struct VelocityAt {
  Complex x;

  Complex operator()(const QuiescentFlow&) const { return 0.0; }
  Complex operator()(const UniformFlow& flow) const { return flow.velocity; }
  Complex operator()(const ShearFlow& flow) const { return flow.rate * x.imag(); }
  Complex operator()(const ExtensionalFlow& flow) const { return flow.rate * std::conj(x); }
  Complex operator()(const TaylorGreenFlow& flow) const {
    return flow.rate * Complex{std::cos(x.real()) * std::sin(x.imag()),
                               -std::sin(x.real()) * std::cos(x.imag())};
  }
  Complex operator()(const LinearFlow& flow) const {
    const Eigen::Vector2d u = flow.gradient * Eigen::Vector2d{x.real(), x.imag()};
    return {u[0], u[1]};
  }
};

// Evaluates the vorticity and the strain e_11 - e_22 + 2i e_12 (07.4) of the same flows at x.
struct DerivativesAt {
  Complex x;

  FlowDerivatives operator()(const QuiescentFlow&) const { return {}; }
  FlowDerivatives operator()(const UniformFlow&) const { return {}; }
  FlowDerivatives operator()(const ShearFlow& flow) const {
    return {0.0, -flow.rate, imaginary * flow.rate};
  }
  FlowDerivatives operator()(const ExtensionalFlow& flow) const {
    return {0.0, 0.0, 2.0 * flow.rate};
  }
  FlowDerivatives operator()(const TaylorGreenFlow& flow) const {
    return {0.0, -2.0 * flow.rate * std::cos(x.real()) * std::cos(x.imag()),
            -2.0 * flow.rate * std::sin(x.real()) * std::sin(x.imag())};
  }
  FlowDerivatives operator()(const LinearFlow& flow) const {
    const Eigen::Matrix2d& g = flow.gradient;
    return {0.0, g(1, 0) - g(0, 1), {g(0, 0) - g(1, 1), g(0, 1) + g(1, 0)}};
  }
};

// Evaluates u_inf(c + d) - u_inf(c) at the offsets d from the centre c. For linear flows no digits
// cancel, however fast the flow is at the centre.
ComplexVector velocity_relative_to(const BackgroundFlow& flow, Complex centre,
                                   const ComplexVector& offsets) {
  if (std::holds_alternative<UniformFlow>(flow)) return ComplexVector::Zero(offsets.size());
  if (!std::holds_alternative<TaylorGreenFlow>(flow)) return background_velocity(flow, offsets);
  const Complex at_centre = std::visit(VelocityAt{centre}, flow);
  return background_velocity(flow, (offsets.array() + centre).matrix()).array() - at_centre;
}

}  // namespace

ComplexVector background_velocity(const BackgroundFlow& flow, const ComplexVector& points) {
  return points.unaryExpr([&](Complex point) { return std::visit(VelocityAt{point}, flow); });
}

FlowDerivatives background_derivatives(const BackgroundFlow& flow, Complex point) {
  return std::visit(DerivativesAt{point}, flow);
}

RigidMotion background_rigid_motion(const BackgroundFlow& flow, Complex centre) {
  return {std::visit(VelocityAt{centre}, flow),
          0.5 * background_derivatives(flow, centre).vorticity};
}

ComplexVector straining_velocity(const BackgroundFlow& flow, const Component& body) {
  const ComplexVector offsets = body.curve.x.array() - body.centre;
  const ComplexVector relative = velocity_relative_to(flow, body.centre, offsets);
  const double omega = background_rigid_motion(flow, body.centre).omega;
  // u_inf(c + d) - u_inf(c) - omega d^perp, with d^perp = i d.
  ComplexVector strain = relative - imaginary * omega * offsets;
  // A rotation has no strain: a difference of this size is rounding.
  constexpr double rounding = 1e-14;
  if (strain.cwiseAbs().maxCoeff() <= rounding * relative.cwiseAbs().maxCoeff()) strain.setZero();
  return strain;
}

}  // namespace stokesbook
