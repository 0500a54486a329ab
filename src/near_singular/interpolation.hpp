#pragma once

#include <vector>

#include <Eigen/Core>

#include "double_layer/stresslet_sum.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

/// @addtogroup near_singular
/// @{

/// Parameters of the interpolation scheme.
///
/// The error of a resolved density is about
/// \f$ \max(100\,e^{-2\pi\sigma\beta},\ K(\beta h/l)^{m+1}) \f$, l being the distance of the
/// nearest singularity of the continued flow.
struct InterpolationSettings {
  /// Which node spacing h the distances of the interpolation points are measured in.
  enum class Spacing {
    local,  ///< of the closest point, \f$ |x'(s_0)|\,2\pi/N \f$
    mean    ///< of the curve, \f$ |\Gamma|/N \f$
  };

  int degree = 6;                    ///< m, of the polynomial in the distance, >= 1
  double step = 1.0;                 ///< \f$ \beta \f$, between its points, in spacings, > 0
  int upsampling = 4;                ///< \f$ \sigma \f$, fine nodes a node, >= 1
  Spacing spacing = Spacing::local;  ///< h

  /// Returns the parameters of the published code: m = 6, beta = 1.1, \f$ \sigma = \lceil\sqrt
  /// N\rceil \f$ and the mean spacing.
  ///
  /// @param  n_nodes  N
  /// @return          settings
  /// @sa source: Bystricky, Shanbhag, Quaife, Int. J. Numer. Meth. Fluids 92 (2020)
  static InterpolationSettings published(Eigen::Index n_nodes);

  /// Returns parameters that meet a tolerance wherever the curve resolves the flow in steps of its
  /// spacing: \f$ \sigma\beta = \ln(100/\varepsilon)/2\pi \f$; steps of one spacing down to 1e-6,
  /// of half a spacing and a higher degree beyond.
  ///
  /// @param  tolerance  relative to the density, > 0
  /// @return            settings
  static InterpolationSettings for_tolerance(double tolerance);
};

/// Node values from which InterpolationCurve evaluates. One column a density.
struct InterpolationData {
  std::vector<TrigonometricPolynomial> limit;  ///< of the velocity from the fluid, length / time
  Eigen::MatrixXcd fine;                       ///< densities at the fine nodes, length / time
};

/// The close evaluation of one curve's double layer by interpolation: a polynomial in the distance
/// through the limit at the closest point of the curve and values farther out, where a trapezoid
/// rule with more nodes does.
///
/// Targets farther out than the first of these points take the fine rule itself. Everything is in
/// the curve's own frame.
/// @par Accuracy  that of InterpolationSettings: @ref claim_06_13, @ref claim_06_17,
/// @ref claim_06_18; worst at a third of a spacing, proportional to the distance below:
/// @ref claim_06_2
/// @par Not for   curves whose fluid is narrower than m beta h behind the closest point: the
/// points would lie outside it
/// @sa source: Ying, Biros, Zorin, J. Comput. Phys. 219 (2006), 247; Quaife, Biros, J. Comput.
/// Phys. 274 (2014), 403
class InterpolationCurve {
 public:
  /// Prepares fine nodes and limits of one curve.
  ///
  /// @param  reference  N nodes, in the curve's own frame
  /// @param  settings   parameters
  /// @throws std::invalid_argument when a setting is out of its range
  /// @par Cost          8 (4 + sigma) N^2 bytes
  InterpolationCurve(const Curve& reference, const InterpolationSettings& settings);

  /// Computes fine densities and limits for densities in the curve's frame, one a column.
  ///
  /// @param  densities  N x k, length / time
  /// @return            for velocity()
  /// @par Cost          (4 + 2 sigma) N^2 k real multiplications
  InterpolationData data(const Eigen::MatrixXcd& densities) const;

  /// Evaluates the velocity on the fluid's side, at any distance or on the curve.
  ///
  /// @param  data     from data()
  /// @param  column   which density
  /// @param  targets  m points, in the curve's frame, length
  /// @return          m velocities in the curve's frame, length / time
  /// @par Cost        at most m sigma N kernel evaluations a target, m the degree, and O(N)
  ComplexVector velocity(const InterpolationData& data, Eigen::Index column,
                         const ComplexVector& targets) const;

  /// Assembles the map from a density to the velocities at targets, of velocity() and data().
  ///
  /// @param  targets  m points on the fluid's side or on the curve, in the curve's frame, length
  /// @return          2m x 2N, dimensionless, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @par Cost        4 sigma N^2 + 8 N^2 real multiplications a target, as matrix products
  Eigen::MatrixXd velocity_rows(const ComplexVector& targets) const;

  /// Returns the nodes.
  /// @return N nodes, in the curve's own frame
  const Curve& curve() const { return curve_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Stencil {
    double parameter;             // of the closest point
    double limit_weight;          // of the velocity's limit there
    std::vector<Complex> points;  // where the fine rule is evaluated
    std::vector<double> weights;  // of its values
  };
  /// @endcond
  Stencil stencil(Complex target) const;

  Curve curve_;
  Curve fine_curve_;
  InterpolationSettings settings_;
  double mean_spacing_;
  TrigonometricPolynomial shape_;  // of the curve
  StressletSum fine_sum_;
  Eigen::MatrixXd refine_;  // node values -> fine node values
  Eigen::MatrixXd limit_;   // -1/2 + D, interleaved
};

/// @}

}  // namespace stokesbook
