#pragma once

#include <vector>

#include "closure/problem.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_targets.hpp"
#include "preconditioning/cluster_preconditioner.hpp"
#include "preconditioning/hierarchical_preconditioner.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/built_tree.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Finds the neighbours of each inner component for its cluster: the inner components whose gap
/// from this component is less than the sum of both radii of gyration. Components must not overlap.
///
/// @return    neighbours of each component, ascending; none for an enclosing wall
/// @par Cost  a search in a RectangleIndex per component, N_a N_b distances per close pair
std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation);

/// Builds the preconditioner by clusters, with near-corrected layers.
///
/// @param  placed  curves of the components for near corrections; empty: none
/// @throws std::domain_error as invert_block() and ClusterPreconditioner do
/// @par Cost       that of ClusterPreconditioner, and of cluster_block() per distinct shape
ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             ClusterForm form = ClusterForm::resistance);

/// Builds the preconditioner by a tree of groups, with near-corrected layers.
///
/// @param  placed  curves of the components for near corrections; empty: none
/// @throws std::domain_error as invert_block() does
/// @par Cost       that of HierarchicalPreconditioner, and of self_block() per distinct shape
HierarchicalPreconditioner hierarchical_preconditioner(const StokesProblem& problem,
                                                       const Configuration& configuration,
                                                       const Discretisation& discretisation,
                                                       const std::vector<PlacedCurve>& placed,
                                                       const HierarchySettings& settings = {});

/// A preconditioner of a SuspensionOperator.
struct Preconditioner {
  LinearMap inverse = {};  ///< approximate, interleaved; empty: none
  SharedTree tree = {};    ///< that `inverse` applies, if it is hierarchical
};

/// Builds a preconditioner of a given kind for the SuspensionOperator of a problem.
///
/// @param  placed   curves of the components for near corrections; empty: none
/// @param  earlier  a tree that is used again if tree_lasts()
/// @throws SolverError when the preconditioner is singular, as the block of a held component is
///                whose size is at the degenerate scale of flow.gauge_length
Preconditioner make_preconditioner(PreconditionerKind kind, const Plan& plan, const Scene& scene,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation,
                                   const std::vector<PlacedCurve>& placed,
                                   const SharedTree& earlier);

}  // namespace stokesbook
