// Assembles the operator (12.1) and the preconditioner of an instant, and solves the system by
// GMRES (chapters 05 and 12).
#include "suspension/system/linear_system.hpp"

#include <stdexcept>

#include "double_layer/double_layer.hpp"
#include "krylov/direct.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/system/clusters.hpp"
#include "suspension/system/layer_blocks.hpp"
#include "suspension/system/near_curves.hpp"
#include "suspension/system/preconditioner_choice.hpp"

namespace stokesbook {

namespace {

// Returns the inverse of a component's own block, or throws an error that explains why the block is
// singular.
std::shared_ptr<const Eigen::MatrixXd> inverse_block(const Scene& scene, std::size_t component,
                                                     const DiscretisedShape& discretised) {
  try {
    return discretised.inverse_block.get();
  } catch (const std::domain_error& error) {
    throw SolverError(
        component_of(scene, component).name() + ": " + error.what() +
        "; a gauge_length close to the size of a held component is a degenerate scale");
  }
}

// Returns the preconditioner by clusters, or throws an error that explains why it is singular.
ClusterPreconditioner clusters_of(const StokesProblem& problem, const Configuration& configuration,
                                  const Discretisation& discretisation,
                                  const std::vector<PlacedCurve>& near) {
  try {
    return cluster_preconditioner(problem, configuration, discretisation, near);
  } catch (const std::domain_error& error) {
    throw SolverError("preconditioner by clusters: " + std::string(error.what()) +
                      "; set solver.preconditioner = \"block_diagonal\"");
  }
}

// Returns the curves near which the operator corrects its sums; empty if none is planned.
std::vector<PlacedCurve> near_curves(const Plan& plan, const Configuration& configuration,
                                     const Discretisation& discretisation) {
  return plan.near_correction ? placed_schemes(configuration, discretisation)
                              : std::vector<PlacedCurve>{};
}

}  // namespace

GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs,
                  const GmresOptions& options, const ComplexVector& guess) {
  const LinearMap apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const ComplexVector velocity = discrete.system(deinterleaved(v));
    return interleaved(velocity);
  };
  try {
    return gmres(apply, discrete.precondition, interleaved(rhs), options, interleaved(guess));
  } catch (const std::domain_error& error) {
    throw SolverError(std::string(error.what()) +
                      "; components may be so close to each other that rounding errors dominate");
  }
}

LinearSystem unpreconditioned_system(const Plan& plan, const StokesProblem& problem,
                                     const Configuration& configuration,
                                     const Discretisation& discretisation) {
  return {problem,
          SuspensionOperator(problem, near_curves(plan, configuration, discretisation), plan)};
}

LinearSystem preconditioned_system(const Scene& scene, const Plan& plan,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation, double separation) {
  const std::vector<PlacedCurve> near = near_curves(plan, configuration, discretisation);
  LinearSystem discrete{problem, SuspensionOperator(problem, near, plan)};
  switch (chosen_preconditioner(plan, gaps, discretisation, separation)) {
    case PreconditionerKind::direct:
      discrete.precondition =
          DirectPreconditioner(problem, layer_blocks(problem, near, plan.near_tolerance));
      discrete.is_factorised = true;
      return discrete;
    case PreconditionerKind::clusters:
      discrete.precondition = clusters_of(problem, configuration, discretisation, near);
      return discrete;
    case PreconditionerKind::none:
      return discrete;
    default:
      break;
  }
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    members.push_back({inverse_block(scene, k, *discretisation[k]), configuration[k].orientation});
  }
  discrete.precondition = BlockDiagonalPreconditioner(std::move(members));
  return discrete;
}

}  // namespace stokesbook
