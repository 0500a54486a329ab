#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"

namespace stokesbook {

/// Force and torque of a component on the fluid.
struct Load {
  Complex force;        ///< force / length
  double torque = 0.0;  ///< about the component's centre, counter-clockwise, force
};

/// Motions and loads of one problem, as computed from a density.
struct Completion {
  std::vector<RigidMotion> motions;  ///< motions of free bodies; zero for other components
  std::vector<Load> loads;           ///< loads of every component, also of the enclosing wall
  /// Velocity of the fluid at infinity without the background, length / time: that of Closure, and
  /// the contribution of different gauges, \f$ u_c + \frac{1}{4\pi\mu}\sum_k F_k\log\ell_k \f$.
  Complex uniform_velocity;
};

/// Sets the load of an enclosing wall, if there is one: the stress is free of divergence, so that
/// the load of the wall balances the loads of all other components.
Completion with_balance(const StokesProblem& problem, Completion completion);

/// Chooses the gauge length of each component's Stokeslet.
///
/// In an unbounded fluid with a gauge length, all Stokeslets have the gauge length of the problem.
/// Otherwise the length is \f$ \ell = \sqrt e\, a \f$, for which the own block of a prescribed
/// circle has the eigenvalues -1 and -1/2. This gauge cancels in a bounded fluid, and where a
/// uniform velocity is free. All free bodies share the gauge length of the first one: if their
/// forces balance, one common gauge cancels, whereas several would leave a uniform flow. The
/// Stokeslets of a periodic cell have the mean zero, and no gauge: the length is 1.
std::vector<double> stokeslet_gauges(const StokesProblem& problem);

/// The reduced closure: ties rigid motions, forces and torques to the density without new unknowns.
///
/// The projection P onto rigid motions gives the motions \f$ U_k, \omega_k = P\eta \f$ of free
/// bodies, and the loads
/// \f$ F_w = -4\pi\mu\, U[P\eta],\ L_w = -4\pi\mu\, a_w^2\, \omega[P\eta] \f$ of prescribed
/// components, with Stokeslets of gauge \f$ \ell_w = \sqrt{e}\, a_w \f$. The system for x on
/// component k, with prescribed components w and free bodies p, is
/// \f[ (-\tfrac12 + D)(I-P)\eta - [k\ \mathrm{free}]\,P\eta + \sum_w (S_w F_w + R_w L_w) + N_0\eta
///     + u_c = g_k - u_\infty - \sum_p (S_p F_p + R_p L_p), \f]
/// where [k free] is 1 on free bodies and 0 elsewhere, and g_k is the slip of free bodies. The
/// equation is of the second kind: on a circle every eigenvalue is -1/2 or -1. The term
/// \f$ (-\frac12 + D)P\eta \f$, whose exact value is zero, is left out, and thus its quadrature
/// error (03.11).
///
/// In unbounded fluid with prescribed components and no gauge length, the total force is zero and a
/// uniform velocity u_c is free (03.14). Both hold by construction, with the mean \f$ \bar U \f$ of
/// U[P eta] over the prescribed components:
/// \f$ F_w = -4\pi\mu (U_w - \bar U) - \frac{1}{n_w}\sum_p F_p,\ u_c = -\bar U \f$.
/// In a periodic cell with a given mean gradient P of the pressure, the total force is V P, and u_c
/// is the mean velocity.
///
/// All densities and velocities are those at all n nodes, component by component, length / time.
/// @par Accuracy  that of the rule: geometric in the number of nodes, @ref claim_03_2; a uniform
/// stream is exact, @ref claim_03_34
/// @par Cost      n_w n Stokeslets and rotlets for n_w loaded components, and O(n) otherwise
class Closure {
 public:
  /// Prepares the rigid motions of all inner components.
  ///
  /// @throws std::invalid_argument when an unbounded problem has a net force, and neither a gauge
  ///         length nor a prescribed component; when a problem in a periodic cell has an enclosing
  ///         wall or a gauge length, or a gradient of the pressure without prescribed components
  explicit Closure(const StokesProblem& problem);

  const StokesProblem& problem() const { return problem_; }  ///< returns the problem
  const ComplexVector& nodes() const { return nodes_; }      ///< returns all n nodes

  /// Removes the rigid part on all inner components: \f$ (I - P)\eta \f$.
  ComplexVector without_rigid_part(const ComplexVector& density) const;

  /// Evaluates the velocities that the closure adds at the nodes, which are linear in the density:
  /// \f$ -P\eta \f$ on free bodies, and everywhere the singularities of prescribed components and
  /// the uniform velocity.
  ComplexVector velocity(const ComplexVector& density) const;

  /// Evaluates velocity() without its singularities, for operators that sum the singularities
  /// themselves, with O(n) operations.
  ComplexVector smooth_velocity(const ComplexVector& density) const;

  /// Extracts the loads of the singularities in velocity(): zero except for prescribed components.
  std::vector<Load> density_loads(const ComplexVector& density) const;

  /// Assembles the right-hand side of the system: velocities at all nodes.
  ComplexVector right_hand_side() const;

  /// Assembles right_hand_side() without its singularities: \f$ g_k - u_\infty \f$.
  ComplexVector boundary_data() const;

  /// Returns the loads of the singularities in right_hand_side(): the given loads of free bodies,
  /// and the share of each prescribed component in the force that balances them.
  std::vector<Load> given_loads() const;

  /// Evaluates the Stokeslets and rotlets of the given loads of every component, with a Stokeslet
  /// and a rotlet per target and loaded component.
  ///
  /// @throws std::invalid_argument in a periodic cell, whose images this sum does not have
  ComplexVector singular_velocity(const std::vector<Load>& loads,
                                  const ComplexVector& targets) const;

  /// Extracts motions and loads of every component from a solution.
  Completion complete(const ComplexVector& density) const;

  /// Returns the uniform velocity u_c that a solution contains in addition to its singularities:
  /// Completion::uniform_velocity without the contribution of the gauges, length / time.
  Complex uniform_velocity(const Completion& completion) const;

  /// Evaluates the singularities and the uniform velocity of a solution at points in the fluid, at
  /// the same cost: velocities without background and double layer.
  ComplexVector singular_velocity(const Completion& completion, const ComplexVector& targets) const;

 private:
  std::vector<Load> inner_loads(const std::vector<RigidMotion>& rigid, bool with_data) const;
  std::vector<RigidMotion> rigid_parts(const ComplexVector& density) const;
  Complex mean_prescribed(const std::vector<RigidMotion>& rigid) const;
  // Returns the uniform velocity at infinity of Stokeslets whose forces balance, but whose gauges
  // differ; 0 where no uniform velocity is free.
  Complex gauge_velocity(const std::vector<Load>& loads) const;

  StokesProblem problem_;
  std::vector<Eigen::Index> offsets_;
  std::vector<std::optional<RigidModes>> modes_;  // none for an enclosing wall
  std::vector<double> gauges_;                    // Stokeslet gauge of each component
  ComplexVector nodes_;
  Eigen::Index prescribed_count_;
  bool free_uniform_velocity_;
};

}  // namespace stokesbook
