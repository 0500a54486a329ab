// Runs motions by GSL's multistep method `msadams`, for comparison.
#include "multistep.hpp"

#include <algorithm>
#include <stdexcept>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace stokesbook::verification::time_stepping {

using Eigen::VectorXd;

namespace {

struct System {
  Rate rate;
  Eigen::Index size;

  static int evaluate(double t, const double* q, double* rate, void* parameters) {
    const auto& system = *static_cast<const System*>(parameters);
    try {
      VectorXd::Map(rate, system.size) = system.rate(t, VectorXd::Map(q, system.size));
      return GSL_SUCCESS;
    } catch (const std::exception&) {
      return GSL_EBADFUNC;
    }
  }
};

}  // namespace

RunResult run_multistep(const Motion& motion, double tolerance) {
  const Counted counted(motion.rate);
  System parameters{counted.rate(), motion.start.size()};
  gsl_odeiv2_system system{System::evaluate, nullptr, static_cast<std::size_t>(motion.start.size()),
                           &parameters};
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_msadams, 1e-3, tolerance, 0.0),
      gsl_odeiv2_driver_free);
  RunResult result;
  result.state = motion.start;
  double t = 0.0;
  for (const double next : motion.known_at) {
    if (gsl_odeiv2_driver_apply(driver.get(), &t, next, result.state.data()) != GSL_SUCCESS) {
      throw std::runtime_error("msadams failed");
    }
    result.error = std::max(result.error, error_at(motion, t, result.state));
  }
  result.evaluations = counted.evaluations();
  return result;
}

}  // namespace stokesbook::verification::time_stepping
