#include "suspension/load_response.hpp"

#include <algorithm>
#include <utility>

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::SparseVector;
using Eigen::VectorXd;

namespace {

// Relative difference of loads that count as one: what it changes is below the solver's tolerance.
constexpr double same_load = 1e-9;

// The same components at rest, under some loads and nothing else.
StokesProblem under_loads(StokesProblem problem, const SparseVector<double>& load) {
  problem.background.resize(0);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    Component& component = problem.components[k];
    component.velocity = ComplexVector::Zero(component.velocity.size());
    const auto first = static_cast<Index>(3 * k);
    component.force = {load.coeff(first), load.coeff(first + 1)};
    component.torque = load.coeff(first + 2);
  }
  return problem;
}

}  // namespace

LoadResponse::LoadResponse(const SuspensionSolver& solver, Configuration configuration,
                           References references)
    : solver_(solver),
      configuration_(std::move(configuration)),
      references_(std::move(references)) {}

ComplexVector LoadResponse::guess(const SparseVector<double>& load) const {
  const Answer* nearest = nullptr;
  double most = 0.0;
  for (const Answer& answer : answers_) {
    const double likeness = std::abs(load.dot(answer.load)) / answer.load.norm();
    if (likeness <= most) continue;
    most = likeness;
    nearest = &answer;
  }
  if (nearest == nullptr) return {};
  return load.dot(nearest->load) / nearest->load.squaredNorm() * nearest->density;
}

ComplexVector LoadResponse::density(const Closure& closure, const ComplexVector& guess) {
  const ComplexVector rhs = closure.right_hand_side();
  const GmresOptions options{solver_.plan().gmres_tolerance,
                             solver_.scene().solver.gmres_max_iterations};
  const GmresResult result = solve(*discrete_, rhs, options, guess);
  if (!result.converged) {
    throw NumericsRefused("GMRES did not converge for a contact force in " +
                          std::to_string(result.iterations) +
                          " iterations: raise solver.gmres_max_iterations or solver.tolerance");
  }
  ++solves_;
  cost_.gmres_iterations += result.iterations;
  cost_.matvecs += result.applications;
  return deinterleaved(result.solution);
}

std::size_t LoadResponse::answer(const SparseVector<double>& load) {
  const auto known = std::ranges::find_if(answers_, [&](const Answer& answer) {
    return (load - answer.load).norm() <= same_load * load.norm();
  });
  if (known != answers_.end()) return static_cast<std::size_t>(known - answers_.begin());
  const Closure closure(under_loads(discrete_->problem, load));
  ComplexVector found = density(closure, guess(load));
  std::vector<RigidMotion> motions = closure.complete(found).motions;
  answers_.push_back({load, std::move(found), std::move(motions)});
  return answers_.size() - 1;
}

MatrixXd LoadResponse::operator()(const Eigen::SparseMatrix<double>& loads) {
  if (!discrete_) discrete_ = solver_.discretise(configuration_, references_);
  MatrixXd velocities = MatrixXd::Zero(loads.rows(), loads.cols());
  latest_.clear();
  for (Index column = 0; column < loads.cols(); ++column) {
    latest_.push_back(answer(loads.col(column)));
    const std::vector<RigidMotion>& motions = answers_[latest_.back()].motions;
    for (std::size_t k = 0; k < motions.size(); ++k) {
      velocities.block<3, 1>(static_cast<Index>(3 * k), column) << motions[k].velocity.real(),
          motions[k].velocity.imag(), motions[k].omega;
    }
  }
  return velocities;
}

LoadSolution LoadResponse::combined(const VectorXd& multipliers) const {
  SparseVector<double> load(answers_.front().load.size());
  ComplexVector density = ComplexVector::Zero(answers_.front().density.size());
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    const double factor = multipliers[static_cast<Index>(i)];
    load += factor * answers_[latest_[i]].load;
    density += factor * answers_[latest_[i]].density;
  }
  const Completion completion = Closure(under_loads(discrete_->problem, load)).complete(density);
  return {std::move(density), completion};
}

}  // namespace stokesbook
