#pragma once

#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// The page that plays a run, without its data: the files of `src/record/player` in one text, made
/// by the build.
extern const std::string_view player_page;

/// @}

}  // namespace stokesbook
