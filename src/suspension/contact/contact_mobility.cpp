// The mobility for contact forces: combines the columns of the loads, and corrects them where the
// combination is not accurate enough (chapter 12, section "Contact").
#include "suspension/contact/contact_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "double_layer/double_layer.hpp"
#include "suspension/contact/definite_correction.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::SparseVector;
using Eigen::VectorXd;

namespace {

// Iterations that a tenth of the tolerance takes for a column, approximately. When refinements have
// taken as many a column, or when residuals grow because weights oscillate, as between flat gaps,
// the columns are too inaccurate.
constexpr int iterations_of_closer_column = 5;

// Least part of the weights that counts as a new direction: a correction divides the errors of a
// combination by this part.
constexpr double least_new_part = 1e-3;

// Largest motion that definite_correction() may add, over the solver's tolerance. Where all bodies
// are pressed together, motions change by up to two hundred times as much.
constexpr double most_correction = 0.01, infinite = std::numeric_limits<double>::infinity();

// Returns the largest velocity of a free body, or angular velocity times radius of gyration.
double largest_motion(const VectorXd& velocities, const VectorXd& scales) {
  double largest = 0.0;
  for (Index i = 0; i < velocities.size(); i += 3) {
    if (scales[i] == 0.0) continue;
    const double omega = velocities[i + 2] / scales[i + 2];
    largest = std::max({largest, std::hypot(velocities[i], velocities[i + 1]), std::abs(omega)});
  }
  return largest;
}

}  // namespace

ContactMobility::ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                                 MobilityColumns earlier, std::optional<double> exact, double t)
    : columns_(solver, solution, std::move(earlier), exact.value_or(solver.plan().gmres_tolerance),
               t),
      most_correction_(most_correction * solver.scene().solver.tolerance),
      flow_norm_(solution.system->system.right_hand_side().norm()) {}

MatrixXd ContactMobility::operator()(const SparseMatrix<double>& loads) {
  const std::size_t known = columns_.size();
  auto [columns, solved_again] = columns_.find(loads);
  latest_columns_ = std::move(columns);
  const auto size = static_cast<Index>(columns_.size());
  if (columns_.size() > known) refinement_iterations_ = 0;
  if (solved_again) {  // no earlier combination is accurate any more
    combination_weights_.resize(0);
    directions_.resize(size, 0);
  }
  directions_.conservativeResizeLike(MatrixXd::Zero(size, directions_.cols()));
  velocities_ = MatrixXd::Zero(loads.rows(), loads.cols());
  for (Index j = 0; j < loads.cols(); ++j) {
    const LoadColumn& column = columns_[latest_columns_[static_cast<std::size_t>(j)]];
    for (std::size_t k = 0; k < column.motions.size(); ++k) {
      const auto& [velocity, omega] = column.motions[k];
      velocities_.block<3, 1>(static_cast<Index>(3 * k), j) << velocity.real(), velocity.imag(),
          omega;
    }
  }
  correction_ = MatrixXd::Zero(loads.rows(), loads.cols());
  if (corrects_) {
    const MatrixXd works = loads.transpose() * velocities_;
    const auto scales = columns_.load_scales().asDiagonal();
    correction_ = scales * definite_correction(scales * loads, works);
  }
  return velocities_ + correction_;
}

double ContactMobility::relative_correction(const VectorXd& multipliers) const {
  if (multipliers.isZero(0.0)) return 0.0;
  const double scale = std::max(columns_.solution().velocity_scale,
                                largest_motion(velocities_ * multipliers, columns_.load_scales()));
  return largest_motion(correction_ * multipliers, columns_.load_scales()) / scale;
}

// Adds up the multipliers of the loads that share a column.
VectorXd ContactMobility::column_weights(const VectorXd& multipliers) const {
  VectorXd weights = VectorXd::Zero(static_cast<Index>(columns_.size()));
  for (std::size_t i = 0; i < latest_columns_.size(); ++i) {
    weights[static_cast<Index>(latest_columns_[i])] += multipliers[static_cast<Index>(i)];
  }
  return weights;
}

