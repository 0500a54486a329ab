#pragma once

#include <memory>
#include <vector>

#include "preconditioning/hierarchical_preconditioner.hpp"
#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

/// A tree of groups, and the components for which it was built.
struct BuiltTree {
  HierarchicalPreconditioner inverse;  ///< the tree, an approximate inverse
  std::vector<Eigen::Index> offsets;   ///< node_offsets() of the components
  Configuration configuration;         ///< poses of the components
};

/// A tree of groups that the systems of several configurations may share; empty: none.
using SharedTree = std::shared_ptr<const BuiltTree>;

}  // namespace stokesbook
