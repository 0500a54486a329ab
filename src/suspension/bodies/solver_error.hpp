#pragma once

#include <stdexcept>
#include <string>

#include "text/number_text.hpp"

namespace stokesbook {

/// Thrown when the solver cannot compute a solution with the accuracy that the scene requires. The
/// message names bodies and values, and recommends a change.
class SolverError : public std::runtime_error {
 public:
  /// Stores the message.
  using std::runtime_error::runtime_error;
};

/// Thrown when components overlap, or when their nodes do not resolve the gaps. A time step that
/// leads to such a configuration is repeated with a shorter length.
class ConfigurationError : public SolverError {
 public:
  /// Stores the message.
  using SolverError::SolverError;
};

/// Begins a message that concerns the time t.
inline std::string at_time(double t) {
  return "t = " + short_number(t, 6) + ": ";
}

/// Runs `work`, a function without arguments, and prepends the time to the message of a SolverError
/// that `work` throws.
template <class Work>
auto with_time_in_errors(double t, const Work& work) {
  try {
    return work();
  } catch (const ConfigurationError& error) {
    throw ConfigurationError(at_time(t) + error.what());
  } catch (const SolverError& error) {
    throw SolverError(at_time(t) + error.what());
  }
}

}  // namespace stokesbook
