#pragma once

#include <array>

#include <Eigen/Core>

#include "double_layer/stresslet_block.hpp"
#include "fmm/quadtree.hpp"

namespace stokesbook {

/// Coefficients of a pair of Goursat functions about the centre c of a box, one column for each
/// power k = 0 ... p: real and imaginary part of the coefficient of \f$ \phi \f$, then those of
/// \f$ \psi_c = \psi + \bar c\phi' \f$. The velocity is
/// \f$ u = \phi - (z-c)\overline{\phi'} - \overline{\psi_c} \f$ (08.5).
///
/// A multipole expansion, with \f$ \zeta = z-c \f$ and the box's radius R, is
/// \f$ \phi = A_0\log\zeta + \sum_{k\ge1} A_k(R/\zeta)^k \f$ and
/// \f$ \psi_c = B_0(\log\zeta - 1) + \sum_{k\ge1} B_k(R/\zeta)^k \f$ (08.6), where only point
/// forces contribute to \f$ A_0 \f$ and \f$ B_0 \f$. A local expansion is
/// \f$ \phi = \sum_{l\ge0}\lambda_l(\zeta/R)^l \f$ and
/// \f$ \psi_c = \sum_{l\ge0}\mu_l(\zeta/R)^l \f$ (08.7).
using Expansion = Eigen::Array<double, 4, Eigen::Dynamic>;

/// A column of an Expansion.
using Coefficients = Eigen::Array4d;

/// Expansions of all boxes of a tree, for one or several fields.
class Expansions {
 public:
  /// Allocates expansions of order p.
  Expansions(Eigen::Index boxes, Eigen::Index fields, int order)
      : fields_(fields), columns_(order + 1), all_(4, boxes * fields * columns_) {}

  /// Returns a view of one expansion, 4 x (p + 1).
  auto operator()(Eigen::Index box, Eigen::Index field) {
    return all_.middleCols((box * fields_ + field) * columns_, columns_);
  }
  /// @copydoc operator()(Eigen::Index, Eigen::Index)
  auto operator()(Eigen::Index box, Eigen::Index field) const {
    return all_.middleCols((box * fields_ + field) * columns_, columns_);
  }

  /// Counts the columns of all expansions together: boxes times fields times p + 1.
  Eigen::Index columns() const { return all_.cols(); }

  /// Sets the expansions of all fields of a box to zero.
  void clear(Eigen::Index box) {
    all_.middleCols(box * fields_ * columns_, fields_ * columns_).setZero();
  }

 private:
  Eigen::Index fields_, columns_;
  Expansion all_;
};

/// P2M: adds the multipole expansion of double-layer nodes (08.6).
///
/// \f$ A_k = \frac{1}{R}\sum a W^{k-1} \f$,
/// \f$ B_k = -\frac{1}{R}\sum (b W^{k-1} - (k-1) a\bar W W^{k-2}) \f$ with \f$ W = (y-c)/R \f$,
/// \f$ a = \frac{w}{4\pi}n\eta \f$, \f$ b = \frac{w}{2\pi}n\cdot\eta \f$.
/// Only the first field of the nodes is used.
void p2m(const Box& box, const StressletBlock& nodes, Eigen::Ref<Expansion> sum);

/// A point force with a torque, both acting on the fluid.
struct PointForce {
  Complex position;  ///< length
  Complex force;     ///< F over the viscosity, length / time
  double torque;     ///< L over the viscosity, length^2 / time
};

/// P2M: adds the multipole expansion of a point force with its torque, that is, of stokeslet() with
/// gauge 1 and of rotlet().
///
/// With \f$ f = F/4\pi\mu \f$ and \f$ W \f$ as for nodes: \f$ A_0 = -\frac f2 \f$,
/// \f$ A_k = \frac{f W^k}{2k} \f$, \f$ B_0 = \frac{\bar f}{2} \f$,
/// \f$ B_k = \frac12\bar W f W^{k-1} - \frac{\bar f W^k}{2k} + \frac{iL}{4\pi\mu R}W^{k-1} \f$.
void p2m(const Box& box, const PointForce& point, Eigen::Ref<Expansion> sum);

/// L2P: adds the velocities of a local expansion at points of its box, by (08.7) and (08.5).
void l2p(const Box& box, Eigen::Ref<const Expansion> expansion, const VectorGroup& targets,
         VectorGroup& sum);

/// L2P: evaluates pressure, vorticity and strain of a local expansion at a point of its box,
/// 1 / time.
FlowDerivatives l2p_derivatives(const Box& box, Eigen::Ref<const Expansion> expansion,
                                Complex target);

}  // namespace stokesbook
