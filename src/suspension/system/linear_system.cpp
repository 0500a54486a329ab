// Assembles the linear system of an instant and solves it by GMRES (chapter 05). The operator
// (12.1) is applied without a matrix; each of its lines adds the result of one chapter (chapter
// 12).
#include "suspension/system/linear_system.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "null_space/null_space.hpp"
#include "suspension/bodies/solver_error.hpp"
#include "suspension/system/preconditioner.hpp"
#include "suspension/system/preconditioner_choice.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Bounds |A x| / |x| for the operator: at most 6 was measured on the scenes of the book.
constexpr double operator_norm = 10.0;

std::variant<StressletSum, FastSum> make_sum(const StokesProblem& problem, const Plan& plan) {
  const Index n = node_offsets(problem).back();
  if (problem.cell || plan.is_fast(n)) return FastSum(problem, plan.sum_tolerance);
  return StressletSum(curves_of(problem), StressletSum::automatic_storage(n));
}

// Returns the curves near which the operator corrects its sums; empty if none is planned.
std::vector<PlacedCurve> near_curves(const Plan& plan, const Configuration& configuration,
                                     const Discretisation& discretisation) {
  return plan.near_correction ? placed_schemes(configuration, discretisation)
                              : std::vector<PlacedCurve>{};
}

}  // namespace

std::vector<PlacedCurve> placed_cauchy_schemes(const Configuration& configuration,
                                               const Discretisation& discretisation) {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& shape = *discretisation[k];
    // A scene with a single component plans no near corrections; the flow near that component
    // requires its scheme nevertheless.
    placed.push_back(
        {shape.cauchy ? shape.cauchy : std::make_shared<const CauchyCurve>(shape.curve),
         configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

std::vector<PlacedCurve> placed_schemes(const Configuration& configuration,
                                        const Discretisation& discretisation) {
  std::vector<PlacedCurve> placed = placed_cauchy_schemes(configuration, discretisation);
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (discretisation[k]->interpolation) placed[k].scheme = discretisation[k]->interpolation;
  }
  return placed;
}

SuspensionOperator::SuspensionOperator(const StokesProblem& problem,
                                       const std::vector<PlacedCurve>& placed, const Plan& plan,
                                       NearStorage near_storage)
    : offsets_(node_offsets(problem)), closure_(problem), sum_(make_sum(problem, plan)) {
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    if (problem.components[k].kind == ComponentKind::enclosing_wall) enclosing_wall_ = k;
  }
  if (!placed.empty()) {
    const auto* fast = std::get_if<FastSum>(&sum_);
    near_.emplace(placed, closure_.nodes(), Targets::own_nodes,
                  NearSettings{plan.near_tolerance, near_storage},
                  fast != nullptr ? fast->near_images() : std::vector<Complex>{});
  }
}

// The terms of (12.1), in this order: the sum D and the singularities of the loads, the jump -1/2,
// the smooth velocities of the closure, near corrections (06.17), diagonals (02.9), N_0 (04.6).
// [operator]
ComplexVector SuspensionOperator::operator()(const ComplexVector& density) const {
  const ComplexVector rest = closure_.without_rigid_part(density);
  ComplexVector velocity = plain_velocity(rest, closure_.density_loads(density)) - 0.5 * rest +
                           closure_.smooth_velocity(density);
  if (near_) velocity += (*near_)(rest);
  for (std::size_t k = 0; k + 1 < offsets_.size(); ++k) {
    velocity.segment(offsets_[k], curve(k).size()) +=
        diagonal_velocity(curve(k), rest.segment(offsets_[k], curve(k).size()));
  }
  if (enclosing_wall_) {
    const Curve& wall = curve(*enclosing_wall_);
    const Index first = offsets_[*enclosing_wall_];
    velocity.segment(first, wall.size()) +=
        null_space_velocity(wall, rest.segment(first, wall.size()));
  }
  return velocity;
}
// [operator]

ComplexVector SuspensionOperator::right_hand_side() const {
  const auto* fast = std::get_if<FastSum>(&sum_);
  if (fast == nullptr) return closure_.right_hand_side();
  const std::vector<Load> loads = closure_.given_loads();
  const bool unloaded = std::ranges::all_of(
      loads, [](const Load& load) { return load.force == Complex{} && load.torque == 0.0; });
  if (unloaded) return closure_.boundary_data();
  // g_k - u_inf - sum_p (S_p F_p + R_p L_p) as in (03.10).
  return closure_.boundary_data() - fast->velocity(ComplexVector::Zero(offsets_.back()), loads);
}

ComplexVector SuspensionOperator::plain_velocity(const ComplexVector& density,
                                                 const std::vector<Load>& loads) const {
  if (const auto* fast = std::get_if<FastSum>(&sum_)) return fast->velocity(density, loads);
  return std::get<StressletSum>(sum_)(density) +
         closure_.singular_velocity(loads, closure_.nodes());
}

GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs, GmresOptions options,
                  const ComplexVector& guess) {
  options.norm = operator_norm;
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
  return {SuspensionOperator(problem, near_curves(plan, configuration, discretisation), plan,
                             NearStorage::factored)};
}

LinearSystem preconditioned_system(const Scene& scene, const Plan& plan,
                                   const StokesProblem& problem, const Configuration& configuration,
                                   const std::vector<Gap>& gaps,
                                   const Discretisation& discretisation, double separation,
                                   const SharedTree& earlier) {
  const std::vector<PlacedCurve> placed = near_curves(plan, configuration, discretisation);
  const auto kind = chosen_preconditioner(plan, gaps, discretisation, separation);
  // A preconditioner needs far more memory while it is built than later, so it comes first.
  auto [inverse, tree] = make_preconditioner(kind, plan, scene, problem, configuration, gaps,
                                             discretisation, placed, earlier);
  return {SuspensionOperator(problem, placed, plan), std::move(inverse), kind, std::move(tree)};
}

}  // namespace stokesbook
