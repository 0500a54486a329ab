#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "closure/closure.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/system/built_tree.hpp"
#include "suspension/system/fast_sum.hpp"
#include "suspension/system/plan.hpp"

namespace stokesbook {

/// Places the Cauchy scheme of each component, as derivatives of the velocity require it.
std::vector<PlacedCurve> placed_cauchy_schemes(const Configuration& configuration,
                                               const Discretisation& discretisation);

/// Places the near-singular scheme of each component: the interpolation scheme if the scene selects
/// it, otherwise the Cauchy scheme.
std::vector<PlacedCurve> placed_schemes(const Configuration& configuration,
                                        const Discretisation& discretisation);

/// The matrix-free operator (12.1) of one configuration: maps a density to velocities at the nodes.
///
/// The layer \f$ (-\frac12 + D)(I-P)\eta \f$ is a direct or fast sum with diagonal and near
/// correction. The closure and the null-space fix add their terms.
class SuspensionOperator {
 public:
  /// Plans sum, near correction and closure of one configuration.
  ///
  /// @param  problem       n nodes in all
  /// @param  placed        curves of the components for near corrections; empty: none
  /// @param  near_storage  what near corrections store
  /// @throws std::invalid_argument when Closure rejects the problem
  SuspensionOperator(const StokesProblem& problem, const std::vector<PlacedCurve>& placed,
                     const Plan& plan, NearStorage near_storage = NearStorage::automatic);

  /// Applies the operator to a density at all n nodes.
  /// @par Cost  n^2 kernel evaluations, or O(n) by FastSum; and that of NearCorrection
  ComplexVector operator()(const ComplexVector& density) const;

  /// Assembles the right-hand side of the closure's system: velocities at all n nodes.
  /// @par Cost  a Stokeslet and a rotlet per node and loaded component, or O(n) by FastSum
  ComplexVector right_hand_side() const;

  /// Returns the position of each component's first node, and as the last entry n.
  const std::vector<Eigen::Index>& offsets() const { return offsets_; }

  /// Returns the closure of the problem, which computes motions and loads from the density.
  const Closure& closure() const { return closure_; }

 private:
  // Evaluates the double layer by the trapezoid rule, and the singularities of loads.
  ComplexVector plain_velocity(const ComplexVector& density, const std::vector<Load>& loads) const;

  // Returns the nodes of a component.
  const Curve& curve(std::size_t k) const { return closure_.problem().components[k].curve; }

  std::vector<Eigen::Index> offsets_;
  std::optional<std::size_t> enclosing_wall_;
  Closure closure_;
  std::variant<StressletSum, FastSum> sum_;
  std::optional<NearCorrection> near_;
};

/// The linear system of one instant at one resolution.
struct LinearSystem {
  SuspensionOperator system;    ///< density in, velocity at the nodes out
  LinearMap precondition = {};  ///< approximate inverse, interleaved; empty: none
  PreconditionerKind kind = PreconditionerKind::none;  ///< of the preconditioner
  SharedTree tree = {};                                ///< of the preconditioner, if it has one

  /// Returns the components with their nodes and data.
  const StokesProblem& problem() const { return system.closure().problem(); }

  /// Returns whether the preconditioner solves the system, up to errors of its near corrections.
  bool is_factorised() const { return kind == PreconditionerKind::direct; }
};

/// Solves a system for the density by GMRES.
///
/// @param  rhs    velocities at all n nodes, length / time
/// @param  guess  density with which GMRES begins; empty: zero
/// @return        solution, interleaved, and history
/// @throws SolverError when gmres() breaks down, or meets numbers that are not finite
GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs, GmresOptions options,
                  const ComplexVector& guess = {});

/// Builds the linear system of a problem without a preconditioner, for a few products. Its near
/// corrections store no rows, which take much memory and pay only in many products.
LinearSystem unpreconditioned_system(const Plan& plan, const StokesProblem& problem,
                                     const Configuration& configuration,
                                     const Discretisation& discretisation);

/// Builds the linear system of a problem with the preconditioner that chosen_preconditioner()
/// selects. Error messages name the components of the scene.
///
/// @param  earlier  a tree that is used again if tree_lasts()
/// @throws SolverError as make_preconditioner() does
LinearSystem preconditioned_system(const Scene& scene, const Plan& plan,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation, double separation,
                                   const SharedTree& earlier = {});

}  // namespace stokesbook
