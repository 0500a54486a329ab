// Keeps the memory of large problems low (chapter 13, section "A tree of groups").
#include "preconditioning/large_problems.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace stokesbook {

bool is_large(Eigen::Index n_nodes) {
  return n_nodes > 100'000;
}

void return_freed_memory([[maybe_unused]] bool is_large) {
#ifdef __GLIBC__
  if (is_large) malloc_trim(0);
#endif
}

}  // namespace stokesbook
