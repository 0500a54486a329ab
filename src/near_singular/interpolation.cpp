// Evaluates a double layer close to its curve by interpolation along the normal, between the limit
// on the curve and values of a finer trapezoid rule (chapter 06, "Interpolation").
#include "near_singular/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "near_singular/closest_points.hpp"
#include "near_singular/near_field.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

// Assembles the matrix that maps node values to fine node values: column j holds the fine values of
// the function that is 1 at node j and 0 at the other nodes.
MatrixXd refinement(Index n, Index fine) {
  MatrixXd matrix(fine, n);
  for (Index j = 0; j < n; ++j) {
    matrix.col(j) = resample(ComplexVector::Unit(n, j), fine).real();
  }
  return matrix;
}

// Evaluates the Lagrange polynomials of the nodes 0, 1, ..., degree at a point:
// prod_{k/=j} (at - k) / (j - k) for j = 0, ..., degree.
std::vector<double> lagrange(int degree, double at) {
  std::vector<double> values;
  for (int j = 0; j <= degree; ++j) {
    double value = 1.0;
    for (int k = 0; k <= degree; ++k) {
      if (k != j) value *= (at - k) / (j - k);
    }
    values.push_back(value);
  }
  return values;
}

}  // namespace

InterpolationSettings InterpolationSettings::published(Index n_nodes) {
  const int root = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(n_nodes))));
  return {6, 1.1, root, Spacing::mean};
}

InterpolationSettings InterpolationSettings::for_tolerance(double tolerance) {
  // sigma beta = ln(100 / tolerance) / (2 pi), from (06.6)
  const double spacings = std::log(100.0 / std::max(tolerance, 1e-12)) / (2.0 * std::numbers::pi);
  if (tolerance >= 1e-6) return {8, 1.0, static_cast<int>(std::ceil(spacings)), Spacing::local};
  return {12, 0.5, static_cast<int>(std::ceil(2.0 * spacings)), Spacing::local};
}

InterpolationCurve::InterpolationCurve(const Curve& reference,
                                       const InterpolationSettings& settings)
    : curve_(reference),
      fine_curve_(resample(curve_, std::max(1, settings.upsampling) * curve_.size())),
      settings_(settings),
      mean_spacing_(perimeter(curve_) / static_cast<double>(curve_.size())),
      shape_(curve_.x),
      fine_sum_({fine_curve_}),
      refine_(refinement(curve_.size(), fine_curve_.size())),
      limit_(double_layer_matrix(curve_)) {
  require(settings.degree >= 1 && settings.step > 0.0 && settings.upsampling >= 1,
          "the interpolation scheme requires degree >= 1, step > 0 and upsampling >= 1, got ",
          settings.degree, ", ", settings.step, " and ", settings.upsampling);
  limit_.diagonal().array() -= 0.5;
}

InterpolationData InterpolationCurve::data(const MatrixXcd& densities) const {
  InterpolationData result{{}, refine_ * densities};
  for (Index column = 0; column < densities.cols(); ++column) {
    result.limit.emplace_back(deinterleaved(limit_ * interleaved(densities.col(column))));
  }
  return result;
}

// Finds the closest point x_0 by Newton's method, which starts at the preimage (06.4), and the
// weights of the interpolation: of the limit at x_0, and of the values at x_0 - j beta h n for
// j = 1, ..., degree. A target beyond the first of these points needs no interpolation.
InterpolationCurve::Stencil InterpolationCurve::stencil(Complex target) const {
  const double step = 2.0 * std::numbers::pi / static_cast<double>(curve_.size());
  const Index node = nearest_node(curve_, target);
  const double guess = step * static_cast<double>(node) + preimage(curve_, node, target).real();
  const auto [t, at] = find_foot(shape_, target, guess, step);
  const double spacing = settings_.spacing == InterpolationSettings::Spacing::local
                             ? std::abs(at.first) * step
                             : mean_spacing_;
  const Complex into_fluid = imaginary * curve_.sign() * at.first / std::abs(at.first);
  const double first = settings_.step * spacing;
  const double distance = dot(target - at.value, into_fluid) / first;
  if (distance >= 1.0) return {t, 0.0, {target}, {1.0}};
  const std::vector<double> weights = lagrange(settings_.degree, distance);
  Stencil result{t, weights.front(), {}, {weights.begin() + 1, weights.end()}};
  for (int j = 1; j <= settings_.degree; ++j) {
    result.points.push_back(at.value + j * first * into_fluid);
  }
  return result;
}

ComplexVector InterpolationCurve::velocity(const InterpolationData& data, Index column,
                                           const ComplexVector& targets) const {
  std::vector<Stencil> stencils;
  std::vector<Complex> points;
  for (const Complex target : targets) {
    stencils.push_back(stencil(target));
    points.insert(points.end(), stencils.back().points.begin(), stencils.back().points.end());
  }
  const ComplexVector values =
      fine_sum_(ComplexVector::Map(points.data(), std::ssize(points)), data.fine.col(column));
  const TrigonometricPolynomial& limit = data.limit[static_cast<std::size_t>(column)];
  ComplexVector result(targets.size());
  Index next = 0;
  for (Index i = 0; i < targets.size(); ++i) {
    const Stencil& at = stencils[static_cast<std::size_t>(i)];
    result[i] = at.limit_weight == 0.0 ? 0.0 : at.limit_weight * limit(at.parameter).value;
    for (const double weight : at.weights) result[i] += weight * values[next++];
  }
  return result;
}

MatrixXd InterpolationCurve::velocity_rows(const ComplexVector& targets) const {
  const Index m = targets.size();
  MatrixXd of_limit = MatrixXd::Zero(m, curve_.size());
  MatrixXcd direct = MatrixXcd::Zero(m, fine_curve_.size()), conjugate = direct;
  const Eigen::VectorXd fine_weights = weights(fine_curve_);
  const ComplexVector normal = normals(fine_curve_);
  for (Index i = 0; i < m; ++i) {
    const Stencil at = stencil(targets[i]);
    of_limit.row(i) = at.limit_weight * interpolation_weights(curve_.size(), at.parameter);
    for (std::size_t p = 0; p < at.points.size(); ++p) {
      // The kernel (w / pi) (r.n) (r.eta) r / rho^4, where 2 (r.eta) r = rho^2 eta + r^2 conj(eta),
      // as factors of eta and of conj(eta)
      for (Index j = 0; j < fine_curve_.size(); ++j) {
        const Complex r = at.points[p] - fine_curve_.x[j];
        const double rho2 = std::norm(r);
        const double factor =
            at.weights[p] * 0.5 * std::numbers::inv_pi * fine_weights[j] * dot(r, normal[j]) / rho2;
        direct(i, j) += factor;
        conjugate(i, j) += factor * (r * r / rho2);
      }
    }
  }
  return interleaved_map(of_limit, MatrixXcd::Zero(m, curve_.size())) * limit_ +
         interleaved_map(direct * refine_, conjugate * refine_);
}

}  // namespace stokesbook
