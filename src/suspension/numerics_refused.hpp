#pragma once

#include <stdexcept>

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

/// @}

}  // namespace stokesbook
