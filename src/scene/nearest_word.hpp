#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace stokesbook::scene_text {

/// Returns the candidate that was probably meant: the candidate nearest to a misspelt word.
///
/// The distance of two words is the least number of single-letter insertions, deletions and
/// replacements that turn one into the other. A candidate is too far if its distance exceeds about
/// a third of the word's letters.
/// @param  word        the word as it was written
/// @param  candidates  the valid words
/// @return             the nearest candidate, a view of it; none if all are too far
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> candidates);

}  // namespace stokesbook::scene_text
