// Evaluates the double layer at a point by GSL's adaptive Gauss-Kronrod rule, as an independent
// reference.
#include "adaptive.hpp"

#include <memory>
#include <numbers>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include "double_layer/kernels.hpp"
#include "near_singular/near_field.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook::verification::near_singular {

namespace {

/// Holds one component of the integrand for one target.
struct Integrand {
  const TrigonometricPolynomial &shape, &density;
  double sign;
  Complex target;
  bool imaginary_part;
  Eigen::Index evaluations = 0;

  double operator()(double t) {
    ++evaluations;
    const TrigonometricPolynomial::Jet at = shape(t);
    const Complex normal_length = -imaginary * sign * at.first;
    const Complex velocity = stresslet(target - at.value, normal_length, density(t).value);
    return imaginary_part ? velocity.imag() : velocity.real();
  }
};

double call(double t, void* integrand) {
  return (*static_cast<Integrand*>(integrand))(t);
}

}  // namespace

AdaptiveResult adaptive_velocity(const Curve& curve, const ComplexVector& density, Complex target,
                                 double tolerance) {
  constexpr std::size_t most_intervals = 1000;
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(most_intervals), gsl_integration_workspace_free);
  gsl_error_handler_t* const handler =
      gsl_set_error_handler_off();  // the status is checked instead
  const TrigonometricPolynomial shape(curve.x), of_density(density);
  const Eigen::Index node = nearest_node(curve, target);
  const double closest =
      2.0 * std::numbers::pi * static_cast<double>(node) / static_cast<double>(curve.size()) +
      preimage(curve, node, target).real();
  AdaptiveResult result{{}, 0, true};
  for (const bool imaginary_part : {false, true}) {
    Integrand integrand{shape, of_density, curve.sign(), target, imaginary_part};
    gsl_function function{&call, &integrand};
    for (const double from : {closest - std::numbers::pi, closest}) {
      double integral = 0.0, estimate = 0.0;
      const int status = gsl_integration_qag(&function, from, from + std::numbers::pi, tolerance,
                                             tolerance, most_intervals, GSL_INTEG_GAUSS21,
                                             workspace.get(), &integral, &estimate);
      result.velocity += imaginary_part ? imaginary * integral : Complex{integral};
      result.content = result.content && status == GSL_SUCCESS;
    }
    result.evaluations += integrand.evaluations;
  }
  gsl_set_error_handler(handler);
  return result;
}

}  // namespace stokesbook::verification::near_singular
