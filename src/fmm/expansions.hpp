#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "double_layer/flow_derivatives.hpp"
#include "fmm/quadtree.hpp"

namespace stokesbook {

/// @addtogroup fmm
/// @{

/// Coefficients of a pair of Goursat functions about the centre c of a box, for k = 0 ... p a
/// column each: real and imaginary part of \f$ \phi \f$'s and of \f$ \psi_c \f$'s coefficient,
/// where \f$ u = \phi - (z-c)\overline{\phi'} - \overline{\psi_c} \f$,
/// \f$ \psi_c = \psi + \bar c\phi' \f$.
///
/// Outgoing, with \f$ \zeta = z-c \f$ and the box's radius R:
/// \f$ \phi = A_0\log\zeta + \sum_{k\ge1} A_k(R/\zeta)^k \f$, and \f$ \psi_c \f$ likewise with
/// \f$ B_k \f$ but for a constant \f$ -B_0 \f$. Incoming:
/// \f$ \phi = \sum_{l\ge0}\lambda_l(\zeta/R)^l \f$, and \f$ \psi_c \f$ likewise with \f$ \mu_l \f$.
using Expansion = Eigen::Array<double, 4, Eigen::Dynamic>;

/// A column of an Expansion.
using Coefficients = Eigen::Array4d;

/// Nodes of a double layer with their strengths, in the order of a tree.
struct StressletSources {
  Eigen::VectorXd x, y;    ///< position, length
  Eigen::VectorXd ax, ay;  ///< \f$ a = n\eta w/4\pi \f$, length^2 / time
  Eigen::VectorXd b;       ///< \f$ b = 2(n\cdot\eta)w/4\pi \f$, length^2 / time
};

/// Points with forces and torques, in the order of a tree.
struct SingularitySources {
  ComplexVector position;  ///< length
  ComplexVector force;     ///< \f$ F/4\pi\mu \f$, length / time
  Eigen::VectorXd torque;  ///< \f$ L/4\pi\mu \f$, length^2 / time
};

/// The translations of expansions of one order.
///
/// Every translation is a matrix of binomial coefficients, the same for all, between two diagonal
/// scalings by powers of the distance.
class Translations {
 public:
  /// Tabulates the binomial coefficients.
  /// @param  order  p, highest power, 1 to 60
  explicit Translations(int order);

  /// Returns the order.
  /// @return p
  int order() const { return order_; }

  /// Adds an outgoing expansion, moved to another centre.
  ///
  /// @param  from       box of the expansion
  /// @param  expansion  4 x (p + 1)
  /// @param  to         box that contains it
  /// @param  sum        4 x (p + 1), of that box, to which is added
  /// @par Cost          2 p^2 real multiplications
  void outgoing(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                Eigen::Ref<Expansion> sum) const;

  /// Adds an incoming expansion, moved to another centre.
  ///
  /// @param  from       box of the expansion
  /// @param  expansion  4 x (p + 1)
  /// @param  to         box that it contains
  /// @param  sum        4 x (p + 1), of that box, to which is added
  /// @par Cost          2 p^2 real multiplications
  void incoming(const Box& from, Eigen::Ref<const Expansion> expansion, const Box& to,
                Eigen::Ref<Expansion> sum) const;

  /// Adds the incoming expansion of many boxes' outgoing ones.
  ///
  /// @param  sources    all boxes of the sources' tree
  /// @param  outgoing   4 x (p + 1) a box
  /// @param  list       indices of well separated boxes
  /// @param  target     box of the targets
  /// @param  sum        4 x (p + 1), to which is added
  /// @par Cost          4 p^2 real multiplications a source box, eight boxes at a time
  void convert(const std::vector<Box>& sources, const Expansion& outgoing,
               std::span<const Eigen::Index> list, const Box& target,
               Eigen::Ref<Expansion> sum) const;

 private:
  double binomial(int n, int k) const;

  int order_;
  std::vector<double> pascal_;   // binomial(n, k), row n, column k, n <= p
  std::vector<double> convert_;  // binomial(k + l - 1, l), row l, column k - 1
};

/// Adds the outgoing expansion of double-layer nodes.
///
/// @param  box      their box
/// @param  sources  all, in the tree's order
/// @param  sum      4 x (p + 1), to which is added
void add_outgoing(const Box& box, const StressletSources& sources, Eigen::Ref<Expansion> sum);

/// Adds the outgoing expansion of forces and torques.
///
/// @param  box      their box
/// @param  sources  all, in the tree's order
/// @param  sum      4 x (p + 1), to which is added
void add_outgoing(const Box& box, const SingularitySources& sources, Eigen::Ref<Expansion> sum);

/// Evaluates the velocity of an incoming expansion.
///
/// @param  box        of the expansion
/// @param  expansion  4 x (p + 1)
/// @param  points     of the tree, length
/// @param  sum        velocities at all points, length / time, to which those of the box are added
void add_velocity(const Box& box, Eigen::Ref<const Expansion> expansion,
                  const ComplexVector& points, Eigen::Ref<ComplexVector> sum);

/// Evaluates pressure, vorticity and strain of an incoming expansion.
///
/// @param  box        of the expansion
/// @param  expansion  4 x (p + 1)
/// @param  z          point of the box, length
/// @return            derivatives, 1 / time
FlowDerivatives derivatives(const Box& box, Eigen::Ref<const Expansion> expansion, Complex z);

/// @}

}  // namespace stokesbook
