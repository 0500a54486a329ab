// Computes columns of the mobility for contact forces: reuses those of earlier configurations,
// solves for new ones loosely, and corrects them where the contact forces need it (chapter 12).
#include "suspension/contact/contact_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "double_layer/double_layer.hpp"
#include "suspension/contact/definite_correction.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::SparseMatrix;
using Eigen::SparseVector;
using Eigen::VectorXd;

namespace {

// Loads whose relative difference is below this share one solve: the difference of their solutions
// is below the solver's tolerance.
constexpr double same_load = 1e-9;

// Largest relative residual to which columns are solved.
constexpr double most_solved_tolerance = 1e-2;

// Loads with a larger cosine of the angle between them are similar: the column of the one is that
// of the other up to MobilityColumns::most_tolerance.
constexpr double similar_from = 0.995;

// Largest ratio of the columns kept for the next configuration to those that were used in this one.
constexpr std::size_t most_kept = 2;

// Iterations that a tenth of the tolerance takes for a column, approximately. When refinements have
// taken as many a column, or when residuals grow because weights oscillate, as between flat gaps,
// the columns are too inaccurate.
constexpr int iterations_of_closer_column = 5;

// Largest motion that definite_correction() may add, over the solver's tolerance.
constexpr double most_correction = 0.1, infinite = std::numeric_limits<double>::infinity();

// Factors of the columns' tolerance: by tighten(), and for the next configuration.
constexpr double tightening = 0.1, loosening = 10.0;

// Returns for each load the smallest sine of the angle to another load, up to a factor of 2; 1 if
// all angles are large.
VectorXd separations(const SparseMatrix<double>& loads) {
  const SparseMatrix<double> products = loads.transpose() * loads;
  const VectorXd squares = products.diagonal();
  VectorXd parts = VectorXd::Ones(loads.cols());
  for (Index j = 0; j < products.outerSize(); ++j) {
    for (SparseMatrix<double>::InnerIterator product(products, j); product; ++product) {
      const Index i = product.row();
      const double cosine_squared = product.value() * product.value() / (squares[i] * squares[j]);
      const bool same = cosine_squared > 1.0 - same_load;
      if (!same) parts[i] = std::min(parts[i], 2.0 * std::sqrt(1.0 - cosine_squared));
    }
  }
  return parts;
}

// Rotates the forces of a load by a part of the components' orientations: 1 from the frames of the
// components to the plane, -1 back.
VectorXd turned(VectorXd load, const Configuration& configuration, double part) {
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    auto force = load.segment<2>(static_cast<Index>(3 * k));
    force = Eigen::Rotation2Dd(part * configuration[k].orientation) * force.eval();
  }
  return load;
}

// Poses the problem of the same components at rest, under a load alone.
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

// Completes densities of the same components at rest, under a load alone.
Closure closure_under(const StokesProblem& problem, const SparseVector<double>& load) {
  return Closure(under_loads(problem, load));
}

// Returns the cosine of the angle between the forces of two loads.
double similarity(const SparseVector<double>& p, const SparseVector<double>& q) {
  return std::abs(p.dot(q)) / (p.norm() * q.norm());
}

// Returns the largest velocity of a free body, or angular velocity times radius of gyration.
double fastest(const VectorXd& velocities, const VectorXd& over_lengths) {
  double largest = 0.0;
  for (Index i = 0; i < velocities.size(); i += 3) {
    if (over_lengths[i] == 0.0) continue;
    const double omega = velocities[i + 2] / over_lengths[i + 2];
    largest = std::max({largest, std::hypot(velocities[i], velocities[i + 1]), std::abs(omega)});
  }
  return largest;
}

}  // namespace

ContactMobility::ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                                 MobilityColumns earlier, std::optional<double> exact)
    : solver_(solver),
      configuration_(solution.instant.configuration),
      discretisation_(solution.discretisation),
      earlier_(std::move(earlier)),
      exact_(exact.value_or(solver.plan().gmres_tolerance)),
      tolerance_(std::max(earlier_.tolerance, exact_)),
      discrete_(solution.system),
      velocity_scale_(solution.velocity_scale),
      most_correction_(most_correction * solver.scene().solver.tolerance) {}

void ContactMobility::begin() {
  flow_ = discrete_->system.right_hand_side().norm();
  over_lengths_ = VectorXd::Zero(static_cast<Index>(3 * discretisation_.size()));
  for (std::size_t k = 0; k < discretisation_.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation_[k];
    if (discretised.kind != ComponentKind::free_body) continue;
    over_lengths_.segment<3>(static_cast<Index>(3 * k)) << 1.0, 1.0,
        1.0 / discretised.gyration_radius;
  }
  if (discrete_->is_factorised) return;  // back substitutions need no guesses
  const Eigen::MatrixXcd guesses = earlier_.densities.guess(0.0, configuration_, discretisation_);
  for (Index i = 0; i < earlier_.loads.cols(); ++i) {
    const VectorXd at_bodies = earlier_.loads.col(i);
    const SparseVector<double> load = turned(at_bodies, configuration_, 1.0).sparseView();
    earlier_columns_.push_back(
        {load, over_lengths_.asDiagonal() * load, guesses.col(i), {}, 1.0, earlier_.flows[i]});
  }
}

