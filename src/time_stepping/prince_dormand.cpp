// Advances by one step of the pair 8(7) of Prince and Dormand, with GSL's stages (chapter 09).
#include "time_stepping/prince_dormand.hpp"

#include <exception>
#include <memory>
#include <new>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// The right-hand side in the form that GSL calls. Exceptions must not pass through GSL's C code:
// evaluate() stores an exception, and prince_dormand87_step() throws it again.
struct Guarded {
  const Rate& f;
  Index size;
  std::exception_ptr thrown;

  static int evaluate(double t, const double* q, double* rate, void* parameters) {
    auto& guarded = *static_cast<Guarded*>(parameters);
    try {
      VectorXd::Map(rate, guarded.size) = guarded.f(t, VectorXd::Map(q, guarded.size));
      return GSL_SUCCESS;
    } catch (...) {
      guarded.thrown = std::current_exception();
      return GSL_EBADFUNC;
    }
  }
};

}  // namespace

EstimatedEnd prince_dormand87_step(const Rate& f, const TimePoint& start, double dt) {
  const auto size = static_cast<std::size_t>(start.state.size());
  const std::unique_ptr<gsl_odeiv2_step, void (*)(gsl_odeiv2_step*)> stepper(
      gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, size), gsl_odeiv2_step_free);
  if (!stepper) throw std::bad_alloc();
  Guarded guarded{f, start.state.size(), nullptr};
  const gsl_odeiv2_system system{Guarded::evaluate, nullptr, size, &guarded};
  EstimatedEnd step{start.state, VectorXd::Zero(start.state.size())};
  gsl_odeiv2_step_apply(stepper.get(), start.t, dt, step.end.data(), step.error.data(),
                        start.rate.data(), nullptr, &system);
  if (guarded.thrown) std::rethrow_exception(guarded.thrown);
  // A fifth of GSL's estimate, by experience (chapter 09).
  step.error *= 0.2;
  return step;
}

}  // namespace stokesbook
