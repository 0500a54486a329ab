#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/cluster_preconditioner.hpp"
#include "near_singular/near_targets.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Finds the neighbours of each inner component for its cluster: the inner components whose gap
/// from this component is less than the sum of both radii of gyration.
///
/// @param  configuration   where the components are, without overlaps
/// @param  discretisation  of each component
/// @return                 neighbours of each component, ascending; none for an enclosing wall
/// @par Cost               a search in a RectangleIndex per component, N_a N_b distances per close
///                         pair
std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation);

/// Least number of components of a crowd. In a crowd there are motions in long waves, which
/// clusters of held bodies approximate badly.
constexpr std::size_t cluster_crowd = 150;

/// Chooses the form of the clusters that takes fewer iterations.
///
/// The choice is the resistance form for fewer than cluster_crowd components, and for rigid
/// networks, which have at least as many contacts (gaps below 0.05 mean radii of gyration) as
/// components. In all other cases the choice is the mobility form.
/// @param  neighbours  from cluster_neighbours()
/// @return             form of the clusters
ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours);

/// Builds the preconditioner by clusters, with near-corrected layers.
///
/// @param  problem         the boundary value problem
/// @param  configuration   where its components are
/// @param  discretisation  of each component
/// @param  placed          placed curves of the components for near corrections; empty: none
/// @param  form            of the clusters; none: by cluster_form()
/// @return                 the approximate inverse of its SuspensionOperator
/// @throws std::domain_error as invert_block() and ClusterPreconditioner do
/// @par Cost               that of ClusterPreconditioner, and of cluster_block() per distinct shape
ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> form = {});

/// @}

}  // namespace stokesbook
