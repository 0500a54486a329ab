#pragma once

#include <stdexcept>

namespace stokesbook {

/// @addtogroup scene
/// @{

/// A scene that cannot be used. The message names the place, the wrong value and a right one:
/// `couette.toml:12:11: bodies[0].n_nodes = 31: must be an even integer >= 8 (try 32)`.
class SceneError : public std::runtime_error {
 public:
  /// Constructs the error from its message.
  using std::runtime_error::runtime_error;
};

/// @}

}  // namespace stokesbook
