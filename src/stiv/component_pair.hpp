#pragma once

#include <cstddef>
#include <utility>

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// Two components, the lesser number first.
using ComponentPair = std::pair<std::size_t, std::size_t>;

/// @}

}  // namespace stokesbook
