#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "stiv/component_pair.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/nodes/density_decay.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Most nodes that are chosen for one component: matrices of its shape take 0.4 GB.
inline constexpr int most_nodes_of_a_component = 2048;

/// Most nodes that are chosen in all: an application of the operator takes some seconds a core, a
/// solve some 2 GB.
inline constexpr int most_nodes_in_all = 1 << 20;

/// Most nodes that a shape alone is tried with.
inline constexpr int most_nodes_for_shape = 4096;

/// Recommends a node count for which a shape resolves its own double layer to a tolerance.
///
/// @param  shape      in its own frame
/// @param  side       of the fluid
/// @param  tolerance  of shape_residual()
/// @param  at_least   where the search starts
/// @return            multiple of 16, >= at_least, or 0 when most_nodes_for_shape are not enough
/// @par Cost          shape_residual() of each count that is tried, 16 or a quarter apart
int nodes_for_shape(const Shape& shape, Side side, double tolerance, int at_least);

/// Recommends a node count that resolves the softest mode of a component's own block to a tenth.
///
/// @param  cache    where discretised shapes are kept
/// @param  shape    in its own frame
/// @param  kind     of the component
/// @param  n_nodes  where the search starts, <= most_nodes_of_a_component
/// @return          the same number where it does, or a multiple of 4; the last one tried where no
///                  number up to most_nodes_of_a_component does
/// @par Cost        softest_mode_error() of two or three counts, O(N^3)
int nodes_for_softest_mode(DiscretisationCache& cache, const Shape& shape, ComponentKind kind,
                           int n_nodes);

/// Explains that no number of nodes resolves a shape.
///
/// @param  shape      in its own frame
/// @param  tolerance  that was asked for
/// @return            a message with the tolerance and what to change, without a subject
std::string unresolved_shape(const Shape& shape, double tolerance);

/// Returns the nodes that a component is given, or enough for its shape.
///
/// @param  component  a ComponentView or Fill, with its shape and node count
/// @param  side       of the fluid
/// @param  tolerance  of shape_residual()
/// @param  name       of the component, for messages
/// @return            nodes, > 0
/// @throws SolverError when the nodes are automatic and most_nodes_for_shape are not enough
/// @par Cost          that of nodes_for_shape() where nodes are automatic
template <class Component>
int own_nodes(const Component& component, Side side, double tolerance, const std::string& name) {
  if (component.n_nodes != automatic_nodes) return component.n_nodes;
  const int nodes = nodes_for_shape(component.shape, side, tolerance, 16);
  if (nodes == 0) throw SolverError(name + ": " + unresolved_shape(component.shape, tolerance));
  return nodes;
}

/// Rounds a number of nodes up to one of few, so that configurations nearby share discretised shapes.
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

/// Returns resolutions of half as many nodes, as far as rounded_nodes() goes.
///
/// @param  resolutions  of each component
/// @return              coarser ones, as graded as they were
Resolutions coarser(Resolutions resolutions);

/// Makes automatic resolutions finer, and leaves given ones.
///
/// @param  scene   that asks for them
/// @param  before  of each component
/// @return         as finer() where nodes are automatic
Resolutions finer_automatic(const Scene& scene, Resolutions before);

/// Makes automatic resolutions of some pairs finer by half, and leaves all else.
///
/// @param  scene   that asks for them
/// @param  before  of each component
/// @param  pairs   of components
/// @return         half as many nodes again where they are automatic
Resolutions finer_in_pairs(const Scene& scene, Resolutions before,
                           const std::vector<ComponentPair>& pairs);

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
