#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace stokesbook::scene_text {

/// Returns the candidate that was probably meant: fewest single-letter insertions, deletions and
/// replacements away, and no more of them than about a third of the word's letters.
///
/// @param  word        as it was written
/// @param  candidates  those that are right
/// @return             the nearest, a view of the candidate; none where all are too far
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> candidates);

}  // namespace stokesbook::scene_text
