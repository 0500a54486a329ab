#pragma once

#include <stdexcept>
#include <string>

#include "record/number_text.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// The numerics decline to give an answer they cannot stand behind; the message names bodies,
/// values and what to change.
class NumericsRefused : public std::runtime_error {
 public:
  /// Takes the message.
  using std::runtime_error::runtime_error;
};

/// Components overlap, or their nodes do not resolve the gaps; a time step that leads there is
/// tried again, shorter.
class ConfigurationRefused : public NumericsRefused {
 public:
  /// Takes the message.
  using NumericsRefused::NumericsRefused;
};

/// Begins a message that concerns an instant.
///
/// @param  t  time
/// @return    text with the time, to be followed by the rest
inline std::string at_time(double t) {
  return "t = " + short_number(t, 6) + ": ";
}

/// Does some work, and adds the time to what it refuses.
///
/// @param  t     time that the work concerns
/// @param  work  without arguments
/// @return       what the work returns
/// @throws NumericsRefused, ConfigurationRefused as the work does, with the time before the message
template <class Work>
auto dated(double t, const Work& work) {
  try {
    return work();
  } catch (const ConfigurationRefused& refusal) {
    throw ConfigurationRefused(at_time(t) + refusal.what());
  } catch (const NumericsRefused& refusal) {
    throw NumericsRefused(at_time(t) + refusal.what());
  }
}

/// @}

}  // namespace stokesbook
