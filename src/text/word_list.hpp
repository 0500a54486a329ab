#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stokesbook {

/// Joins a range of words into one text, "euler, heun".
/// @param  to_word  function, or pointer to a member, that returns the word of an item
template <class ToWord = std::identity>
std::string joined(const auto& items, std::string_view separator = ", ", ToWord to_word = {}) {
  std::string text;
  for (bool first = true; const auto& item : items) {
    if (!std::exchange(first, false)) text += separator;
    text += std::invoke(to_word, item);
  }
  return text;
}

/// Splits a text at every separator. The parts are views of the text.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Writes rows of equally many cells as lines, in columns that end at the same letter.
std::string aligned_rows(const std::vector<std::vector<std::string>>& rows);

/// Returns whether a text is a name: not empty, of letters, digits and _ only.
bool is_name(std::string_view text);

/// Returns the candidate that is nearest to a misspelt word by single-letter insertions, deletions
/// and replacements; none if it requires more of them than a third of the word's letters.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> candidates);

}  // namespace stokesbook
