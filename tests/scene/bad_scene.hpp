#pragma once

#include <string>
#include <vector>

#include "scene_text.hpp"

namespace stokesbook::test {

struct BadScene {
  std::string text;
  std::string message;
};

inline void check(const std::vector<BadScene>& scenes) {
  for (const auto& [text, message] : scenes) {
    BOOST_TEST_CONTEXT(text) {
      BOOST_TEST(error_of(text) == message);
    }
  }
}

}  // namespace stokesbook::test
