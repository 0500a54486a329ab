// Transforms, interpolates and differentiates node values by the fast Fourier transform of GSL, and
// evaluates trigonometric polynomials (chapter 01, "Interpolation and differentiation").
#include "trapezoid/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include <gsl/gsl_fft_complex.h>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// GSL's tables and work space for transforms of n numbers.
struct FourierPlan {
  explicit FourierPlan(std::size_t n)
      : wavetable(gsl_fft_complex_wavetable_alloc(n), gsl_fft_complex_wavetable_free),
        workspace(gsl_fft_complex_workspace_alloc(n), gsl_fft_complex_workspace_free) {}
  std::unique_ptr<gsl_fft_complex_wavetable, void (*)(gsl_fft_complex_wavetable*)> wavetable;
  std::unique_ptr<gsl_fft_complex_workspace, void (*)(gsl_fft_complex_workspace*)> workspace;
};

// Applies a transform of GSL. The plan is made once for each length and thread, because making a
// plan takes longer than a short transform.
ComplexVector transformed(ComplexVector v, decltype(gsl_fft_complex_forward)* transform) {
  const auto n = static_cast<std::size_t>(v.size());
  thread_local std::map<std::size_t, FourierPlan> plans;
  const FourierPlan& plan = plans.try_emplace(n, n).first->second;
  // GSL reads interleaved real and imaginary parts, which is the memory layout of std::complex.
  transform(reinterpret_cast<double*>(v.data()), 1, n, plan.wavetable.get(), plan.workspace.get());
  return v;
}

void require_even(Index n) {
  require(n >= 2 && n % 2 == 0, "a Fourier grid requires an even number of nodes, got ", n);
}

}  // namespace

// c_k = (1 / N) sum_j f(t_j) e^{-i k t_j}.
ComplexVector fourier_coefficients(const ComplexVector& f) {
  return transformed(f, gsl_fft_complex_forward) / static_cast<double>(f.size());
}

// f(t_j) = sum_k c_k e^{i k t_j}.
ComplexVector fourier_values(const ComplexVector& c) {
  return transformed(c, gsl_fft_complex_backward);
}

Index wave_number(Index i, Index n) {
  return i < n - n / 2 ? i : i - n;
}

ComplexVector differentiate(const ComplexVector& f) {
  require_even(f.size());
  const Index n = f.size();
  ComplexVector c = fourier_coefficients(f);
  // The derivative has the coefficients i k c_k; the mode k = -N/2 is dropped.
  for (Index i = 0; i < n; ++i) {
    c[i] *= i == n / 2 ? 0.0 : imaginary * static_cast<double>(wave_number(i, n));
  }
  return fourier_values(c);
}

Eigen::MatrixXd differentiation_matrix(Index n) {
  require_even(n);
  // (1 / 2) (-1)^{j - k} cot((t_j - t_k) / 2) depends on j - k alone, and is 0 on the diagonal.
  Eigen::VectorXd of_lag = Eigen::VectorXd::Zero(n);
  for (Index lag = 1; lag < n; ++lag) {
    const double half_angle = std::numbers::pi * static_cast<double>(lag) / static_cast<double>(n);
    of_lag[lag] = (lag % 2 == 0 ? 0.5 : -0.5) / std::tan(half_angle);
  }
  Eigen::MatrixXd matrix(n, n);
  for (Index k = 0; k < n; ++k) {
    matrix.col(k).head(k) = -of_lag.segment(1, k).reverse();
    matrix.col(k).tail(n - k) = of_lag.head(n - k);
  }
  return matrix;
}

ComplexVector resample(const ComplexVector& f, Index m) {
  require_even(m);
  const Index n = f.size();
  const ComplexVector c = fourier_coefficients(f);
  ComplexVector resampled = ComplexVector::Zero(m);
  // All wave numbers that both grids represent with either sign keep their coefficients.
  const Index kept = std::min((n - 1) / 2, m / 2 - 1);
  for (Index k = -kept; k <= kept; ++k) {
    resampled[(k + m) % m] = c[(k + n) % n];
  }
  if (n % 2 == 0 && n <= m) {
    // The mode N/2 of an even grid is a cosine: half of its coefficient belongs to each sign of k.
    resampled[n / 2] += 0.5 * c[n / 2];
    resampled[m - n / 2] += 0.5 * c[n / 2];
  }
  return fourier_values(resampled);
}

