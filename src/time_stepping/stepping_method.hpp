#pragma once

namespace stokesbook {

/// Method that advances a state.
enum class SteppingMethod {
  euler,               ///< order 1, see euler()
  adams_bashforth2,    ///< order 2, see adams_bashforth2_step(); begins with heun()
  heun,                ///< order 2, see heun()
  rk4,                 ///< order 4, see runge_kutta4()
  bogacki_shampine32,  ///< order 3, adapts its steps, see bogacki_shampine32()
  dormand_prince54,    ///< order 5, adapts its steps, see dormand_prince54()
  prince_dormand87     ///< order 8, adapts its steps, see prince_dormand87_step()
};

/// Returns whether a method is an embedded pair, which adapts its steps to an estimate of their
/// error: true for the last three methods.
constexpr bool is_embedded(SteppingMethod method) {
  return method >= SteppingMethod::bogacki_shampine32;
}

/// Returns the order p of a method: the error of its results is of order h^p in the step h. The
/// error estimate of a step by an embedded pair is of this order, too.
constexpr int order_of(SteppingMethod method) {
  using enum SteppingMethod;
  switch (method) {
    case euler:
      return 1;
    case adams_bashforth2:
    case heun:
      return 2;
    case rk4:
      return 4;
    case bogacki_shampine32:
      return 3;
    case dormand_prince54:
      return 5;
    case prince_dormand87:
      return 8;
  }
  return 0;  // no method
}

/// Returns whether interpolate() is as accurate within a step as the method is at its end, so that
/// steps need not end where the state is required.
constexpr bool has_dense_output(SteppingMethod method) {
  return method == SteppingMethod::bogacki_shampine32 || method == SteppingMethod::dormand_prince54;
}

}  // namespace stokesbook
