#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "double_layer/stresslet_block.hpp"
#include "fmm/expansions.hpp"
#include "fmm/interactions.hpp"
#include "fmm/quadtree.hpp"
#include "fmm/translations.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

/// Parameters of an Fmm.
struct FmmSettings {
  int order = 0;               ///< p, highest power of the expansions, 1 to 60
  Eigen::Index leaf_size = 0;  ///< largest number of points of a leaf, >= 1

  /// Chooses order and leaf size for a tolerance \f$ \varepsilon \f$:
  /// \f$ p = \lceil 3.03\log_{10}(1/\varepsilon) - 0.6 \rceil \f$, leaves of at most 2 p + 32
  /// points.
  ///
  /// The relative error of one translation is at most about \f$ p\,2^{-p} \f$ (08.9). In a sum of
  /// many translations errors average out, and the total error falls like \f$ 10^{-p/3.03} \f$.
  /// If most points are at one place then the errors add up, and p must satisfy
  /// \f$ p\,2^{-p} \le \varepsilon \f$.
  /// @param  tolerance  of velocities in the 2-norm over all targets, relative, > 0; below 1e-14,
  ///                    the size of rounding errors, the order stays that for 1e-14
  /// @throws std::invalid_argument when the tolerance is not > 0
  /// @par Accuracy  @ref claim_08_14 to @ref claim_08_16; one slender body, which meets the
  /// tolerance most narrowly of all sets measured, @ref claim_08_23
  static FmmSettings for_tolerance(double tolerance);
};

/// Returns the number of nodes above which an application of an Fmm takes less time than
/// StressletSum: \f$ n = 300 + 18p \f$.
///
/// This straight line was fitted to times measured on ellipses of 16, 32 and 128 nodes, with one
/// thread and AVX-512. With n nodes an Fmm takes about half of the direct sum's operations,
/// @ref claim_08_30.
Eigen::Index break_even(const FmmSettings& settings);

/// Densities, forces and torques of the sources of an Fmm, one column per field. The members are
/// views, which are valid during the call of a function.
struct FmmStrengths {
  /// Views densities of the nodes, n x k; the forces and torques of the points are zero.
  template <class Density>
  FmmStrengths(const Eigen::MatrixBase<Density>& node_density)
      : density(node_density), force(Eigen::MatrixXcd()), torque(Eigen::MatrixXd()) {}

  /// Views densities of the nodes, and forces and torques of the points on the fluid, m x k.
  template <class Density, class Force, class Torque>
  FmmStrengths(const Eigen::MatrixBase<Density>& node_density,
               const Eigen::MatrixBase<Force>& point_force,
               const Eigen::MatrixBase<Torque>& point_torque)
      : density(node_density), force(point_force), torque(point_torque) {}

  FmmStrengths(const FmmStrengths&) = delete;
  FmmStrengths& operator=(const FmmStrengths&) = delete;

  Eigen::Ref<const Eigen::MatrixXcd> density;  ///< density of the nodes, length / time
  /// Forces of the points over the viscosity, length / time; no rows if all are zero.
  Eigen::Ref<const Eigen::MatrixXcd> force;
  /// Torques of the points over the viscosity, length^2 / time; no rows if all are zero.
  Eigen::Ref<const Eigen::MatrixXd> torque;
};

/// Copies of all sources, each moved by a vector, whose flow an Fmm adds to that of the sources.
struct FmmImages {
  std::vector<Complex> near;  ///< vectors of the copies that the tree finds, length
  /// Adds the local expansion of all other copies, from the multipole expansion of the sources,
  /// both about the centre of the disk of an FmmImagePlan; empty if there are no such copies.
  std::function<void(Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>)> far;
};

/// Chooses the images of the sources, given the radius of a disk that contains all sources and
/// targets, length, and the order of the expansions.
using FmmImagePlan = std::function<FmmImages(double radius, int order)>;

class Fmm;

/// Memory for applications of an Fmm, which also holds their results. Several threads may apply one
/// plan, each with its own workspace.
class FmmWorkspace {
  friend class Fmm;
  FmmWorkspace(const Fmm& plan, Eigen::Index fields);

  Eigen::MatrixXd ex_, ey_;              // densities in the sources' order, one column per field
  std::vector<PointForce> points_;       // in the sources' order, field after field
  bool without_points_ = false;          // the last strengths had no forces and torques
  Expansions multipole_, local_, cell_;  // cell: multipole and local expansion of the far images
  Eigen::MatrixXcd velocity_;
  std::vector<FlowDerivatives> derivatives_;
};

