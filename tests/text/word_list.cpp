// Tests the parts of texts, and the guess of the key that a misspelt key most likely stands for.
#include "text/word_list.hpp"

#include <array>
#include <string_view>
#include <vector>

#include <boost/test/unit_test.hpp>

using stokesbook::nearest_word;

namespace {

constexpr std::array<std::string_view, 5> keys{"kind", "radius", "semi_axes", "dt", "omega"};

/// Returns the guess, or "none".
std::string_view guess(std::string_view word) {
  return nearest_word(word, keys).value_or("none");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(nearest_word_suite)

BOOST_AUTO_TEST_CASE(splits_at_every_separator) {
  using Parts = std::vector<std::string_view>;
  BOOST_TEST((stokesbook::split("x,y,theta", ',') == Parts{"x", "y", "theta"}));
  BOOST_TEST((stokesbook::split(",a,", ',') == Parts{"", "a", ""}));
  BOOST_TEST((stokesbook::split("", ',') == Parts{""}));
}

BOOST_AUTO_TEST_CASE(names_have_letters_digits_and_underscores) {
  for (const char* name : {"a", "_", "time_dt", "12_3"})
    BOOST_TEST(stokesbook::is_name(name), name);
  for (const char* text : {"", "a b", "time.dt", "-", "\xc3\xa4"}) {
    BOOST_TEST(!stokesbook::is_name(text), text);
  }
}

BOOST_AUTO_TEST_CASE(finds_what_was_meant) {
  BOOST_TEST(guess("radis") == "radius");    // a letter left out
  BOOST_TEST(guess("radiuss") == "radius");  // a letter too many
  BOOST_TEST(guess("radiis") == "radius");   // a wrong letter
  BOOST_TEST(guess("raduis") == "radius");   // two letters swapped
  BOOST_TEST(guess("knid") == "kind");       // the same in a short word
  BOOST_TEST(guess("semiaxis") == "semi_axes");
  BOOST_TEST(guess("omega0") == "omega");
}

BOOST_AUTO_TEST_CASE(does_not_guess_wildly) {
  BOOST_TEST(guess("mass") == "none");
  BOOST_TEST(guess("x") == "none");
  BOOST_TEST(guess("") == "none");
  BOOST_TEST(guess("diameter") == "none");
  BOOST_TEST(!nearest_word("kind", {}).has_value());
}

BOOST_AUTO_TEST_CASE(takes_the_nearest) {
  constexpr std::array<std::string_view, 3> close{"dt_min", "dt_max", "dt"};
  BOOST_TEST(nearest_word("dt_mix", close).value_or("none") == "dt_min");
  BOOST_TEST(nearest_word("dt_mad", close).value_or("none") == "dt_max");
}

BOOST_AUTO_TEST_SUITE_END()
