#pragma once

#include <string>
#include <vector>

#include "suspension/gaps.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Most nodes that are chosen for one component: matrices of its reference take 0.4 GB.
inline constexpr int most_nodes_of_a_component = 2048;

/// Most nodes that are chosen in all: an application of the operator takes some 2 s a core.
inline constexpr int most_nodes_in_all = 65536;

/// Rounds a number of nodes up to one of few, so that configurations nearby share references.
///
/// @param  nodes  >= 0
/// @return        multiple of 16, above 256 of an eighth of the power of two below; >= 16
int rounded_nodes(double nodes);

/// Returns the resolutions on which estimate_error() judges a solution: a quarter more nodes, 16 at
/// least.
///
/// @param  resolutions  of the solution
/// @return              even numbers of nodes for even ones
Resolutions finer(Resolutions resolutions);

/// Extrapolates the nodes that a component needs from what its density's tail says.
///
/// @param  n_nodes  those it has
/// @param  decay    a mode number's rate of decay, >= 0: the error falls like \f$ e^{-decay\,n} \f$
/// @param  excess   error over what is asked, > 1
/// @return          nodes, at most half as many again
double extrapolated_nodes(int n_nodes, double decay, double excess);

/// Chooses how finely each component of an unresolved solution is to be discretised next.
///
/// The estimate is shared out like the tails. Components whose count is given keep it.
/// @param  scene      whose components with automatic_nodes may change
/// @param  before     resolutions of the solution
/// @param  tails      of its density on each component
/// @param  error      its estimate, above the tolerance of the scene
/// @return            finer for those whose share exceeds a tenth of the tolerance; the same where
///                    that is none, or all tails are below it: more nodes would not help
Resolutions raised(const Scene& scene, Resolutions before, const std::vector<TailEstimate>& tails,
                   double error);

/// @}

}  // namespace stokesbook