// Bounds the residual of a combination: changes of the weights since the latest refinement bring in
// the residuals of their columns.
double ContactMobility::residual_bound(const VectorXd& weights) const {
  double residual = 0.0;
  for (Index i = 0; i < weights.size(); ++i) {
    const LoadColumn& column = columns_[static_cast<std::size_t>(i)];
    const double before = i < combination_weights_.size() ? combination_weights_[i] : 0.0;
    residual += std::abs(weights[i] - before) * column.tolerance * column.rhs_norm;
  }
  return residual;
}

bool ContactMobility::refine(const VectorXd& multipliers) {
  if (multipliers.size() == 0 || multipliers.isZero(0.0)) return false;
  if (refine_combination(multipliers)) return true;
  if (relative_correction(multipliers) <= most_correction_) return false;
  return tighten() || std::exchange(corrects_, false);
}

bool ContactMobility::refine_combination(const VectorXd& multipliers) {
  const VectorXd weights = column_weights(multipliers);
  const double missing = residual_bound(weights);
  if (combination_weights_.size() > 0 && missing <= allowed_residual_) return false;
  const auto columns = static_cast<int>((weights.array() != 0.0).count());
  if (refinement_iterations_ > iterations_of_closer_column * columns) return tighten();
  const auto [load, density] = combine(multipliers);
  const ComplexVector rhs = columns_.rhs_under(load);
  const double exact = columns_.tightest() * std::max(flow_norm_, rhs.norm());
  const ComplexVector expected = columns_.expected_change(load);
  const ComplexVector guess = expected.size() > 0 ? ComplexVector(density + expected) : density;
  const GmresResult found = columns_.solve(rhs, exact / rhs.norm(), guess);
  const ComplexVector missed = deinterleaved(found.solution) - density;
  columns_.remember_change(load, missed);
  combination_weights_ = weights;
  allowed_residual_ = 0.5 * exact;
  if (found.iterations == 0 && expected.size() == 0) return false;
  const double residual = found.history.front() * rhs.norm(), more_than_known = residual / missing;
  const bool diverges =
      residual > std::exchange(combination_residual_, residual) && refinement_iterations_ > 0;
  refinement_iterations_ += found.iterations;
  if (diverges) tighten();
  const VectorXd direction = add_direction(weights);
  const ComplexVector change = missed / direction.dot(weights);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double part = direction[static_cast<Index>(i)];
    if (part == 0.0) continue;
    columns_.correct(i, part * change, more_than_known * columns_[i].tolerance);
  }
  return true;
}

// Returns the part of the weights that no earlier combination has had. If it is small, returns all
// of them.
VectorXd ContactMobility::add_direction(const VectorXd& weights) {
  const VectorXd part = weights - directions_ * (directions_.transpose() * weights);
  if (part.norm() < least_new_part * weights.norm()) return weights;
  directions_.conservativeResize(Eigen::NoChange, directions_.cols() + 1);
  directions_.rightCols<1>() = part.normalized();
  return part;
}

bool ContactMobility::accept_any_correction() {
  corrects_ = true;
  return std::exchange(most_correction_, infinite) < infinite;
}

bool ContactMobility::tighten() {
  if (!columns_.tighten()) return false;
  refinement_iterations_ = 0;
  return true;
}

std::pair<SparseVector<double>, ComplexVector> ContactMobility::combine(
    const VectorXd& multipliers) const {
  SparseVector<double> load(columns_[0].load.size());
  ComplexVector density = ComplexVector::Zero(columns_[0].density.size());
  for (std::size_t i = 0; i < latest_columns_.size(); ++i) {
    const LoadColumn& column = columns_[latest_columns_[i]];
    const double multiplier = multipliers[static_cast<Index>(i)];
    load += multiplier * column.load;
    density += multiplier * column.density;
  }
  return {load, density};
}

Solution ContactMobility::loaded_solution(const VectorXd& multipliers) const {
  Solution loaded = columns_.solution();
  if (!(multipliers.array() > 0.0).any()) return loaded;
  const auto [load, density] = combine(multipliers);
  const Completion added = Closure(columns_.problem_under(load)).complete(density);
  loaded.density += density;
  loaded.uniform_velocity += added.uniform_velocity;
  for (std::size_t k = 0; k < loaded.motions.size(); ++k) {
    loaded.loads[k].force += added.loads[k].force;
    loaded.loads[k].torque += added.loads[k].torque;
    loaded.motions[k].velocity += added.motions[k].velocity;
    loaded.motions[k].omega += added.motions[k].omega;
  }
  return loaded;
}

}  // namespace stokesbook