/// Sums the flow of double-layer nodes and of point forces by the fast multipole method. A sum is
/// planned once and applied many times.
///
/// The sum over nodes is that of StressletSum, with the same lower bound on distances. Each point
/// adds stokeslet() with gauge 1 and rotlet(). Another gauge \f$ \ell \f$ adds the
/// uniform velocity \f$ F\log\ell/4\pi\mu \f$. Images of the sources, such as those of a periodic
/// cell, use the expansions of the sources themselves.
///
/// @par Accuracy  the tolerance of FmmSettings::for_tolerance(), relative in the 2-norm:
///                @ref claim_08_14 to @ref claim_08_16, difficult sets of points @ref claim_08_21
///                to @ref claim_08_26
/// @par Cost      O(n) per application, @ref claim_08_28; the result has the same bits for any
///                number of threads
/// @sa source: Greengard and Rokhlin, J. Comput. Phys. 73 (1987), 325; Greengard, Kropinski, Mayo,
/// J. Comput. Phys. 125 (1996), 403
class Fmm {
 public:
  /// Plans the sum at the nodes themselves.
  ///
  /// @param  curves    n nodes in all, in this order
  /// @param  points    m positions of forces and torques, length
  /// @param  images    chooses the images of the sources; empty: none
  /// @throws std::invalid_argument when a node or point is not finite, a node is at a point, or a
  ///                   setting is out of range
  /// @par Cost         O(n log n)
  Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const FmmSettings& settings,
      const FmmImagePlan& images = {});

  /// Plans the sum at other targets. Parameters, exceptions and cost are otherwise the same.
  Fmm(const std::vector<Curve>& curves, const ComplexVector& points, const ComplexVector& targets,
      const FmmSettings& settings, const FmmImagePlan& images = {});

  /// Allocates the memory of applications of this plan only, for a number k >= 1 of fields that are
  /// summed at once.
  FmmWorkspace workspace(Eigen::Index fields = 1) const;

  /// Evaluates velocities, without allocation.
  ///
  /// @return  one row per target, one column per field, length / time; overwritten by the next
  ///          application with this workspace
  /// @throws std::invalid_argument when the sizes of strengths, plan and workspace do not agree
  const Eigen::MatrixXcd& velocity(const FmmStrengths& strengths, FmmWorkspace& workspace) const;

  /// Evaluates velocities in a new workspace.
  Eigen::MatrixXcd velocity(const FmmStrengths& strengths) const;

  /// Evaluates pressure, vorticity and strain. Only the first call with a workspace allocates
  /// memory.
  ///
  /// @return  at the targets, field after field, 1 / time; overwritten by the next application with
  ///          this workspace
  /// @throws std::invalid_argument when the sizes of strengths, plan and workspace do not agree
  /// @par Accuracy  a hundred times the tolerance, relative in the 2-norm; the points of the study
  ///                meet the tolerance itself, @ref claim_08_17 to @ref claim_08_20
  const std::vector<FlowDerivatives>& derivatives(const FmmStrengths& strengths,
                                                  FmmWorkspace& workspace) const;

  /// Evaluates pressure, vorticity and strain in a new workspace.
  std::vector<FlowDerivatives> derivatives(const FmmStrengths& strengths) const;

  /// Returns the tree of the nodes and the points; the points are numbered after the nodes.
  const Quadtree& sources() const { return sources_; }

  /// Returns the tree of the targets, or that of the sources if the nodes are the targets.
  const Quadtree& targets() const { return targets_ ? *targets_ : sources_; }

  /// Returns the lists of sources for every box of targets, without images.
  const Interactions& interactions() const { return interactions_.front(); }

  /// Returns the lists without images, and then those of each near image.
  const std::vector<Interactions>& all_interactions() const { return interactions_; }

  /// Returns the disk that contains the boxes of all sources and of all targets; without images,
  /// the disk is not computed.
  const Box& cell() const { return cell_; }

 private:
  friend class FmmWorkspace;
  Fmm(const FmmSettings& settings, const StressletNodes& nodes, const ComplexVector& points,
      const ComplexVector* targets, const FmmImagePlan& images);

  void check(const FmmStrengths& strengths, const FmmWorkspace& work) const;
  StressletBlock nodes(Range sources, Eigen::Index field, const FmmWorkspace& work) const;
  std::span<const PointForce> points(Range sources, Eigen::Index field,
                                     const FmmWorkspace& work) const;
  void sort_strengths(const FmmStrengths& strengths, FmmWorkspace& work) const;
  void sum_multipoles(FmmWorkspace& work) const;
  void sum_locals(FmmWorkspace& work) const;
  void add_far_images(FmmWorkspace& work) const;
  void expand(const FmmStrengths& strengths, FmmWorkspace& work) const;
  template <int fields>
  void sum_group(Eigen::Index box, Eigen::Index first, Eigen::Index field,
                 FmmWorkspace& work) const;
  FlowDerivatives derivatives_at(Eigen::Index box, Eigen::Index target, Eigen::Index field,
                                 const FmmWorkspace& work) const;

  Translations translations_;
  Eigen::Index node_count_, point_count_, target_count_;
  Quadtree sources_;  // nodes, then points
  std::optional<Quadtree> targets_;
  Box cell_;  // disk that contains the boxes of all sources and of all targets
  FmmImages images_;
  std::vector<Interactions> interactions_;
  // In the sources' order. Each point force is stored as a node of zero weight, and in addition as
  // a PointForce.
  Eigen::VectorXd nx_, ny_;                  // normal times weight over pi
  Eigen::VectorXd least2_;                   // squared half weight
  std::vector<Eigen::Index> points_before_;  // number of points before each source, then of all
};

}  // namespace stokesbook
