#include "suspension/background_flow.hpp"

#include <cmath>

namespace stokesbook {

namespace {

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

}  // namespace

ComplexVector background_velocity(const BackgroundFlow& flow, const ComplexVector& points) {
  ComplexVector velocity(points.size());
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    velocity[i] = std::visit(VelocityAt{points[i]}, flow);
  }
  return velocity;
}

}  // namespace stokesbook
