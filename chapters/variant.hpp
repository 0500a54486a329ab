#pragma once

/// One program has all variants of an exercise; exercises.py writes its source.
namespace stokesbook::exercise {

/// Whether this run of the program is that of a variant: the environment variable
/// STOKESBOOK_VARIANT holds its name.
bool is_variant(const char* name);

}  // namespace stokesbook::exercise
