#pragma once

#include <vector>

#include "suspension/bodies/discretised_shape.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Tells whether a factorisation of the whole system takes less time than the iterations that it
/// saves: for 1000 nodes or fewer, where a third as many pairs as there are components, or more,
/// have gaps below 0.02 of the smaller radius of gyration; or where so many pairs are in contact,
/// each of which may ask for the response to its force, that there are 400 nodes a pair or fewer.
///
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @param  separation      that contact keeps, length; 0: no contact
/// @return                 true where it pays
bool direct_pays(const std::vector<Gap>& gaps, const Discretisation& discretisation,
                 double separation);

/// Tells whether clusters save more time than they take to set up: where a third as many pairs of
/// inner components as there are components have gaps below 0.003 of the smaller radius of
/// gyration, or in a crowd one below 0.005; and no inner component has more than 256 nodes.
///
/// Measured on chains, hexagons and random packings of disks: at gaps of 0.01 the set-up takes
/// longer than all iterations that it saves, at 0.001 less. It grows like the
/// cube of a component's nodes.
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @return                 true where they pay
bool clusters_pay(const std::vector<Gap>& gaps, const Discretisation& discretisation);

/// Chooses the preconditioner of a configuration.
///
/// @param  plan            what the scene needs
/// @param  gaps            from find_gaps()
/// @param  discretisation  of each component
/// @param  separation      that contact keeps, length; 0: no contact
/// @return                 none, block_diagonal, clusters or direct
PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation);

/// @}

}  // namespace stokesbook
