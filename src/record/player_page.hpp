#pragma once

#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// The page that plays a run, without data. The build joins the files of `src/record/player` into
/// this text.
extern const std::string_view player_page;

/// @}

}  // namespace stokesbook
