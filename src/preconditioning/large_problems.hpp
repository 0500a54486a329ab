#pragma once

#include <Eigen/Core>

namespace stokesbook {

/// Returns whether a problem has so many nodes that memory counts more than time: over 100,000.
bool is_large(Eigen::Index n_nodes);

/// Returns freed memory to the system, if it was used for a large problem. The library of C keeps
/// much of it, since blocks of many sizes come and go. Small problems are solved in every time
/// step, and use it again.
void return_freed_memory(bool is_large);

}  // namespace stokesbook
