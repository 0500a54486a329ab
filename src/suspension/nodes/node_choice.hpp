#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "stiv/separation.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/density_decay.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Largest number of nodes that is chosen for one component: the matrices of its shape take 0.4 GB.
inline constexpr int most_nodes_of_a_component = 2048;

/// Largest number of nodes that is chosen in all: an application of the operator takes some seconds
/// on one core, and a solve takes some 2 GB.
inline constexpr int most_nodes_in_all = 1 << 20;

/// Largest number of nodes that is tested for a shape alone.
inline constexpr int most_nodes_for_shape = 4096;

/// Recommends a number of nodes that resolve a shape and its own double layer to a tolerance.
///
/// @param  shape      in its own frame
/// @param  side       of the fluid
/// @param  tolerance  of shape_residual()
/// @param  at_least   number with which the search starts
/// @return            multiple of 16, >= at_least, or 0 if most_nodes_for_shape do not suffice
/// @par Cost          shape_residual() for each number that is tested, 16 or a quarter apart
int nodes_for_shape(const Shape& shape, Side side, double tolerance, int at_least);

/// Recommends a number of nodes for which softest_mode_error() is at most a tenth.
///
/// @param  cache    cache of discretised shapes
/// @param  shape    in its own frame
/// @param  kind     of the component
/// @param  n_nodes  number with which the search starts, <= most_nodes_of_a_component
/// @return          n_nodes if it suffices, otherwise a multiple of 4; the last number tested if no
///                  number up to most_nodes_of_a_component suffices
/// @par Cost        softest_mode_error() for two or three numbers, O(N^3)
int nodes_for_softest_mode(DiscretisationCache& cache, const Shape& shape, ComponentKind kind,
                           int n_nodes);

/// Explains that no number of nodes resolves a shape.
///
/// @param  shape      in its own frame
/// @param  tolerance  required bound of shape_residual()
/// @return            a message with the tolerance and what to change, without a subject
std::string unresolved_shape(const Shape& shape, double tolerance);

/// Returns the given number of nodes of a component, or a number that resolves its shape.
///
/// @param  component  a ComponentView or Fill, with its shape and number of nodes
/// @param  side       of the fluid
/// @param  tolerance  of shape_residual()
/// @param  name       of the component, for messages
/// @return            number of nodes, > 0
/// @throws SolverError when the nodes are automatic and most_nodes_for_shape do not suffice
/// @par Cost          that of nodes_for_shape() if nodes are automatic
template <class Component>
int own_nodes(const Component& component, Side side, double tolerance, const std::string& name) {
  if (component.n_nodes != automatic_nodes) return component.n_nodes;
  const int nodes = nodes_for_shape(component.shape, side, tolerance, 16);
  if (nodes == 0) throw SolverError(name + ": " + unresolved_shape(component.shape, tolerance));
  return nodes;
}

/// Rounds a number of nodes up to one of a few values, so that nearby configurations share
/// discretised shapes.
///
/// @param  nodes  >= 0
/// @return        multiple of 16, >= 16; from 256 on, a multiple of an eighth of the largest power
///                of two that does not exceed the number
int rounded_nodes(double nodes);

/// Returns the resolutions on which estimate_error() judges a solution: a quarter more nodes, but
/// at least 16 more.
///
/// @param  resolutions  of the solution
/// @return              resolutions of the same gradings, with even numbers of nodes if the given
///                      numbers are even
Resolutions finer(Resolutions resolutions);

/// Returns resolutions with half as many nodes, rounded up by rounded_nodes().
///
/// @param  resolutions  of each component
/// @return              coarser resolutions of the same gradings
Resolutions coarser(Resolutions resolutions);

/// Makes the resolutions of components with automatic nodes finer, and keeps all others.
///
/// @param  scene   scene whose components have automatic or given nodes
/// @param  before  of each component
/// @return         resolutions by finer() for components with automatic nodes
Resolutions finer_automatic(const Scene& scene, Resolutions before);

/// Increases the automatic node numbers of the components in some pairs by half, and keeps all
/// others.
///
/// @param  scene   scene whose components have automatic or given nodes
/// @param  before  of each component
/// @param  pairs   of components
/// @return         resolutions with half as many nodes again in these components, up to
///                 most_nodes_of_a_component
Resolutions finer_in_pairs(const Scene& scene, Resolutions before,
                           const std::vector<ComponentPair>& pairs);

/// Extrapolates the number of nodes that a component requires from the decay of its density's tail.
///
/// @param  n_nodes  present number of nodes
/// @param  decay    rate of decay per mode number, >= 0: the error falls as \f$ e^{-decay\,n} \f$
/// @param  excess   error over the required error, > 1
/// @return          number of nodes, at most 1.5 n_nodes
double extrapolated_nodes(int n_nodes, double decay, double excess);

/// Chooses finer resolutions after a solve whose error estimate exceeds the tolerance.
///
/// The share of a component in the error is the estimate, times the tail on this component over the
/// largest tail. Components with given nodes keep them.
/// @param  scene      scene; only its components with automatic_nodes may change
/// @param  before     resolutions of the solution
/// @param  tails      of the solution's density on each component
/// @param  error      error estimate of the solution, above the tolerance of the scene
/// @return            finer resolutions for components whose share exceeds a tenth of the
///                    tolerance; the same resolutions if there is no such component, or if all
///                    tails are below a tenth of the tolerance, since more nodes would not help
Resolutions raised(const Scene& scene, Resolutions before, const std::vector<TailEstimate>& tails,
                   double error);

/// @}

}  // namespace stokesbook
