#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/density_decay.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Throws an error that has a message.
///
/// @tparam Error    type of the error
/// @param  message  empty: there is no error
/// @throws Error with the message, unless it is empty
template <class Error = SolverError>
void throw_if(const std::string& message) {
  if (!message.empty()) throw Error(message);
}

/// Explains which components overlap, or touch to rounding.
///
/// @param  scene          names the components
/// @param  gaps           in ascending order
/// @param  configuration  poses of all components
/// @return                a message naming components and place; empty when all are apart
std::string overlap_error(const Scene& scene, const std::vector<Gap>& gaps,
                          const Configuration& configuration);

/// Explains which shape or gap is hopeless at a resolution: no solve is needed to know.
///
/// @param  scene           names the components and the tolerance
/// @param  gaps            in ascending order
/// @param  configuration   poses of all components
/// @param  discretisation  of each component
/// @return                 a message naming components, values and what to change; empty when a
///                         solve may succeed
std::string geometry_error(const Scene& scene, const std::vector<Gap>& gaps,
                           const Configuration& configuration,
                           const Discretisation& discretisation);

/// Explains that the nodes which automatic counts ask for are beyond their limits.
///
/// @param  scene        names the components
/// @param  resolutions  asked for
/// @param  gaps         in ascending order; names the neighbour that asks for nodes
/// @return              a message naming counts and limits; empty within them
std::string limit_error(const Scene& scene, const Resolutions& resolutions,
                        const std::vector<Gap>& gaps);

/// Explains that contact would keep gaps which neither polygons nor positions carry: below 1e-8 of
/// the largest radius, where polygons take too long, or below 1e-10 of the distance from the
/// origin, where rounding of positions is no longer small against the gaps' tolerance.
///
/// @param  separation      that contact keeps, length; 0: no contact
/// @param  start           poses of all components
/// @param  discretisation  of each component
/// @return                 a message naming lengths and limit; empty where there is no reason
std::string separation_error(double separation, const Configuration& start,
                             const Discretisation& discretisation);

/// Explains why data have no solution, or none that could be trusted: a net flux out of an enclosed
/// fluid, a net force in an unbounded one, a gauge length that is not large.
///
/// @param  scene    with its tolerance and gauge length
/// @param  problem  of the scene
/// @return          a message naming values and what to change; empty when nothing is wrong
std::string data_error(const Scene& scene, const StokesProblem& problem);

/// Explains that a solution is not as accurate as was asked, and what would help: nodes on a
/// component that has fewer than its softest mode asks for, or on that whose density has the
/// largest tail, or else fewer digits.
///
/// @param  scene        names components, and says whose nodes are automatic
/// @param  resolutions  of each component
/// @param  least        what the softest mode of each asks for
/// @param  tails        of the density on each component
/// @param  error        the solution's estimate, above the tolerance
/// @param  gaps         in ascending order; names the neighbour that asks for nodes
/// @return              a message with the estimate and a node count that should do
std::string accuracy_error(const Scene& scene, const Resolutions& resolutions,
                           const Resolutions& least, const std::vector<TailEstimate>& tails,
                           double error, const std::vector<Gap>& gaps);

/// @}

}  // namespace stokesbook
