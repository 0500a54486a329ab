#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace stokesbook::scene_text {

/// Returns the candidate that was probably meant: fewest single-letter insertions, deletions and
/// replacements away, and no more of them than about a third of the word's letters; none otherwise.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> candidates);

}  // namespace stokesbook::scene_text
