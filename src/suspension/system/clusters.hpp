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

/// Finds the neighbours that each inner component's cluster takes in: those whose gap is below the
/// sum of both radii of gyration.
///
/// @param  configuration   where the components are, none overlapping
/// @param  discretisation  of each component
/// @return                 of each component, ascending; none of an enclosing wall
/// @par Cost              a search in a RectangleIndex a component, N_a N_b distances a close pair
std::vector<std::vector<Neighbour>> cluster_neighbours(const Configuration& configuration,
                                                       const Discretisation& discretisation);

/// As many bodies are a crowd: long waves, which clusters of held bodies solve badly, have room.
constexpr std::size_t cluster_crowd = 150;

/// Chooses the form that takes fewer iterations: the mobility form in a crowd,
/// unless as many gaps as there are components are below 0.05, where contacts make a rigid network.
///
/// @param  neighbours  from cluster_neighbours()
/// @return             the form
ClusterForm cluster_form(const std::vector<std::vector<Neighbour>>& neighbours);

/// Builds the preconditioner by clusters, with near-corrected layers.
///
/// @param  problem         the boundary value problem
/// @param  configuration   where its components are
/// @param  discretisation  of each component
/// @param  placed          the same components for near corrections; empty: none
/// @param  form            of the clusters; as cluster_form() chooses where none is given
/// @return                 the approximate inverse of its SuspensionOperator
/// @throws std::domain_error as invert_block() and ClusterPreconditioner do
/// @par Cost              that of ClusterPreconditioner, and of a
/// cluster_block() a distinct shape
ClusterPreconditioner cluster_preconditioner(const StokesProblem& problem,
                                             const Configuration& configuration,
                                             const Discretisation& discretisation,
                                             const std::vector<PlacedCurve>& placed,
                                             std::optional<ClusterForm> form = {});

/// @}

}  // namespace stokesbook
