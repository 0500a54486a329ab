// Evaluates the velocity of a double layer and its derivatives at any distance from the curve, by
// Cauchy integrals of Goursat's functions in barycentric form: (06.11), (06.13) and (06.16).
#include "near_singular/cauchy.hpp"

#include <algorithm>
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

// [cauchy_matrix]
// Assembles the matrix V of the limit of a Cauchy integral from the fluid, C+[f] = V f (06.11):
// (V f)_j = [s=+1] f_j + sum_{k/=j} (f_k - f_j) c_k / (x_k - x_j) + f'_j s h / (2 pi i)
// with h = 2 pi / N and c_k = s x'_k h / (2 pi i), where a prime is the derivative in t.
MatrixXcd cauchy_matrix(const Curve& curve) {
  const Index n = curve.size();
  const Complex derivative_weight = curve.sign() / (imaginary * static_cast<double>(n));
  const ComplexVector cauchy_weights = derivative_weight * curve.dx;
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
// [cauchy_matrix]

// Sets modes that contain only rounding errors to zero, because differentiation would multiply
// these errors by up to N / 2.
ComplexVector without_rounding(const ComplexVector& f) {
  ComplexVector modes = fourier_coefficients(f);
  const double least = 1e-14 * modes.cwiseAbs().maxCoeff();
  for (Complex& mode : modes) {
    if (std::abs(mode) < least) mode = 0.0;
  }
  return fourier_values(modes);
}

// Differentiates each column with respect to the point t of the curve: the derivative of the node
// values with respect to the parameter, divided by that of t.
MatrixXcd along(const Curve& curve, const MatrixXcd& f) {
  MatrixXcd result(f.rows(), f.cols());
  for (Index column = 0; column < f.cols(); ++column) {
    result.col(column) = differentiate(f.col(column)).cwiseQuotient(curve.dx);
  }
  return result;
}

}  // namespace

CauchyCurve::CauchyCurve(const Curve& reference, KernelStorage storage)
    : curve_(reference), barycentric_(curve_), layer_({curve_}) {
  if (storage == KernelStorage::stored) stored_ = matrices();
}

// phi = -C+[eta] / 2 (06.10), and the limit U = -eta / 2 + D eta from the fluid (02.8).
CauchyCurve::Matrices CauchyCurve::matrices() const {
  Matrices matrices{-0.5 * cauchy_matrix(curve_), {}, double_layer_matrix(curve_)};
  matrices.dphi = along(curve_, matrices.phi);
  matrices.limit.diagonal().array() -= 0.5;
  return matrices;
}

CauchyData CauchyCurve::data(const MatrixXcd& densities) const {
  const Index rows = 2 * densities.rows(), columns = densities.cols();
  if (!stored_) {
    CauchyData data{MatrixXcd(rows / 2, columns), MatrixXcd(rows / 2, columns), {}};
    for (Index k = 0; k < columns; ++k) {
      const ComplexVector density = densities.col(k);
      data.limit.col(k) = layer_(density) + diagonal_velocity(curve_, density) - 0.5 * density;
      data.phi.col(k) = -0.5 * barycentric_.limits(density);
    }
    data.dphi = along(curve_, data.phi);
    return data;
  }
  const Eigen::Map<const MatrixXd> interleaved_densities(
      reinterpret_cast<const double*>(densities.data()), rows, columns);
  const MatrixXd limit = stored_->limit * interleaved_densities;
  const Eigen::Map<const MatrixXcd> complex_limit(reinterpret_cast<const Complex*>(limit.data()),
                                                  rows / 2, columns);
  return {complex_limit, stored_->phi * densities, stored_->dphi * densities};
}

// u = C[phi] - conj(C[chi + (conj(z) - conj(x)) phi']) (06.13) with chi = conj(phi - U) (06.12).
ComplexVector CauchyCurve::velocity(const CauchyData& data, Index column,
                                    const ComplexVector& targets) const {
  const auto phi = data.phi.col(column);
  const ComplexVector chi = (phi - data.limit.col(column)).conjugate();
  const std::vector<BarycentricValues> values =
      barycentric_(phi, chi, data.dphi.col(column), targets);
  ComplexVector result(targets.size());
  std::ranges::transform(values, result.begin(), [](const BarycentricValues& at) {
    return at.first - std::conj(at.second);
  });
  return result;
}

// (06.13), sorted by U, phi and phi':
// u(z) = sum_j conj(w_j) U_j + 2 i Im(w_j) phi_j - conj(w_j) (z - x_j) conj(phi'_j).
MatrixXd CauchyCurve::velocity_rows(const ComplexVector& targets) const {
  std::optional<Matrices> assembled;
  if (!stored_) assembled = this->matrices();
  const Matrices& matrices = stored_ ? *stored_ : *assembled;
  const MatrixXcd w = barycentric_.weights(targets);
  const Index m = w.rows(), n = w.cols();
  const MatrixXcd r = targets.replicate(1, n) - curve_.x.transpose().replicate(m, 1);
  const MatrixXcd direct = (2.0 * imaginary * w.imag()) * matrices.phi;
  const MatrixXcd conjugate = -w.conjugate().cwiseProduct(r) * matrices.dphi.conjugate();
  return interleaved_map(w.conjugate(), MatrixXcd::Zero(m, n)) * matrices.limit +
         interleaved_map(direct, conjugate);
}

// phi' and phi'' along the curve, and g = dchi/dx - phi' dconj(x)/dx (06.16).
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

// Pressure -4 Re C[phi'], vorticity 4 Im C[phi'], and strain 2 du/dconj(z) by (06.16).
std::vector<FlowDerivatives> CauchyCurve::derivatives(const CauchyDerivativeData& data,
                                                      Index column,
                                                      const ComplexVector& targets) const {
  const std::vector<BarycentricValues> values =
      barycentric_(data.dphi.col(column), data.stress.col(column), data.ddphi.col(column), targets);
  std::vector<FlowDerivatives> result(values.size());
  std::ranges::transform(
      values, result.begin(), [](const BarycentricValues& at) -> FlowDerivatives {
        return {-4.0 * at.first.real(), 4.0 * at.first.imag(), -2.0 * std::conj(at.second)};
      });
  return result;
}

}  // namespace stokesbook
