#pragma once

#include <sstream>
#include <stdexcept>

namespace stokesbook {

/// Throws an Error if a requirement is not met, with a message whose parts are written one after
/// the other, as a stream writes them.
template <class Error = std::invalid_argument>
void require(bool is_met, const auto&... message) {
  if (is_met) return;
  std::ostringstream text;
  (text << ... << message);
  throw Error(text.str());
}

}  // namespace stokesbook
