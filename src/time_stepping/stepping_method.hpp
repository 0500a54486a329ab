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

/// Returns whether interpolate() is as accurate within a step as the method is at its end, so that
/// steps need not end where the state is required.
constexpr bool has_dense_output(SteppingMethod method) {
  return method == SteppingMethod::bogacki_shampine32 || method == SteppingMethod::dormand_prince54;
}

}  // namespace stokesbook
