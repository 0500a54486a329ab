#pragma once

#include <cstddef>
#include <utility>

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// The numbers of two components, the smaller number first.
using ComponentPair = std::pair<std::size_t, std::size_t>;

/// @}

}  // namespace stokesbook
