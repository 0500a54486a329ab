#pragma once

#include <Eigen/Core>

#include "closure/closure.hpp"

namespace stokesbook {

/// The forms of the linear system of one problem. Conditioning and quadrature errors differ; the
/// exact motions and loads are the same.
enum class ClosureForm {
  /// Border (03.6) of Power: \f$ \int\eta\,ds = F,\ \int\eta\cdot(x-c)^\perp ds = L \f$. These
  /// equations are dimensionally inconsistent.
  power_bordered,
  /// Border (03.8): \f$ \langle\eta\rangle = 0 \f$ for free bodies,
  /// \f$ \langle\eta\rangle + F/(4\pi\mu) = 0 \f$ for prescribed components, and the like for the
  /// turn. The unknowns \f$ U, a\omega, F/(4\pi\mu), L/(4\pi\mu a) \f$ have one unit.
  scaled_bordered,
  /// No border (03.11): motions and loads are functionals of the density, see Closure.
  reduced
};

/// A dense linear system for the densities at the nodes and, in the bordered forms, for motions
/// and loads.
struct DenseSystem {
  /// Rows and columns: interleaved node vectors, then 3 per inner component in the bordered forms.
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;  ///< in the order of the rows; velocities, length / time, in those of nodes
};

/// Assembles a problem as a dense matrix by plain trapezoid sums, for teaching, tests and studies
/// of conditioning.
///
/// In unbounded fluid, the bordered forms require a gauge length if a component is prescribed.
/// Enclosing walls are assembled without \f$ N_0 \f$, so that their matrix is singular: see
/// null_space.
/// @throws std::invalid_argument when the form is reduced and Closure rejects the problem
/// @par Accuracy  geometric in the number of nodes, @ref claim_03_2, and in the distances of
/// components over node spacings, @ref claim_03_31; the same in any unit of length in the scaled
/// and reduced forms, @ref claim_03_28
/// @par Cost      \f$ 4 n^2 \f$ entries; the reduced form multiplies matrices, O(n^3)
/// @par Not for   components close to each other, for lack of a near correction: use suspension
DenseSystem assemble(const StokesProblem& problem, ClosureForm form);

/// Extracts motions and loads of every component from the solution of the system that assemble()
/// returned for the same problem and form.
///
/// @throws std::invalid_argument when Closure rejects the problem
Completion complete_dense(const StokesProblem& problem, ClosureForm form,
                          const Eigen::VectorXd& solution);

}  // namespace stokesbook
