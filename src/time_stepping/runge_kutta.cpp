// Holds the coefficients of Runge-Kutta schemes, and evaluates their stages (09.6). Advances by one
// step of the pair 8(7) of Prince and Dormand, with GSL's stages (chapter 09).
#include "time_stepping/runge_kutta.hpp"

#include <exception>
#include <memory>
#include <new>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Returns a square matrix from the rows below its diagonal; all other entries are zero.
MatrixXd rows(std::initializer_list<std::initializer_list<double>> below_diagonal) {
  const auto s = static_cast<Index>(below_diagonal.size());
  MatrixXd a = MatrixXd::Zero(s, s);
  for (Index i = 0; const auto& row : below_diagonal) {
    for (Index j = 0; const double x : row) a(i, j++) = x;
    ++i;
  }
  return a;
}

VectorXd weights(std::initializer_list<double> numbers) {
  return VectorXd::Map(numbers.begin(), static_cast<Index>(numbers.size()));
}

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

const Tableau& euler() {
  static const Tableau tableau{rows({{}}), weights({1.0})};
  return tableau;
}

const Tableau& heun() {
  static const Tableau tableau{rows({{}, {1.0}}), weights({0.5, 0.5})};
  return tableau;
}

const Tableau& runge_kutta4() {
  static const Tableau tableau{rows({{}, {0.5}, {0.0, 0.5}, {0.0, 0.0, 1.0}}),
                               weights({1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6}),
                               weights({0.0, 0.0, 0.0, 1.0 / 6, -1.0 / 6})};
  return tableau;
}

const Tableau& bogacki_shampine32() {
  static const Tableau tableau{rows({{}, {0.5}, {0.0, 0.75}}), weights({2.0 / 9, 1.0 / 3, 4.0 / 9}),
                               weights({-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8})};
  return tableau;
}

const Tableau& dormand_prince54() {
  static const Tableau tableau{
      rows({{},
            {1.0 / 5},
            {3.0 / 40, 9.0 / 40},
            {44.0 / 45, -56.0 / 15, 32.0 / 9},
            {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
            {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}}),
      weights({35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}),
      weights({71.0 / 57600, 0.0, -71.0 / 16695, 71.0 / 1920, -17253.0 / 339200, 22.0 / 525,
               -1.0 / 40}),
      weights({-12715105075.0 / 11282082432.0, 0.0, 87487479700.0 / 32700410799.0,
               -10690763975.0 / 1880347072.0, 701980252875.0 / 199316789632.0,
               -1453857185.0 / 822651844.0, 69997945.0 / 29380423.0})};
  return tableau;
}

// [stages]
// k_i = f(t + c_i h, q + h sum_{j<i} a_ij k_j) with c_i = sum_j a_ij (09.6)
MatrixXd runge_kutta_stages(const Tableau& tableau, const Rate& f, const TimePoint& start,
                            double dt) {
  MatrixXd stages(start.state.size(), tableau.b.size());
  stages.col(0) = start.rate;
  for (Index i = 1; i < stages.cols(); ++i) {
    const auto a = tableau.a.row(i).head(i);
    stages.col(i) =
        f(start.t + a.sum() * dt, start.state + dt * (stages.leftCols(i) * a.transpose()));
  }
  return stages;
}
// [stages]

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
