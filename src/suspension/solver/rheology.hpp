#pragma once

#include <optional>
#include <vector>

#include "record/run_data.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Finds the direction of the long axis of a curve, which is the principal axis of the enclosed
/// area: \f$ \frac12\arg\int z^2\,dA \f$ about the area's centroid.
///
/// @return        angle, radians; none if \f$ |\int z^2\,dA| \le 10^{-6}\int|z|^2\,dA \f$, as for
///                circles, and for stars of three arms or more
/// @par Accuracy  geometric in N for analytic curves, @ref claim_01_9
std::optional<double> long_axis(const Curve& curve);

/// Measures the rheology of a scene's solutions.
///
/// - Dissipation, in an enclosed fluid: the whole dissipation, which is the power of all loads and
///   moving walls (07.11). In an unbounded fluid with a linear background and balanced forces: the
///   dissipation that bodies and walls add to the dissipation of the undisturbed flow in the same
///   plane, the sum over k of \f$ E:S_k \f$, \f$ F_k\cdot(U_k - u_\infty(c_k)) \f$ and
///   \f$ L_k(\omega_k - \Omega_\infty) \f$; not defined if a wall deforms. In a periodic cell, the
///   same sum, also for forces that do not balance, is the dissipation that the bodies add to the
///   dissipation \f$ 2\mu VE:E \f$ of the undisturbed flow in the cell. The power of slips is added
///   in all cases.
/// - Torque ratio, in a Couette cell: torque of the inner wall over its torque without bodies.
/// - Order parameter: mean of \f$ \cos 2(\theta - \theta_f) \f$ over the bodies with a long axis at
///   \f$ \theta \f$. The flow's direction \f$ \theta_f \f$ is 0 in shear, extensional and linear
///   flow and in their sums, and the azimuthal direction about the outer wall's position in a
///   Couette cell; in other scenes the order parameter is not defined.
/// - Stresslet, in an unbounded fluid: the sum over bodies and walls, by body_stresslet().
/// - Uniform velocity, in an unbounded fluid: the velocity at infinity, if it is an unknown; in a
///   periodic cell the mean velocity, if it is.
/// - In a periodic cell, all of cell_rheology().
///
/// In a linear flow the mean stress of the suspension in an area A is
/// \f$ -pI + 2\mu E + \sum_kS_k/A \f$ (07.16).
/// @sa source: Batchelor, J. Fluid Mech. 41 (1970), 545
class Rheometer {
 public:
  /// Prepares the measurements for the scene of a solver, which must outlive the rheometer; solves
  /// a Couette cell without its bodies.
  ///
  /// @throws SolverError when a Couette cell cannot be solved without its bodies
  explicit Rheometer(const SuspensionSolver& solver);

  /// Measures all quantities that the scene defines.
  ///
  /// @param  contacts  contact forces that are part of the loads of the solution
  /// @par Cost  O(n) for n nodes in all, and the derivatives at nodes of walls that deform and of
  /// bodies with slip; in a periodic cell, those at all nodes
  Rheology operator()(const Solution& solution,
                      const std::vector<ContactForce>& contacts = {}) const;

 private:
  double order_parameter(const Configuration& configuration) const;
  double excess_dissipation(const Solution& solution, const std::vector<Complex>& stresslets) const;

  const SuspensionSolver& solver_;
  std::vector<std::optional<double>> long_axes_;  // long axes of the bodies, in their own frames
  std::optional<double> empty_torque_;  // torque of a Couette cell's inner wall without bodies
};

}  // namespace stokesbook
