#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/cluster_preconditioner.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_targets.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Returns whether a factorisation of the whole system takes less time than the iterations that it
/// saves.
///
/// The factorisation pays for at most 1000 nodes under one of two conditions: at least a third as
/// many pairs as there are components have gaps below 0.02 of the smaller radius of gyration; or
/// there are at most 400 nodes per pair in contact, since a solve may be required for the force of
/// each pair.
/// @param  gaps        from find_gaps(), as for the next two functions
/// @param  separation  least gap that contact maintains, length; 0: no contact
bool direct_pays(const std::vector<Gap>& gaps, const Discretisation& discretisation,
                 double separation);

/// Returns whether clusters save more time than their set-up takes.
///
/// Clusters pay if at least a third as many pairs of inner components as there are components have
/// gaps below 0.003 of the smaller radius of gyration, or in a crowd (150 components) at least one
/// pair has a gap below 0.005; and if no inner component has more than 256 nodes. In measurements
/// on chains, hexagons and random packings of disks, the set-up took longer than all iterations
/// that it saved at gaps of 0.01, and less at gaps of 0.001. The time of the set-up grows as the
/// cube of a component's number of nodes.
bool clusters_pay(const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Chooses the preconditioner of a configuration: none, block_diagonal, clusters or direct.
PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation);

/// Finds the neighbours of each inner component for its cluster: the inner components whose gap
/// from this component is less than the sum of both radii of gyration. Components must not overlap.
///
/// @return    neighbours of each component, ascending; none for an enclosing wall
/// @par Cost  a search in a RectangleIndex per component, N_a N_b distances per close pair
std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation);

/// Chooses the form of the clusters that takes fewer iterations.
///
/// The choice is the resistance form for fewer than 150 components, and for rigid networks, which
/// have at least as many contacts (gaps below 0.05 mean radii of gyration) as components. In all
/// other cases the choice is the mobility form: in a crowd there are motions in long waves, which
/// clusters of held bodies approximate badly.
ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours);

/// Builds the preconditioner by clusters, with near-corrected layers.
///
/// @param  placed  placed curves of the components for near corrections; empty: none
/// @param  form    of the clusters; none: by cluster_form()
/// @throws std::domain_error as invert_block() and ClusterPreconditioner do
/// @par Cost       that of ClusterPreconditioner, and of cluster_block() per distinct shape
ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> form = {});

/// Builds a preconditioner of a given kind for the SuspensionOperator of a problem.
///
/// @param  placed  placed curves of the components for near corrections; empty: none
/// @return         approximate inverse, interleaved; empty: none
/// @throws SolverError when the preconditioner is singular, as the block of a held component is
///                whose size is at the degenerate scale of flow.gauge_length
LinearMap make_preconditioner(PreconditionerKind kind, const Plan& plan, const Scene& scene,
                              const StokesProblem& problem, const Configuration& configuration,
                              const Discretisation& discretisation,
                              const std::vector<PlacedCurve>& placed);

}  // namespace stokesbook
