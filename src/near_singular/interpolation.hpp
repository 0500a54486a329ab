#pragma once

#include <vector>

#include <Eigen/Core>

#include "double_layer/stresslet_sum.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

/// Parameters of the interpolation scheme.
///
/// For a resolved density the error of the scheme is about
/// \f$ \max(100\,e^{-2\pi\sigma\beta},\ K(\beta h/l)^{m+1}) \f$ with a constant K, where l is the
/// distance of the nearest singularity of the continued flow (06.6), (06.7).
struct InterpolationSettings {
  /// Node spacing h that is the unit of the distances of the interpolation points.
  enum class Spacing {
    local,  ///< at the closest point, \f$ |x'(s_0)|\,2\pi/N \f$
    mean    ///< mean over the curve, \f$ |\Gamma|/N \f$
  };

  int degree = 6;                    ///< m, degree of the polynomial in the distance, >= 1
  double step = 1.0;                 ///< \f$ \beta \f$, distance of its points over h, > 0
  int upsampling = 4;                ///< \f$ \sigma \f$, fine nodes per node, >= 1
  Spacing spacing = Spacing::local;  ///< h, the node spacing

  /// Returns the parameters of the published code: m = 6, beta = 1.1, \f$ \sigma = \lceil\sqrt
  /// N\rceil \f$ and the mean spacing.
  ///
  /// @sa source: Bystricky, Shanbhag, Quaife, Int. J. Numer. Meth. Fluids 92 (2020)
  static InterpolationSettings published(Eigen::Index n_nodes);

  /// Returns parameters that meet a tolerance, provided that the node spacing also resolves the
  /// flow away from the curve: \f$ \sigma\beta = \ln(100/\varepsilon)/2\pi \f$, with steps of one
  /// spacing for tolerances down to 1e-6, and steps of half a spacing and a higher degree for
  /// smaller ones. The tolerance > 0 is relative to the density.
  static InterpolationSettings for_tolerance(double tolerance);
};

/// Values from which InterpolationCurve evaluates, one polynomial and one column per density.
struct InterpolationData {
  std::vector<TrigonometricPolynomial> limit;  ///< limits of the velocity, length / time
  Eigen::MatrixXcd fine;                       ///< densities at the fine nodes, length / time
};

/// Evaluates the double layer of one curve close to this curve by interpolation. A polynomial in
/// the distance passes through the limit at the closest point of the curve and through m values
/// farther out, for which a trapezoid rule with more nodes is accurate.
///
/// At targets farther out than the first of these m points the fine rule is evaluated directly. All
/// quantities are in the curve's own frame.
/// @par Accuracy  that of InterpolationSettings: @ref claim_06_13, @ref claim_06_17,
/// @ref claim_06_18; the error is largest at a third of a spacing, and closer to the curve it is
/// proportional to the distance: @ref claim_06_2
/// @par Not for   curves at which the fluid is narrower than m beta h: the points farther out would
/// lie outside the fluid
/// @sa source: Ying, Biros, Zorin, J. Comput. Phys. 219 (2006), 247; Quaife, Biros, J. Comput.
/// Phys. 274 (2014), 403
class InterpolationCurve {
 public:
  /// Prepares fine nodes and limits of one curve of N nodes, in its own frame: 8 (4 + sigma) N^2
  /// bytes.
  ///
  /// @throws std::invalid_argument when a setting is out of its range
  InterpolationCurve(const Curve& reference, const InterpolationSettings& settings);

  /// Computes fine densities and limits for k densities, N x k, in the curve's frame.
  ///
  /// @par Cost  (4 + 2 sigma) N^2 k real multiplications
  InterpolationData data(const Eigen::MatrixXcd& densities) const;

  /// Evaluates the velocity of a density on the fluid's side, at any distance or on the curve.
  ///
  /// @par Cost  at most m sigma N kernel evaluations per target, m being the degree, and O(N)
  ComplexVector velocity(const InterpolationData& data, Eigen::Index column,
                         const ComplexVector& targets) const;

  /// Assembles the matrix that maps a density to the velocities at targets. The product with this
  /// matrix equals data() followed by velocity().
  ///
  /// @param  targets  m points on the fluid's side or on the curve
  /// @return          2m x 2N, dimensionless, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @par Cost        4 sigma N^2 + 8 N^2 real multiplications per target, as matrix products
  Eigen::MatrixXd velocity_rows(const ComplexVector& targets) const;

  const Curve& curve() const { return curve_; }  ///< returns the nodes, in the curve's own frame

 private:
  struct Stencil {
    double parameter;             // parameter of the closest point
    double limit_weight;          // weight of the velocity's limit at the closest point
    std::vector<Complex> points;  // at which the fine rule is evaluated
    std::vector<double> weights;  // weights of the fine rule's values
  };
  Stencil stencil(Complex target) const;

  Curve curve_;
  Curve fine_curve_;
  InterpolationSettings settings_;
  double mean_spacing_;
  TrigonometricPolynomial shape_;  // shape of the curve
  StressletSum fine_sum_;
  Eigen::MatrixXd refine_;  // node values -> fine node values
  Eigen::MatrixXd limit_;   // -1/2 + D, interleaved
};

}  // namespace stokesbook
