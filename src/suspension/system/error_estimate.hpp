#pragma once

#include <optional>
#include <vector>

#include "scene/scene.hpp"
#include "stiv/near_pairs.hpp"
#include "suspension/system/linear_system.hpp"

namespace stokesbook {

/// Measures by how much two solutions of one problem differ, in the units in which errors are
/// reported.
///
/// The differences are those of the velocities and of \f$ a\omega \f$ of free bodies, with the root
/// mean square radius a, relative to the scale of velocities; and those of the loads on prescribed
/// components. Forces are divided by \f$ 4\pi\mu \f$, and torques by \f$ 4\pi\mu a \f$. Their
/// differences are relative to the scale of velocities, or to the largest load in these units if it
/// is larger, as near contact. In a periodic cell, the mean velocity counts like the motions.
/// @return  largest difference, dimensionless; none if there is no component but an enclosing wall
std::optional<double> relative_change(const StokesProblem& problem, const Completion& p,
                                      const Completion& q, double scale);

/// The estimated error of a solution, and the cost of the estimate.
struct ErrorEstimate {
  double error = 0.0;          ///< error of motions and loads, as relative_change() measures them
  int matvecs = 0;             ///< applications of the fine operator
  ComplexVector density = {};  ///< corrected, on the finer nodes, length / time; empty if unknown
};

/// Estimates the error of a solution's motions and loads by a correction on finer nodes.
///
/// The density is interpolated to the finer nodes, where it leaves a residual r. The system on the
/// finer nodes is solved for the correction of r, which leaves at most a tenth of the residual of
/// the solution, so that the estimate includes the error of the iteration. With a hierarchical
/// preconditioner, which leaves no soft modes, it leaves as much as the solution. The estimate is
/// twice the relative_change() by this correction; if there are neither motions nor loads, it is
/// twice the largest change of the density over the scale.
/// @param  coarse    the system that was solved; its preconditioner is also used for the fine one
/// @param  density   its solution
/// @param  residual  relative residual of the solution; for a direct solution, the one that GMRES
///                   may leave if it is larger
/// @param  fine      the same problem with about a quarter more nodes, equidistant in the same
///                   parameter of each component; its preconditioner is replaced
/// @param  scale     of velocities, > 0, length / time
/// @throws SolverError as solve() does
/// @par Accuracy  within a factor 10 of the error in 95 of 100 scenes, @ref claim_12_1; never less
/// than a thirtieth of the error, @ref claim_12_2
/// @par Cost      a quarter to twice the applications of the solution, with a quarter more nodes.
/// GMRES starts anew before its bases exceed some 130 MB each.
ErrorEstimate estimate_error(const LinearSystem& coarse, const ComplexVector& density,
                             double residual, LinearSystem fine, double scale);

/// An error estimate from the Fourier modes of a computed density.
struct TailEstimate {
  double error;  ///< error of velocities, relative to their scale
  double decay;  ///< rate of decay per mode number in the middle of the spectrum, >= 0
};

/// Estimates the error of velocities from the tail of a computed density on one component.
///
/// Let S be the sum of the modes beyond the grid, and M the largest value of the density. The
/// estimate is \f$ 60\,S^2/M \f$ over the scale, but at most 10 S over the scale: a density that
/// consists of rounding errors cannot cause more. S is extrapolated from the middle of the
/// spectrum. The last modes enter S without extrapolation: near a close neighbour they are aliases,
/// which harm velocities less.
///
/// On 56 random scenes of two and three bodies, the estimate was 0.5 to 4000 times the error, and
/// at most 20 times the error in half of the scenes.
/// @param  density  at the component's N nodes, N even and >= 8, without its rigid part
/// @return          error 0 and infinite decay for a density of zeros
TailEstimate tail_estimate(const ComplexVector& density, double scale);

/// Estimates the error on each component by tail_estimate(), but at least by the shape residual,
/// since the tail does not show the aliasing error of the kernel.
std::vector<TailEstimate> tail_estimates(const LinearSystem& discrete,
                                         const Discretisation& discretisation,
                                         const ComplexVector& density, double scale);

/// Returns the resolutions on which estimate_error() judges a solution: a quarter more nodes, but
/// at least 16 more, and an even number.
Resolutions refine(Resolutions resolutions);

/// Returns resolutions with half as many nodes, rounded up by rounded_nodes().
Resolutions coarsen(Resolutions resolutions);

/// Refines the components with automatic nodes by refine().
Resolutions refine_automatic(const Scene& scene, Resolutions before);

/// Refines the components of some pairs, if their nodes are automatic: half as many nodes again, up
/// to most_nodes_of_a_component.
Resolutions refine_pairs(const Scene& scene, Resolutions before,
                         const std::vector<ComponentPair>& pairs);

/// Extrapolates the number of nodes that a component requires from the decay of its density's tail.
///
/// @param  decay   rate of decay per mode number, >= 0: the error falls as \f$ e^{-decay\,n} \f$
/// @param  excess  error over the required error, > 1
/// @return         number of nodes, at most 1.5 n_nodes
double extrapolated_nodes(int n_nodes, double decay, double excess);

/// Refines the components whose tails cause the error of a solution, if their nodes are automatic.
///
/// The share of a component in the error is the estimate, times the tail on this component over the
/// largest tail. Components whose share exceeds a tenth of the tolerance are refined. If all tails
/// are below a tenth of the tolerance, more nodes would not help, and no component is refined.
/// @param  error  error estimate of the solution, above the tolerance of the scene
Resolutions refine_by_tails(const Scene& scene, Resolutions before,
                            const std::vector<TailEstimate>& tails, double error);

}  // namespace stokesbook
