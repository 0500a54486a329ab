#pragma once

#include <stdexcept>
#include <string>

#include "record/number_text.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The solver cannot give an answer of the accuracy that the scene requires; the message names
/// bodies, values and what to change.
class SolverError : public std::runtime_error {
 public:
  /// Takes the message.
  using std::runtime_error::runtime_error;
};

/// Components overlap, or their nodes do not resolve the gaps. A time step that leads to such a
/// configuration is taken again, shorter.
class ConfigurationError : public SolverError {
 public:
  /// Takes the message.
  using SolverError::SolverError;
};

/// Begins a message that concerns an instant.
///
/// @param  t  time
/// @return    text with the time, to be followed by the rest
inline std::string at_time(double t) {
  return "t = " + short_number(t, 6) + ": ";
}

/// Runs `work`, and puts the time before the message of a SolverError that it throws.
///
/// @param  t     time that the work concerns
/// @param  work  without arguments
/// @return       what the work returns
/// @throws SolverError, ConfigurationError as the work does, with the time before the message
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

/// @}

}  // namespace stokesbook
