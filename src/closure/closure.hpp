#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"

namespace stokesbook {

/// @addtogroup closure
/// @{

/// Force and torque of a component on the fluid.
struct Load {
  Complex force;        ///< force / length
  double torque = 0.0;  ///< about the component's centre, counter-clockwise, force
};

/// Everything that a density says about one problem.
struct Completion {
  std::vector<RigidMotion> motions;  ///< of free bodies; zero for other components
  std::vector<Load> loads;           ///< of every component, the enclosing wall included
  Complex uniform_velocity;  ///< of the fluid at infinity beside the background, length / time
};

/// Sets the load of an enclosing wall: stress is divergence-free, so the wall holds what all others
/// push.
///
/// @param  problem     its components
/// @param  completion  with the loads of all inner components
/// @return             the same with the wall's load; unchanged where no wall encloses the fluid
Completion with_balance(const StokesProblem& problem, Completion completion);

/// Chooses the gauge length of each component's Stokeslet: the problem's, where an unbounded fluid
/// has one.
///
/// Else \f$ \ell = \sqrt e\, a \f$, which makes the own block of a prescribed circle equal
/// {-1, -1/2}; it cancels in a bounded fluid, and where a uniform velocity is free. All free bodies
/// share the first one's: where their forces balance, one gauge cancels and several would leave a
/// uniform flow.
/// @param  problem  its components
/// @return          one length a component
std::vector<double> stokeslet_gauges(const StokesProblem& problem);

/// The reduced closure: ties rigid motions, forces and torques to the density without new unknowns.
///
/// With the projection P onto rigid motions, \f$ U_k, \omega_k = P\eta \f$ on free bodies;
/// \f$ F_w = -4\pi\mu\, U[P\eta],\ L_w = -4\pi\mu\, a_w^2\, \omega[P\eta] \f$ on prescribed
/// components, with Stokeslets of gauge \f$ \ell_w = \sqrt{e}\, a_w \f$. The system for x on
/// component k is
/// \f[ (-\tfrac12 + D)(I-P)\eta - [k\ \mathrm{free}]\,P\eta + \sum_w (S_w F_w + R_w L_w) + N_0\eta
///     + u_c = g_k - u_\infty - \sum_p (S_p F_p + R_p L_p), \f]
/// pure second kind: on a circle every eigenvalue is -1/2 or -1. \f$ D P \eta = \frac12 P\eta \f$
/// on the own curve and 0 in the fluid, exactly; leaving it out removes its quadrature error.
///
/// Unbounded fluid with prescribed components and no gauge length: the total force is zero and a
/// uniform velocity u_c is free. Both hold by construction, with the mean \f$ \bar U \f$ of U[P
/// eta] over the prescribed components:
/// \f$ F_w = -4\pi\mu (U_w - \bar U) - \frac{1}{n_w}\sum_p F_p,\ u_c = -\bar U \f$. Reported is the
/// velocity at infinity, which the Stokeslets' different gauges share in:
/// \f$ u_c + \frac{1}{4\pi\mu}\sum_k F_k\log\ell_k \f$ over all components.
/// @par Accuracy  that of the rule: geometric in the nodes, @ref claim_03_2; uniform streams
/// exactly, @ref claim_03_34
/// @par Cost      n_w n Stokeslets and rotlets for n_w loaded components, else O(n)
class Closure {
 public:
  /// Prepares the rigid motions of all inner components.
  ///
  /// @param  problem  components with their data, n nodes in all
  /// @throws std::invalid_argument when an unbounded problem has a net force, and neither a gauge
  ///                  length nor a prescribed component
  explicit Closure(const StokesProblem& problem);

  /// Removes the rigid part on all inner components: \f$ (I - P)\eta \f$.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          the rest at all n nodes, length / time
  ComplexVector without_rigid_part(const ComplexVector& density) const;

  /// Evaluates what the closure adds at the nodes: \f$ -P\eta \f$ on free bodies, singularities and
  /// uniform velocity of the prescribed components everywhere. Linear in the density.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          velocities at all n nodes, length / time
  ComplexVector velocity(const ComplexVector& density) const;

  /// Evaluates velocity() without its singularities, for operators that sum these themselves.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          velocities at all n nodes, length / time
  /// @par Cost        O(n)
  ComplexVector smooth_velocity(const ComplexVector& density) const;

  /// Extracts the loads of the singularities in velocity().
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          of every component; zero but for prescribed ones
  /// @par Cost        O(n)
  std::vector<Load> density_loads(const ComplexVector& density) const;

  /// Assembles the right-hand side of the system.
  ///
  /// @return velocities at all n nodes, length / time
  ComplexVector right_hand_side() const;

  /// Assembles right_hand_side() without its singularities.
  ///
  /// @return \f$ g_k - u_\infty \f$ at all n nodes, length / time
  ComplexVector boundary_data() const;

  /// Returns the loads of the singularities in right_hand_side(): those given, and their shares on
  /// prescribed components.
  ///
  /// @return of every component
  std::vector<Load> given_loads() const;

  /// Evaluates the Stokeslets and rotlets of some loads.
  ///
  /// @param  loads    of every component
  /// @param  targets  m points, length
  /// @return          m velocities, length / time
  /// @par Cost        a Stokeslet and a rotlet a target and loaded component
  ComplexVector singular_velocity(const std::vector<Load>& loads,
                                  const ComplexVector& targets) const;

  /// Extracts motions and loads from a solution.
  ///
  /// @param  density  at all n nodes, length / time
  /// @return          motions and loads of every component
  Completion complete(const ComplexVector& density) const;

  /// Returns the uniform velocity that a solution has beside its singularities: what is reported of
  /// infinity, without what gauges leave there.
  ///
  /// @param  completion  from complete()
  /// @return             length / time
  Complex uniform_velocity(const Completion& completion) const;

  /// Evaluates the singularities and the uniform velocity of a solution away from the boundary.
  ///
  /// @param  completion  from complete()
  /// @param  targets     points in the fluid, length
  /// @return             velocities without background and double layer, length / time
  /// @par Cost           a Stokeslet and a rotlet a target and loaded component
  ComplexVector singular_velocity(const Completion& completion, const ComplexVector& targets) const;

 private:
  std::vector<Load> prescribed_loads(const std::vector<RigidMotion>& rigid, bool with_data) const;
  std::vector<RigidMotion> rigid_parts(const ComplexVector& density) const;
  Complex mean_prescribed(const std::vector<RigidMotion>& rigid) const;
  // What Stokeslets of different gauges leave at infinity when the forces balance; part of u_c.
  Complex gauge_velocity(const std::vector<Load>& loads) const;

  StokesProblem problem_;
  std::vector<Eigen::Index> offsets_;
  std::vector<std::optional<RigidModes>> modes_;  // none for an enclosing wall
  std::vector<double> gauges_;                    // Stokeslet gauge of each component
  ComplexVector nodes_;
  Eigen::Index prescribed_count_ = 0;
  bool free_uniform_velocity_ = false;
};

/// @}

}  // namespace stokesbook
