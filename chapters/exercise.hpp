#pragma once

#include <exception>

namespace stokesbook::exercise {

/// Thrown by a task that its reader has not done yet.
struct NotDone : std::exception {
  const char* what() const noexcept override { return "not done"; }
};

/// Stands where the reader's code is to come. It takes the arguments that this code will need, so
/// that the compiler finds none unused.
template <class... Arguments>
[[noreturn]] void not_done(const Arguments&...) {
  throw NotDone{};
}

}  // namespace stokesbook::exercise
