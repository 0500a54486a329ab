#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/system/error_estimate.hpp"

namespace stokesbook {

/// Throws an error of the given type unless its message is empty.
///
/// The functions in solver_checks.hpp whose names end in _error return such messages, which name
/// components and values and recommend a change. Messages are empty if nothing is wrong. Gaps must
/// be in ascending order: the first gap of a component leads to its nearest neighbour.
template <class Error = SolverError>
void throw_if(const std::string& message) {
  if (!message.empty()) throw Error(message);
}

/// Explains that the minimum separation is too small: below 1e-8 of the largest radius, where
/// polygons take too long, or below 1e-10 of the distance from the origin, where rounding errors of
/// positions are no longer small against the tolerance of gaps.
///
/// @param  separation  least gap that contact maintains, length; 0: no contact
std::string separation_error(double separation, const Configuration& start,
                             const Discretisation& discretisation);

/// Returns how much memory the process may take, in bytes: the memory of the machine, or the
/// process's address-space limit if it is less.
double available_memory();

/// Estimates the memory of a DiscretisedShape in bytes: three dense matrices, 2 N x 2 N each.
constexpr double memory_of_discretised_shape(int n_nodes) {
  return 3.0 * 8.0 * (2.0 * n_nodes) * (2.0 * n_nodes);
}

/// Explains that the matrices of all shapes take more memory than is available, in bytes.
std::string memory_error(const Scene& scene, const Resolutions& resolutions, double available);

/// Explains that automatic nodes exceed their limits, most_nodes_of_a_component or about a million
/// in all, or that the matrices exceed the available memory.
std::string limit_error(const Scene& scene, const Resolutions& resolutions,
                        const std::vector<Gap>& gaps);

/// Explains which components overlap, or touch to rounding.
std::string overlap_error(const Scene& scene, const std::vector<Gap>& gaps,
                          const Configuration& configuration);

/// Explains which shape or gap is resolved so badly that a solution could not meet the tolerance.
/// The check requires no solve.
std::string geometry_error(const Scene& scene, const std::vector<Gap>& gaps,
                           const Configuration& configuration,
                           const Discretisation& discretisation);

/// Explains why the data have no solution, or no reliable solution: a net flux out of an enclosed
/// fluid, or into a body; a net force in an unbounded fluid; a gauge length that is not large
/// against bodies; or a uniform flow that has no effect.
std::string data_error(const Scene& scene, const StokesProblem& problem);

/// Explains that a solution does not meet the tolerance, and which change would help: more nodes on
/// a component that has fewer than its softest mode requires, more nodes on the component whose
/// density has the largest tail, or a larger tolerance.
///
/// @param  least  resolutions that the softest mode of each component requires
/// @param  error  error estimate of the solution, above the tolerance
std::string accuracy_error(const Scene& scene, const Resolutions& resolutions,
                           const Resolutions& least, const std::vector<TailEstimate>& tails,
                           double error, const std::vector<Gap>& gaps);

}  // namespace stokesbook