Eigen::RowVectorXd interpolation_weights(Index n, double t) {
  require_even(n);
  const auto nodes = static_cast<double>(n);
  constexpr double turn = 2.0 * std::numbers::pi;
  Eigen::RowVectorXd result(n);
  // (1 / N) sin(N tau / 2) cot(tau / 2) with tau = t - t_j, and 1 for tau = 0.
  for (Index j = 0; j < n; ++j) {
    const double lag = std::remainder(t - turn * static_cast<double>(j) / nodes, turn);
    result[j] = lag == 0.0 ? 1.0 : std::sin(0.5 * nodes * lag) / (nodes * std::tan(0.5 * lag));
  }
  return result;
}

Eigen::MatrixXcd interpolated(const Eigen::MatrixXcd& f, const std::vector<double>& parameters) {
  require_even(f.rows());
  const Index n = f.rows(), highest = n / 2;
  Eigen::MatrixXcd coefficients(n, f.cols());
  for (Index column = 0; column < f.cols(); ++column) {
    coefficients.col(column) = fourier_coefficients(f.col(column));
  }
  Eigen::MatrixXcd modes(n, static_cast<Index>(parameters.size()));  // one column per parameter
  for (Index j = 0; j < modes.cols(); ++j) {
    const double t = parameters[static_cast<std::size_t>(j)];
    const Complex step = std::polar(1.0, t);
    Complex mode = 1.0;
    // e^{i k t} for |k| < N/2 in the order of the coefficients, and cos(N t / 2).
    for (Index k = 0; k < highest; ++k) {
      modes(k, j) = mode;
      if (k > 0) modes(n - k, j) = std::conj(mode);
      mode *= step;
    }
    modes(highest, j) = mode.real();
  }
  return modes.transpose() * coefficients;
}

double fourier_tail(const ComplexVector& f) {
  require_even(f.size());
  const Index n = f.size();
  const Index first = n / 2 - std::max<Index>(2, n / 16);
  const ComplexVector c = fourier_coefficients(f);
  double tail = 0.0;
  for (Index i = 0; i < n; ++i) {
    if (std::abs(wave_number(i, n)) >= first) tail = std::max(tail, std::abs(c[i]));
  }
  return tail;
}

TrigonometricPolynomial::TrigonometricPolynomial(const ComplexVector& values) {
  const Index n = values.size(), highest = n / 2;
  require(n > 0, "a trigonometric polynomial requires at least one value, got 0");
  const ComplexVector c = fourier_coefficients(values);
  coefficients_.resize(2 * highest + 1);
  for (Index k = -highest; k <= highest; ++k) {
    coefficients_[k + highest] = c[(k + n) % n];
  }
  if (n % 2 != 0) return;
  // The mode N/2 of an even grid is a cosine: half of its coefficient belongs to each sign of k.
  coefficients_[0] *= 0.5;
  coefficients_[n] *= 0.5;
}

TrigonometricPolynomial::Jet TrigonometricPolynomial::operator()(double t) const {
  const Index highest = coefficients_.size() / 2;
  const Complex step = std::polar(1.0, t);
  Complex phase = std::polar(1.0, -static_cast<double>(highest) * t);
  Jet jet{};
  // p = sum_k c_k e^{i k t}, p' = sum_k i k c_k e^{i k t} and p'' = -sum_k k^2 c_k e^{i k t}.
  for (Index i = 0; i < coefficients_.size(); ++i) {
    const auto k = static_cast<double>(i - highest);
    const Complex term = coefficients_[i] * phase;
    jet.value += term;
    jet.first += imaginary * k * term;
    jet.second -= k * k * term;
    phase *= step;
  }
  return jet;
}

}  // namespace stokesbook
