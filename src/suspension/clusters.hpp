#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/cluster_preconditioner.hpp"
#include "near_singular/near_targets.hpp"
#include "suspension/configuration.hpp"
#include "suspension/reference.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Finds the neighbours that each inner component's cluster takes in: those whose gap is below the
/// sum of both radii of gyration.
///
/// @param  configuration  where the components are, none overlapping
/// @param  references     of each component
/// @return                of each component, ascending; none of an enclosing wall
/// @par Cost              a search in a RectangleIndex a component, N_a N_b distances a close pair
std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const References& references);

/// Tells whether clusters save more time than they take to set up: where a third as many pairs as
/// there are components have gaps below 0.003 of their mean radius of gyration, or among 150
/// components one below 0.005; and no inner component has more than 256 nodes.
///
/// Measured on chains, hexagons and random packings of disks: at gaps of 0.01 the set-up takes longer
/// than all iterations that it saves, at 0.001 less. It grows like the cube of a component's nodes.
/// @param  configuration  where the components are, none overlapping
/// @param  references     of each component
/// @return                true where they pay
/// @par Cost              that of cluster_neighbours()
bool clusters_pay(const Configuration& configuration, const References& references);

/// Chooses the form that takes fewer iterations: the mobility form among 150 components or more,
/// unless as many gaps as there are components are below 0.05, where contacts make a rigid network.
///
/// @param  neighbours  from cluster_neighbours()
/// @return             the form
ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours);

/// Builds the preconditioner by clusters, with near-corrected layers.
///
/// @param  problem        the boundary value problem
/// @param  configuration  where its components are
/// @param  references     of each component
/// @param  placed         the same components for near corrections; empty: none
/// @param  form           of the clusters; as cluster_form() chooses where none is given
/// @return                the approximate inverse of its SuspensionOperator
/// @throws std::domain_error as cluster_block() and ClusterPreconditioner do
/// @par Cost              that of ClusterPreconditioner, and of a cluster_block() a distinct reference
ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const References& references,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> form = {});

/// @}

}  // namespace stokesbook
