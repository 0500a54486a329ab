// Which variant of an exercise a run is about.

#include "chapters/variant.hpp"

#include <cstdlib>
#include <string>

bool stokesbook::exercise::is_variant(const char* name) {
  static const char* const variable = std::getenv("STOKESBOOK_VARIANT");
  static const std::string variant = variable ? variable : "solution";
  return variant == name;
}
