#include "near_singular/cauchy.hpp"

#include <cmath>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

// Boundary values from the fluid of the Cauchy integral, C+[f] = V f with
// (V f)_j = [s=+1] f_j + sum_{k/=j} (f_k - f_j) c_k / (t_k - t_j) + f'_j s h / (2 pi i), c_k = s
// t'_k h / (2 pi i).
MatrixXcd cauchy_matrix(const Curve& curve, const ComplexVector& cauchy_weights) {
  const Index n = curve.size();
  const Complex derivative_weight = curve.sign() / (imaginary * static_cast<double>(n));
  MatrixXcd matrix = derivative_weight * differentiation_matrix(n);
  for (Index j = 0; j < n; ++j) {
    Complex row_sum{};
    for (Index k = 0; k < n; ++k) {
      if (k == j) continue;
      const Complex entry = cauchy_weights[k] / (curve.x[k] - curve.x[j]);
      matrix(j, k) += entry;
      row_sum += entry;
    }
    matrix(j, j) += (curve.side == Side::fluid_inside ? 1.0 : 0.0) - row_sum;
  }
  return matrix;
}

// Drops the modes that hold nothing but rounding, which differentiation would amplify N times.
ComplexVector without_rounding(const ComplexVector& f) {
  ComplexVector modes = fourier_coefficients(f);
  const double least = 1e-14 * modes.cwiseAbs().maxCoeff();
  for (Complex& mode : modes) {
    if (std::abs(mode) < least) mode = 0.0;
  }
  return fourier_values(modes);
}

}  // namespace

CauchyCurve::CauchyCurve(const Curve& reference)
    : curve_(reference),
      trapezoid_({reference}),
      cauchy_weights_(reference.dx *
                      (reference.sign() / (imaginary * static_cast<double>(reference.size())))) {
  const Index n = curve_.size();
  phi_ = -0.5 * cauchy_matrix(curve_, cauchy_weights_);
  dphi_ = curve_.dx.cwiseInverse().asDiagonal() * (differentiation_matrix(n) * phi_);
  limit_ = double_layer_matrix(curve_) - 0.5 * MatrixXd::Identity(2 * n, 2 * n);
}

CauchyData CauchyCurve::data(const MatrixXcd& densities) const {
  const Index rows = 2 * densities.rows(), columns = densities.cols();
  const Eigen::Map<const MatrixXd> interleaved_densities(
      reinterpret_cast<const double*>(densities.data()), rows, columns);
  const MatrixXd limit = limit_ * interleaved_densities;
  const Eigen::Map<const MatrixXcd> complex_limit(reinterpret_cast<const Complex*>(limit.data()),
                                                  rows / 2, columns);
  return {complex_limit, phi_ * densities, dphi_ * densities};
}

Complex CauchyCurve::velocity(const CauchyData& data, Index column, Complex target) const {
  const Index n = curve_.size();
  const Complex* t = curve_.x.data();
  const Complex* c = cauchy_weights_.data();
  const Complex* limit = &data.limit(0, column);
  const Complex* phi = &data.phi(0, column);
  const Complex* dphi = &data.dphi(0, column);
  const double zx = target.real(), zy = target.imag();
  double delta_x = curve_.side == Side::fluid_outside ? 1.0 : 0.0, delta_y = 0.0;
  double first_x = 0.0, first_y = 0.0, second_x = 0.0, second_y = 0.0;
#pragma omp simd reduction(+ : delta_x, delta_y, first_x, first_y, second_x, second_y)
  for (Index j = 0; j < n; ++j) {
    const double rx = zx - t[j].real(), ry = zy - t[j].imag();
    // W = c / (t - z) = -c conj(r) / |r|^2
    const double inverse = -1.0 / (rx * rx + ry * ry);
    const double wx = (c[j].real() * rx + c[j].imag() * ry) * inverse;
    const double wy = (c[j].imag() * rx - c[j].real() * ry) * inverse;
    delta_x += wx;
    delta_y += wy;
    first_x += wx * phi[j].real() - wy * phi[j].imag();
    first_y += wx * phi[j].imag() + wy * phi[j].real();
    // chi + conj(r) phi'
    const double gx = phi[j].real() - limit[j].real() + rx * dphi[j].real() + ry * dphi[j].imag();
    const double gy = limit[j].imag() - phi[j].imag() + rx * dphi[j].imag() - ry * dphi[j].real();
    second_x += wx * gx - wy * gy;
    second_y += wx * gy + wy * gx;
  }
  const Complex delta{delta_x, delta_y};
  if (!std::isfinite(std::norm(delta))) {
    // The target is a node (or within the underflow of |r|^2): the limit itself.
    Index nearest = 0;
    (curve_.x.array() - target).abs().minCoeff(&nearest);
    return limit[nearest];
  }
  return Complex{first_x, first_y} / delta - std::conj(Complex{second_x, second_y} / delta);
}

CauchyDerivativeData CauchyCurve::derivative_data(const CauchyData& data) const {
  const Eigen::ArrayXcd dt = curve_.dx.array();
  const Index rows = data.phi.rows(), columns = data.phi.cols();
  CauchyDerivativeData result{MatrixXcd(rows, columns), MatrixXcd(rows, columns),
                              MatrixXcd(rows, columns)};
  for (Index column = 0; column < columns; ++column) {
    const ComplexVector phi = without_rounding(data.phi.col(column));
    const ComplexVector dphi = differentiate(phi).array() / dt;
    const ComplexVector chi =
        without_rounding((data.phi.col(column) - data.limit.col(column)).conjugate());
    result.dphi.col(column) = dphi;
    result.ddphi.col(column) = differentiate(without_rounding(dphi)).array() / dt;
    result.stress.col(column) = (differentiate(chi).array() - dphi.array() * dt.conjugate()) / dt;
  }
  return result;
}

FlowDerivatives CauchyCurve::derivatives(const CauchyDerivativeData& data, Index column,
                                         Complex target) const {
  const auto dphi = data.dphi.col(column).array(), ddphi = data.ddphi.col(column).array(),
             stress = data.stress.col(column).array();
  const auto flow = [](Complex slope, Complex conjugate) -> FlowDerivatives {
    return {-4.0 * slope.real(), 4.0 * slope.imag(), -2.0 * std::conj(conjugate)};
  };
  const Eigen::ArrayXcd distance = curve_.x.array() - target;
  Index nearest = 0;
  if (distance.abs2().minCoeff(&nearest) == 0.0) return flow(dphi[nearest], stress[nearest]);
  const Eigen::ArrayXcd weight = cauchy_weights_.array() / distance;
  const Complex delta = weight.sum() + (curve_.side == Side::fluid_outside ? 1.0 : 0.0);
  return flow((weight * dphi).sum() / delta,
              (weight * (stress - distance.conjugate() * ddphi)).sum() / delta);
}

bool CauchyCurve::in_fluid(Complex point) const {
  const ComplexVector distance = (curve_.x.array() - point).matrix();
  if (distance.cwiseAbs().minCoeff() == 0.0) return true;
  const double own = curve_.side == Side::fluid_outside ? 1.0 : 0.0;
  return own + cauchy_weights_.cwiseQuotient(distance).sum().real() > 0.5;
}

}  // namespace stokesbook
