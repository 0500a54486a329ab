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
  Complex operator()(const ShearFlow& flow) const { return flow.rate * (x - flow.centre).imag(); }
  Complex operator()(const ExtensionalFlow& flow) const {
    return flow.rate * std::conj(x - flow.centre);
  }
  Complex operator()(const TaylorGreenFlow& flow) const {
    return flow.rate * Complex{std::cos(x.real()) * std::sin(x.imag()),
                               -std::sin(x.real()) * std::cos(x.imag())};
  }
  Complex operator()(const LinearFlow& flow) const {
    const Complex arm = x - flow.centre;
    const Eigen::Vector2d u = flow.gradient * Eigen::Vector2d{arm.real(), arm.imag()};
    return {u[0], u[1]};
  }
  Complex operator()(const SumFlow& sum) const {
    Complex velocity{};
    for (const BackgroundFlow& term : sum.terms) velocity += std::visit(*this, term);
    return velocity;
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
  FlowDerivatives operator()(const SumFlow& sum) const {
    FlowDerivatives derivatives;
    for (const BackgroundFlow& term : sum.terms) derivatives += std::visit(*this, term);
    return derivatives;
  }
};

// Evaluates u_inf(c + d) - u_inf(c) at the offset d from the centre c of a body. For sums of linear
// flows no digits cancel, however fast the flow is at the body.
struct RelativeVelocityAt {
  Complex centre, offset;

  Complex operator()(const auto& flow) const {
    const VelocityAt here{offset + centre}, at_centre{centre};
    return here(flow) - at_centre(flow);
  }
  Complex operator()(const ShearFlow& flow) const { return flow.rate * offset.imag(); }
  Complex operator()(const ExtensionalFlow& flow) const { return flow.rate * std::conj(offset); }
  Complex operator()(const LinearFlow& flow) const {
    return VelocityAt{offset}(LinearFlow{flow.gradient});
  }
  Complex operator()(const SumFlow& sum) const {
    Complex velocity{};
    for (const BackgroundFlow& term : sum.terms) velocity += std::visit(*this, term);
    return velocity;
  }
};

}  // namespace

BackgroundFlow undisturbed_flow(const Scene& scene) {
  if (!scene.cell || scene.cell->mean_velocity == Complex{}) return scene.flow;
  return SumFlow{{UniformFlow{scene.cell->mean_velocity}, scene.flow}};
}

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
  const ComplexVector relative = offsets.unaryExpr([&](Complex offset) {
    return std::visit(RelativeVelocityAt{body.centre, offset}, flow);
  });
  const double omega = background_rigid_motion(flow, body.centre).omega;
  // u_inf(c + d) - u_inf(c) - omega d^perp, with d^perp = i d.
  ComplexVector strain = relative - imaginary * omega * offsets;
  // A rotation has no strain: a difference of this size is rounding.
  constexpr double rounding = 1e-14;
  if (strain.cwiseAbs().maxCoeff() <= rounding * relative.cwiseAbs().maxCoeff()) strain.setZero();
  return strain;
}

}  // namespace stokesbook
