#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_targets.hpp"
#include "preconditioning/cluster_preconditioner.hpp"
#include "preconditioning/hierarchical_preconditioner.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Returns whether a factorisation of the whole system takes less time than the iterations that it
/// saves: in small systems with many narrow gaps, or with many pairs in contact, since a solve may
/// be required for the force of each pair (chapter 13, section "When it pays").
///
/// @param  plan        gaps must be narrower, and nodes fewer, where a tree of groups of free bodies
///                     is allowed
/// @param  gaps        from find_gaps(), here and below
/// @param  separation  least gap that contact maintains, length; 0: no contact
bool direct_pays(const Plan& plan, const std::vector<Gap>& gaps,
                 const Discretisation& discretisation, double separation);

/// Returns whether a tree of groups saves more time than its set-up takes: with many gaps between
/// inner components, several narrow ones, or few very narrow ones, and few nodes on each component,
/// since the time of the set-up grows as the cube of this number. Components most of which are far
/// from all others take few iterations without a tree. Within an enclosing wall, a tree for more
/// components than 3 times the squared number of digits pays only if they have three narrow gaps for
/// two components, and some are elongated: the farthest point is more than 2.5 times as far from the
/// centre as the nearest one.
///
/// @param  plan  the smaller its gmres_tolerance is, the fewer gaps suffice
bool tree_pays(const Plan& plan, const std::vector<Gap>& gaps,
               const Discretisation& discretisation);

/// Returns whether components have a network of contacts that is too stiff for a tree of groups: two
/// gaps below 0.005 of the smaller radius of gyration for each of more than 30 components, all free.
bool is_crystal(const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Chooses the preconditioner of a configuration: none, block_diagonal, hierarchical, clusters (in
/// crystals, where a tree would pay elsewhere), or direct.
PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation);

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

/// Chooses which couplings of groups are expansions, and how much is left out: less where there are
/// more than 500 components, so that the number of iterations hardly grows (@ref claim_13_15), and
/// in chains with tight gaps, whose last level is also larger; other numbers where there are at
/// least as many narrow gaps as components, which make a stiff network.
HierarchySettings hierarchy_settings(const std::vector<Gap>& gaps,
                                     const Discretisation& discretisation);

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

/// Builds a preconditioner of a given kind for the SuspensionOperator of a problem.
///
/// @param  placed  curves of the components for near corrections; empty: none
/// @return         approximate inverse, interleaved; empty: none
/// @throws SolverError when the preconditioner is singular, as the block of a held component is
///                whose size is at the degenerate scale of flow.gauge_length
LinearMap make_preconditioner(PreconditionerKind kind, const Plan& plan, const Scene& scene,
                              const StokesProblem& problem, const Configuration& configuration,
                              const std::vector<Gap>& gaps, const Discretisation& discretisation,
                              const std::vector<PlacedCurve>& placed);

}  // namespace stokesbook
