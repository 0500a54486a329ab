#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "suspension/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What loads on free bodies add to a solution.
struct LoadSolution {
  ComplexVector density;  ///< at all n nodes, length / time
  Completion completion;  ///< motions of free bodies, loads of all components on the fluid
};

/// Answers loads on free bodies of one configuration with the motions that they cause: the mobility
/// B, a column a solve, with all prescribed components at rest and no background flow.
///
/// Loads count in the order of to_state(), force and torque of every component; those on prescribed
/// components go to their supports and move nothing.
class LoadResponse {
 public:
  /// Takes the configuration; nothing is solved yet.
  ///
  /// @param  solver         of the scene, which must outlive the response
  /// @param  configuration  where the components are
  /// @param  references     of a solution there
  LoadResponse(const SuspensionSolver& solver, Configuration configuration, References references);

  /// Solves for the motions under some loads.
  ///
  /// A load that was answered before, in this or an earlier call, is not solved for again; others
  /// begin with the solution for the most similar one.
  /// @param  loads  3K x m, forces / length and torques
  /// @return        3K x m velocities of all components, zero for prescribed ones
  /// @throws NumericsRefused when GMRES does not converge
  /// @throws std::invalid_argument when loads in an unbounded fluid without gauge or prescribed
  ///                component do not balance
  /// @par Cost      a solve for each new load; the first call builds the system
  Eigen::MatrixXd operator()(const Eigen::SparseMatrix<double>& loads);

  /// Adds up the solutions of the latest call.
  ///
  /// @param  multipliers  m numbers, one a column of the loads
  /// @return              their combination
  LoadSolution combined(const Eigen::VectorXd& multipliers) const;

  /// Counts what was done so far.
  /// @return solves, iterations and applications
  const SolveCost& cost() const { return cost_; }

  /// Counts solves.
  /// @return columns answered
  int solves() const { return solves_; }

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct Answer {
    Eigen::SparseVector<double> load;
    ComplexVector density;
    std::vector<RigidMotion> motions;
  };
  /// @endcond
  std::size_t answer(const Eigen::SparseVector<double>& load);
  ComplexVector density(const Closure& closure, const ComplexVector& guess);
  ComplexVector guess(const Eigen::SparseVector<double>& load) const;

  const SuspensionSolver& solver_;
  Configuration configuration_;
  References references_;
  std::optional<DiscreteProblem> discrete_;  // built when it is first needed
  std::vector<Answer> answers_;              // of all loads so far
  std::vector<std::size_t> latest_;          // those of the latest call's columns
  SolveCost cost_;
  int solves_ = 0;
};

/// @}

}  // namespace stokesbook
