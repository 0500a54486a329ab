#pragma once

#include <Eigen/Core>

#include "closure/closure.hpp"

namespace stokesbook {

/// @addtogroup closure
/// @{

/// Forms of the same mixed problem; they differ in conditioning only.
enum class ClosureForm {
  /// Border of the draft: \f$ \int\eta\,ds = F,\ \int\eta\cdot(x-c)^\perp ds = L \f$. Dimensionally
  /// inconsistent.
  draft_bordered,
  /// Border \f$ \langle\eta\rangle + F/(4\pi\mu) = 0 \f$ (0 on bodies), unknowns of one unit:
  /// \f$ U, a\omega, F/(4\pi\mu), L/(4\pi\mu a) \f$.
  scaled_bordered,
  /// No border: motions and loads are functionals of the density, see Closure.
  reduced
};

/// A dense linear system with what its solution means.
struct DenseSystem {
  Eigen::MatrixXd
      matrix;  ///< rows and columns: interleaved node vectors, then 3 a component in borders
  Eigen::VectorXd rhs;  ///< in the order of the rows
};

/// Assembles a problem as a dense matrix by plain trapezoid sums: for teaching, tests and
/// conditioning.
///
/// Unbounded problems need either no prescribed component or a gauge length. Enclosing walls are
/// assembled without \f$ N_0 \f$, hence singular: see null_space.
/// @param  problem  components with their data, n nodes in all
/// @param  form     how the density is tied to motions and loads
/// @return          square matrix of 2n rows, and 3 more an inner component in the bordered forms,
///                  with its right-hand side; velocities, length / time, in the rows of nodes
/// @throws std::invalid_argument when the form is reduced and Closure refuses the problem
/// @par Accuracy    geometric in the nodes, @ref claim_03_2, and in the distances of components
/// over node spacings, @ref claim_03_31; the same in any unit of length in the scaled and reduced
/// forms, @ref claim_03_28
/// @par Cost        \f$ 4 n^2 \f$ entries; the reduced form multiplies matrices, O(n^3)
/// @par Not for     close components (no near correction); use suspension
DenseSystem assemble(const StokesProblem& problem, ClosureForm form);

/// Extracts motions and loads from the solution of assemble().
///
/// @param  problem   as given to assemble()
/// @param  form      as given to assemble()
/// @param  solution  of the system, as long as its right-hand side
/// @return           motions and loads of every component
/// @throws std::invalid_argument when Closure refuses the problem
Completion complete_dense(const StokesProblem& problem, ClosureForm form,
                          const Eigen::VectorXd& solution);

/// @}

}  // namespace stokesbook