void ContactMobility::reuse_similar(Column& asked) const {
  const Column* nearest = nullptr;
  double most = 0.0;
  for (const std::vector<Column>& known : {std::cref(columns_), std::cref(earlier_columns_)}) {
    for (const Column& column : known) {
      const double cosine = similarity(asked.forces, column.forces);
      if (!(cosine > most)) continue;
      most = cosine;
      nearest = &column;
    }
  }
  if (nearest == nullptr) return;
  const double part = asked.forces.dot(nearest->forces) / nearest->forces.squaredNorm();
  asked.density = part * nearest->density;
  if (most > similar_from) {
    asked.tolerance = MobilityColumns::most_tolerance;
    complete(asked, std::abs(part) * nearest->flow);
  }
}

void ContactMobility::solve_by_factors(Column& asked) const {
  const ComplexVector rhs = closure_under(discrete_->problem, asked.load).right_hand_side();
  asked.density = deinterleaved(discrete_->precondition(interleaved(rhs)));
  asked.tolerance = exact_;
  complete(asked, rhs.norm());
}

// The motions of free bodies are functionals of the density; they do not depend on the load.
void ContactMobility::complete(Column& column, double flow) const {
  column.flow = flow;
  column.motions = discrete_->system.closure().complete(column.density).motions;
}

GmresResult ContactMobility::solve(const ComplexVector& rhs, double tolerance,
                                   const ComplexVector& guess) {
  const GmresOptions options{tolerance, solver_.scene().solver.gmres_max_iterations};
  GmresResult result = stokesbook::solve(*discrete_, rhs, options, guess);
  if (!result.converged) {
    throw SolverError("GMRES did not converge for a contact force in " +
                      std::to_string(result.iterations) +
                      " iterations: raise solver.gmres_max_iterations or solver.tolerance");
  }
  ++solves_;
  cost_.gmres_iterations += result.iterations;
  cost_.matvecs += result.applications;
  return result;
}

std::size_t ContactMobility::find_or_add(Column asked) {
  const auto known = std::ranges::find_if(columns_, [&](const Column& column) {
    return (asked.forces - column.forces).norm() <= same_load * asked.forces.norm();
  });
  if (known != columns_.end()) return static_cast<std::size_t>(known - columns_.begin());
  if (discrete_->is_factorised) {
    solve_by_factors(asked);
  } else {
    reuse_similar(asked);
  }
  columns_.push_back(std::move(asked));
  spent_ = 0;
  return columns_.size() - 1;
}

// Nearly parallel loads, of two contact points in one flat gap, require a tolerance that is tighter
// in proportion to the angle between them.
void ContactMobility::solve_to_tolerance(Column& asked, double separation) {
  if (asked.tolerance <= std::max(exact_, separation * tolerance_)) return;
  asked.tolerance = std::max(exact_, separation * std::min(tolerance_, most_solved_tolerance));
  const ComplexVector rhs = closure_under(discrete_->problem, asked.load).right_hand_side();
  asked.density = deinterleaved(solve(rhs, asked.tolerance, asked.density).solution);
  complete(asked, rhs.norm());
}

MatrixXd ContactMobility::operator()(const SparseMatrix<double>& loads) {
  if (over_lengths_.size() == 0) begin();
  velocities_ = MatrixXd::Zero(loads.rows(), loads.cols());
  const SparseMatrix<double> forces = over_lengths_.asDiagonal() * loads;
  const VectorXd parts = separations(forces);
  latest_.clear();
  for (Index column = 0; column < loads.cols(); ++column) {
    latest_.push_back(find_or_add({loads.col(column), forces.col(column), {}}));
    Column& asked = columns_[latest_.back()];
    solve_to_tolerance(asked, parts[column]);
    for (std::size_t k = 0; k < asked.motions.size(); ++k) {
      const auto& [velocity, omega] = asked.motions[k];
      velocities_.block<3, 1>(static_cast<Index>(3 * k), column) << velocity.real(),
          velocity.imag(), omega;
    }
  }
  correction_ = MatrixXd::Zero(loads.rows(), loads.cols());
  if (corrects_) {
    const MatrixXd works = loads.transpose() * velocities_;
    correction_ = over_lengths_.asDiagonal() * definite_correction(forces, works);
  }
  return velocities_ + correction_;
}

double ContactMobility::corrected_by(const VectorXd& multipliers) const {
  if (multipliers.isZero(0.0)) return 0.0;
  const double scale = std::max(velocity_scale_, fastest(velocities_ * multipliers, over_lengths_));
  return fastest(correction_ * multipliers, over_lengths_) / scale;
}

