#pragma once

#include <vector>

#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Returns whether a factorisation of the whole system takes less time than the iterations that it
/// saves.
///
/// The factorisation pays for at most 1000 nodes under one of two conditions: at least a third as
/// many pairs as there are components have gaps below 0.02 of the smaller radius of gyration; or
/// there are at most 400 nodes per pair in contact, since a solve may be required for the force of
/// each pair.
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @param  separation      least gap that contact maintains, length; 0: no contact
/// @return                 true if the factorisation pays
bool direct_pays(const std::vector<Gap>& gaps, const Discretisation& discretisation,
                 double separation);

/// Returns whether clusters save more time than their set-up takes.
///
/// Clusters pay if at least a third as many pairs of inner components as there are components have
/// gaps below 0.003 of the smaller radius of gyration, or in a crowd at least one pair has a gap
/// below 0.005; and if no inner component has more than 256 nodes. In measurements on chains,
/// hexagons and random packings of disks, the set-up took longer than all iterations that it saved
/// at gaps of 0.01, and less at gaps of 0.001. The time of the set-up grows as the cube of a
/// component's number of nodes.
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @return                 true if clusters pay
bool clusters_pay(const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Chooses the preconditioner of a configuration.
///
/// @param  plan            of the scene
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @param  separation      least gap that contact maintains, length; 0: no contact
/// @return                 none, block_diagonal, clusters or direct
PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation);

/// @}

}  // namespace stokesbook
