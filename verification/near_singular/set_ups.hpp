#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "near_singular/cauchy.hpp"
#include "support/dirichlet.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"
#include "trapezoid/curve.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::near_singular {

using test::inner_poles;
using test::outer_poles;

/// Holds a curve, and an exact flow. On the curve, n nodes resolve the flow's density to rounding.
struct SetUp {
  Shape shape;
  Side side;
  Eigen::Index n;
  test::ExactFlow flow;
};

inline const SetUp ellipse{Ellipse{1.0, 0.5}, Side::fluid_outside, 128, inner_poles};
inline const SetUp star{Star{1.0, 0.2, 5}, Side::fluid_outside, 400, inner_poles};
inline const SetUp slender_container{Ellipse{1.0, 0.1}, Side::fluid_inside, 512, outer_poles};
inline const SetUp round_container{Circle{1.0}, Side::fluid_inside, 96, outer_poles};

/// Holds nodes and density of a set-up, and returns points of the fluid near the curve.
struct Solved {
  explicit Solved(const SetUp& of)
      : set_up(of),
        curve(sample(of.shape, of.n, of.side)),
        density(test::density_of(curve, of.flow.velocity(curve.x))),
        scale(test::largest(of.flow.velocity(curve.x))) {}

  /// Returns the same density on another number of nodes, which must resolve it too.
  Solved on_nodes(Eigen::Index n) const {
    Solved other = *this;
    other.set_up.n = n;
    other.curve = sample(set_up.shape, n, set_up.side);
    other.density = resample(density, n);
    return other;
  }

  /// Returns 122 points at a distance in local spacings; two of the points lie over nodes.
  ComplexVector points_at(double spacings) const {
    const double step = 2.0 * std::numbers::pi * spacings / static_cast<double>(curve.size());
    return points_off(step * places().dx.cwiseAbs());
  }
  /// Returns 122 points at a distance.
  ComplexVector points_off(double distance) const {
    return points_off(Eigen::VectorXd::Constant(places().size(), distance));
  }

  /// Returns the largest error at points, relative to the largest velocity on the curve.
  double error(const ComplexVector& velocity, const ComplexVector& points) const {
    return test::largest(velocity - set_up.flow.velocity(points)) / scale;
  }

  SetUp set_up;
  Curve curve;
  ComplexVector density;
  double scale;

 private:
  Curve places() const { return sample(set_up.shape, 122, set_up.side); }
  ComplexVector points_off(const Eigen::VectorXd& distance) const {
    return places().x - distance.cwiseProduct(normals(places()));
  }
};

/// Returns the ellipse, which is solved once.
inline const Solved& solved_ellipse() {
  static const Solved solved(ellipse);
  return solved;
}

/// Returns the divisor of the Cauchy sums for a sum W of the barycentric weights (06.14).
using Divisor = Complex (*)(Complex sum);

/// Evaluates the Cauchy scheme with another divisor, in order to plant likely mistakes.
inline ComplexVector divided_by(Divisor divisor, const Curve& curve, const CauchyData& data,
                                const ComplexVector& targets) {
  const Complex factor = curve.sign() / (imaginary * static_cast<double>(curve.size()));
  return targets.unaryExpr([&](Complex z) {
    Complex sum{}, first{}, second{};
    for (Eigen::Index j = 0; j < curve.size(); ++j) {
      const Complex w = factor * curve.dx[j] / (curve.x[j] - z);
      const Complex chi = std::conj(data.phi(j, 0) - data.limit(j, 0));
      sum += w;
      first += w * data.phi(j, 0);
      second += w * (chi + std::conj(z - curve.x[j]) * data.dphi(j, 0));
    }
    return first / divisor(sum) - std::conj(second / divisor(sum));
  });
}

}  // namespace stokesbook::verification::near_singular
