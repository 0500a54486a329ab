#pragma once

#include <vector>

#include "preconditioning/hierarchical_preconditioner.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Returns whether a factorisation of the whole system takes less time than the iterations that it
/// saves: in small systems with many narrow gaps or with contact (chapter 13, section "When it
/// pays").
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
/// from all others take few iterations without a tree. Many solves for contact forces share a tree:
/// with two pairs in contact within an enclosing wall, elsewhere with as many as there are
/// components. Within a wall, with fewer such pairs, a tree for more than 3 d^2 components pays only
/// if they have three narrow gaps for two components, and some are elongated: the farthest point is
/// more than 2.5 times as far from the centre as the nearest one.
///
/// @param  plan        with the tolerance 10^-d of GMRES; the more digits d, the fewer gaps suffice
/// @param  separation  as in direct_pays()
bool tree_pays(const Plan& plan, const std::vector<Gap>& gaps, const Discretisation& discretisation,
               double separation);

/// Returns whether the tree of groups of an earlier configuration serves nearly as well as a new one,
/// which takes as long as dozens of products with the operator: no two bodies have moved past each
/// other by two lengths of their gap or more. The length is the root of the gap times the smaller
/// radius of gyration, over which the flow in the gap changes.
///
/// @param  gaps  of the later configuration
/// @par Accuracy  iterations in the earlier tree, @ref claim_13_19
bool tree_lasts(const Configuration& earlier, const Configuration& configuration,
                const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Returns whether components have a network of contacts that is too stiff for a tree of groups: two
/// gaps below 0.005 of the smaller radius of gyration for each of more than 30 components, all free.
bool is_crystal(const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Chooses the preconditioner of a configuration: none, block_diagonal, hierarchical, clusters (in
/// crystals, where a tree would pay elsewhere), or direct.
PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation);

/// Chooses which couplings of groups are expansions, and how much is left out: less where there are
/// more than 500 components, so that the number of iterations hardly grows (@ref claim_13_15), and
/// in chains with tight gaps, whose last level is also larger; other numbers where there are at
/// least as many narrow gaps as components, which make a stiff network.
HierarchySettings hierarchy_settings(const std::vector<Gap>& gaps,
                                     const Discretisation& discretisation);

}  // namespace stokesbook
