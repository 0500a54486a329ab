// Evaluates the velocities that a scene gives on curves, at the nodes: motions of walls and held
// bodies, and slips. Velocity data become smooth functions: a periodic cubic spline of GSL moves
// them to equidistant parameters, through which the trigonometric interpolant goes (chapter 01).
#include "suspension/bodies/boundary_velocity.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <gsl/gsl_spline.h>

#include "suspension/bodies/background_flow.hpp"
#include "trapezoid/fourier.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

using Spline = std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)>;

Spline periodic_spline(const std::vector<double>& t, const std::vector<double>& values) {
  Spline spline(gsl_spline_alloc(gsl_interp_cspline_periodic, t.size()), gsl_spline_free);
  gsl_spline_init(spline.get(), t.data(), values.data(), t.size());
  return spline;
}

// Evaluates each kind of velocity in the frame of the component.
struct VelocityOnCurve {
  const DiscretisedShape& discretised;

  // u = sum_k B_k sin k t x' / |x'|.
  ComplexVector operator()(const Squirmer& squirmer) const {
    ComplexVector velocity = discretised.curve.dx.cwiseQuotient(discretised.curve.dx.cwiseAbs());
    for (Index j = 0; j < velocity.size(); ++j) {
      const double t = discretised.parameters[static_cast<std::size_t>(j)].t;
      double speed = 0.0, k = 0.0;
      for (const double mode : squirmer.modes) speed += mode * std::sin(++k * t);
      velocity[j] *= speed;
    }
    return velocity;
  }

  // u = speed (1 - (y / b)^2).
  ComplexVector operator()(const ParabolicWall& channel) const {
    const double half_width = std::get<Superellipse>(discretised.shape).b;
    const Eigen::ArrayXd height = discretised.curve.x.array().imag() / half_width;
    return (channel.speed * (1.0 - height.square())).cast<Complex>();
  }

  ComplexVector operator()(const VelocityData& data) const {
    constexpr double period = 2.0 * std::numbers::pi;
    std::vector<double> t, u, v;
    for (const auto& [at, along_x, along_y] : data.rows) {
      t.push_back(at);
      u.push_back(along_x);
      v.push_back(along_y);
    }
    t.push_back(t.front() + period);  // the first row ends the period
    u.push_back(u.front());
    v.push_back(v.front());
    require(std::ranges::adjacent_find(t, std::greater_equal{}) == t.end(),
            "velocity data require ascending rows within one period");
    const Spline spline_u = periodic_spline(t, u), spline_v = periodic_spline(t, v);
    const auto count = static_cast<double>(data.rows.size());
    ComplexVector values(static_cast<Index>(data.rows.size()));
    for (Index i = 0; i < values.size(); ++i) {
      const double at = t.front() + period * static_cast<double>(i) / count;
      values[i] = {gsl_spline_eval(spline_u.get(), at, nullptr),
                   gsl_spline_eval(spline_v.get(), at, nullptr)};
    }
    const TrigonometricPolynomial series(values);
    ComplexVector velocity(discretised.curve.size());
    for (Index j = 0; j < velocity.size(); ++j) {
      velocity[j] = series(discretised.parameters[static_cast<std::size_t>(j)].t - t.front()).value;
    }
    return velocity;
  }
};

}  // namespace

RigidMotion prescribed_motion(const ComponentView& component) {
  if (component.body != nullptr) return {component.body->velocity, component.body->omega};
  const WallMotion& motion = component.wall->motion;
  if (const auto* rotating = std::get_if<RotatingWall>(&motion)) return {0.0, rotating->omega};
  if (const auto* translating = std::get_if<TranslatingWall>(&motion)) {
    return {translating->velocity, 0.0};
  }
  return {};
}

ComplexVector boundary_velocity(const ComponentView& component, const DiscretisedShape& discretised,
                                const Curve& placed, const Pose& pose) {
  const VelocityOnCurve on_curve{discretised};
  const Complex turn = std::polar(1.0, pose.orientation);
  if (component.kind == ComponentKind::free_body) {
    const std::optional<Slip>& slip = component.body->slip;
    return slip ? ComplexVector(turn * std::visit(on_curve, *slip)) : ComplexVector{};
  }
  if (component.wall != nullptr) {
    const WallMotion& motion = component.wall->motion;
    if (const auto* linear = std::get_if<LinearWall>(&motion)) {
      return background_velocity(LinearFlow{linear->gradient}, placed.x);
    }
    if (const auto* radial = std::get_if<RadialWall>(&motion)) {
      return -radial->speed * normals(placed);
    }
    if (const auto* channel = std::get_if<ParabolicWall>(&motion)) return turn * on_curve(*channel);
    if (const auto* data = std::get_if<VelocityData>(&motion)) return turn * on_curve(*data);
  }
  const auto& [velocity, omega] = prescribed_motion(component);
  // U + omega (x - c)^perp (03.1), with z^perp = i z.
  return (velocity + imaginary * omega * (placed.x.array() - pose.position)).matrix();
}

}  // namespace stokesbook