// Adds up the multipliers of the loads that share a column.
VectorXd ContactMobility::weights(const VectorXd& multipliers) const {
  VectorXd weights = VectorXd::Zero(static_cast<Index>(columns_.size()));
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    weights[static_cast<Index>(latest_[i])] += multipliers[static_cast<Index>(i)];
  }
  return weights;
}

// Bounds the residual of a combination: changes of the weights since the latest refinement bring in
// the residuals of their columns.
double ContactMobility::residual_bound(const VectorXd& weights) const {
  double residual = 0.0;
  for (Index i = 0; i < weights.size(); ++i) {
    const Column& column = columns_[static_cast<std::size_t>(i)];
    const double before = i < refined_.size() ? refined_[i] : 0.0;
    residual += std::abs(weights[i] - before) * column.tolerance * column.flow;
  }
  return residual;
}

bool ContactMobility::refine(const VectorXd& multipliers) {
  if (multipliers.size() == 0 || multipliers.isZero(0.0)) return false;
  if (refine_combination(multipliers)) return true;
  if (corrected_by(multipliers) <= most_correction_) return false;
  return tighten() || std::exchange(corrects_, false);
}

bool ContactMobility::refine_combination(const VectorXd& multipliers) {
  const VectorXd weights = this->weights(multipliers);
  const double missing = residual_bound(weights);
  if (refined_.size() > 0 && missing <= allowed_) return false;
  const auto columns = static_cast<int>((weights.array() != 0.0).count());
  if (spent_ > iterations_of_closer_column * columns) return tighten();
  const LoadSolution sum = combined(multipliers);
  const ComplexVector rhs =
      closure_under(discrete_->problem, combined_load(multipliers)).right_hand_side();
  const double strength = std::max(flow_, rhs.norm());
  const GmresResult found = solve(rhs, exact_ * strength / rhs.norm(), sum.density);
  refined_ = weights;
  allowed_ = 0.5 * exact_ * strength;
  if (found.iterations == 0) return false;
  const double residual = found.history.front() * rhs.norm(), more_than_known = residual / missing;
  const bool diverges = residual > std::exchange(missing_, residual) && spent_ > 0;
  spent_ += found.iterations;
  if (diverges) tighten();
  const ComplexVector change =
      (deinterleaved(found.solution) - sum.density) / weights.squaredNorm();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double weight = weights[static_cast<Index>(i)];
    if (weight == 0.0) continue;
    Column& column = columns_[i];
    column.tolerance *= std::max(1.0, more_than_known);
    column.density += weight * change;
    complete(column, column.flow);
  }
  return true;
}

bool ContactMobility::keep_correction() {
  corrects_ = true;
  return std::exchange(most_correction_, infinite) < infinite;
}

bool ContactMobility::tighten() {
  if (tolerance_ <= exact_) return false;
  tolerance_ = std::max(exact_, tightening * tolerance_);
  spent_ = 0;
  return true;
}

SparseVector<double> ContactMobility::combined_load(const VectorXd& multipliers) const {
  SparseVector<double> load(columns_.front().load.size());
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    load += multipliers[static_cast<Index>(i)] * columns_[latest_[i]].load;
  }
  return load;
}

LoadSolution ContactMobility::combined(const VectorXd& multipliers) const {
  ComplexVector density = ComplexVector::Zero(columns_.front().density.size());
  for (std::size_t i = 0; i < latest_.size(); ++i) {
    density += multipliers[static_cast<Index>(i)] * columns_[latest_[i]].density;
  }
  const Completion completion =
      closure_under(discrete_->problem, combined_load(multipliers)).complete(density);
  return {std::move(density), completion};
}

MobilityColumns ContactMobility::columns() const {
  if (columns_.empty()) return earlier_;
  std::vector<const Column*> known;
  for (const Column& column : columns_) known.push_back(&column);
  for (const Column& guess : earlier_columns_) {
    if (known.size() == most_kept * columns_.size()) break;
    const bool is_known = std::ranges::any_of(columns_, [&](const Column& column) {
      return similarity(column.forces, guess.forces) > similar_from;
    });
    if (!is_known) known.push_back(&guess);
  }
  const auto m = static_cast<Index>(known.size());
  Eigen::MatrixXcd densities(columns_.front().density.size(), m);
  MobilityColumns result{MatrixXd(columns_.front().load.size(), m), VectorXd(m)};
  for (Index i = 0; i < m; ++i) {
    const Column& column = *known[static_cast<std::size_t>(i)];
    result.loads.col(i) = turned(column.load, configuration_, -1.0);
    result.flows[i] = column.flow;
    densities.col(i) = column.density;
  }
  result.densities.add(0.0, configuration_, discretisation_, std::move(densities));
  result.tolerance = std::min(MobilityColumns::most_tolerance, loosening * tolerance_);
  return result;
}

}  // namespace stokesbook
