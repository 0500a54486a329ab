#include "suspension/load_response.hpp"

#include <algorithm>
#include <functional>
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

// Each refinement leaves a few hundredths of what was missing; where one leaves more than half, or
// as many are needed, columns are too coarse: between flat gaps weights may go to and fro.
constexpr double least_progress = 0.5;
constexpr int most_refinements = 6;

// Columns of the next configuration: after two refinements or more, and after fewer.
constexpr double closer_columns = 0.1, coarser_columns = 2.0;

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
                           const Solution& solution, AnsweredLoads earlier,
                           std::optional<double> exact)
    : solver_(solver),
      configuration_(std::move(configuration)),
      references_(solution.references),
      earlier_(std::move(earlier)),
      exact_(exact.value_or(solver.plan().gmres_tolerance)),
      tolerance_(std::max(earlier_.tolerance, exact_)),
      discrete_(solution.system) {}

void LoadResponse::begin() {
  flow_ = discrete_->system.right_hand_side().norm();
  const Eigen::MatrixXcd guesses = earlier_.densities.guess(0.0, configuration_, references_);
  for (Index i = 0; i < earlier_.loads.cols(); ++i) {
    guesses_.push_back({earlier_.loads.col(i).sparseView(), guesses.col(i)});
  }
}

Closure LoadResponse::closure(const SparseVector<double>& load) const {
  return Closure(under_loads(discrete_->problem, load));
}

ComplexVector LoadResponse::guess(const SparseVector<double>& load) const {
  const Answer* nearest = nullptr;
  double most = 0.0;
  for (const std::vector<Answer>& known : {std::cref(answers_), std::cref(guesses_)}) {
    for (const Answer& answer : known) {
      const double likeness = std::abs(load.dot(answer.load)) / answer.load.norm();
      if (likeness <= most) continue;
      most = likeness;
      nearest = &answer;
    }
  }
  if (nearest == nullptr) return {};
  return load.dot(nearest->load) / nearest->load.squaredNorm() * nearest->density;
}

ComplexVector LoadResponse::density(const ComplexVector& rhs, double tolerance,
                                    const ComplexVector& guess) {
  const GmresOptions options{tolerance, solver_.scene().solver.gmres_max_iterations};
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
  auto known = std::ranges::find_if(answers_, [&](const Answer& answer) {
    return (load - answer.load).norm() <= same_load * load.norm();
  });
  if (known == answers_.end()) {
    answers_.push_back({load, guess(load)});
    known = answers_.end() - 1;
    refinements_ = 0;
  }
  if (known->tolerance > tolerance_) {
    const Closure closure = this->closure(known->load);
    const ComplexVector rhs = closure.right_hand_side();
    known->density = density(rhs, tolerance_, known->density);
    known->flow = rhs.norm();
    known->motions = closure.complete(known->density).motions;
    known->tolerance = tolerance_;
  }
  return static_cast<std::size_t>(known - answers_.begin());
}

MatrixXd LoadResponse::operator()(const Eigen::SparseMatrix<double>& loads) {
  if (answers_.empty() && guesses_.empty()) begin();
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

// The columns of the latest call that share an answer count together.
VectorXd LoadResponse::weights(const VectorXd& multipliers) const {
  VectorXd weights = VectorXd::Zero(static_cast<Index>(answers_.size()));
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    weights[static_cast<Index>(latest_[i])] += multipliers[static_cast<Index>(i)];
  }
  return weights;
}

// How much of a residual weights have brought in since the combination was exact, at most.
double LoadResponse::residual_since(const VectorXd& weights) const {
  double residual = 0.0;
  for (Index i = 0; i < weights.size(); ++i) {
    const Answer& answer = answers_[static_cast<std::size_t>(i)];
    const double before = i < refined_.size() ? refined_[i] : 0.0;
    residual += std::abs(weights[i] - before) * answer.tolerance * answer.flow;
  }
  return residual;
}

bool LoadResponse::refine(const VectorXd& multipliers) {
  if (multipliers.size() == 0 || multipliers.isZero(0.0) || tolerance_ <= exact_) return false;
  const VectorXd weights = this->weights(multipliers);
  const double missing_now = residual_since(weights);
  if (refined_.size() > 0 && missing_now <= 0.5 * exact_ * flow_) return false;
  const bool stalls = refinements_ > 0 && missing_now > least_progress * missing_;
  if (stalls || refinements_ == most_refinements) return tighten();
  missing_ = missing_now;
  const LoadSolution sum = combined(multipliers);
  const Closure closure = this->closure(combined_load(multipliers));
  const ComplexVector rhs = closure.right_hand_side();
  const int before = cost_.gmres_iterations;
  const double tolerance = exact_ * std::max(1.0, flow_ / rhs.norm());
  const ComplexVector found = density(rhs, tolerance, sum.density);
  refined_ = weights;
  if (cost_.gmres_iterations == before) return false;
  ++refinements_;
  ++all_refinements_;
  const ComplexVector missing = (found - sum.density) / weights.squaredNorm();
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const double weight = weights[static_cast<Index>(i)];
    if (weight == 0.0) continue;
    Answer& answer = answers_[i];
    answer.density += weight * missing;
    answer.motions = closure.complete(answer.density).motions;
  }
  return true;
}

bool LoadResponse::tighten() {
  if (tolerance_ <= exact_) return false;
  tolerance_ = exact_;
  return true;
}

SparseVector<double> LoadResponse::combined_load(const VectorXd& multipliers) const {
  SparseVector<double> load(answers_.front().load.size());
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    load += multipliers[static_cast<Index>(i)] * answers_[latest_[i]].load;
  }
  return load;
}

LoadSolution LoadResponse::combined(const VectorXd& multipliers) const {
  ComplexVector density = ComplexVector::Zero(answers_.front().density.size());
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    density += multipliers[static_cast<Index>(i)] * answers_[latest_[i]].density;
  }
  const Completion completion = closure(combined_load(multipliers)).complete(density);
  return {std::move(density), completion};
}

AnsweredLoads LoadResponse::answered() const {
  if (answers_.empty()) return {};
  const auto m = static_cast<Index>(answers_.size());
  Eigen::MatrixXcd densities(answers_.front().density.size(), m);
  AnsweredLoads result{MatrixXd(answers_.front().load.size(), m)};
  for (Index i = 0; i < m; ++i) {
    const Answer& answer = answers_[static_cast<std::size_t>(i)];
    result.loads.col(i) = answer.load;
    densities.col(i) = answer.density;
  }
  result.densities.add(0.0, configuration_, references_, std::move(densities));
  const double factor = all_refinements_ > 1 ? closer_columns : coarser_columns;
  result.tolerance = std::min(AnsweredLoads::most_tolerance, factor * tolerance_);
  return result;
}

}  // namespace stokesbook
