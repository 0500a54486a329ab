// Computes columns of the mobility for contact forces: reuses those of earlier configurations,
// solves for new ones loosely, and corrects them where the contact forces need it (chapter 12).
#include "suspension/contact/contact_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "double_layer/double_layer.hpp"
#include "suspension/system/fast_sum.hpp"

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
VectorXd smallest_angles(const SparseMatrix<double>& loads) {
  const SparseMatrix<double> products = loads.transpose() * loads;
  const VectorXd squares = products.diagonal();
  VectorXd sines = VectorXd::Ones(loads.cols());
  for (Index j = 0; j < products.outerSize(); ++j) {
    for (SparseMatrix<double>::InnerIterator product(products, j); product; ++product) {
      const Index i = product.row();
      const double cosine_squared = product.value() * product.value() / (squares[i] * squares[j]);
      const bool same = cosine_squared > 1.0 - same_load;
      if (!same) sines[i] = std::min(sines[i], 2.0 * std::sqrt(1.0 - cosine_squared));
    }
  }
  return sines;
}

// Rotates the forces of a load by a part of the components' orientations: 1 from the frames of the
// components to the plane, -1 back.
VectorXd rotate_forces(VectorXd load, const Configuration& configuration, double part) {
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    auto force = load.segment<2>(static_cast<Index>(3 * k));
    force = Eigen::Rotation2Dd(part * configuration[k].orientation) * force.eval();
  }
  return load;
}

// Poses the problem of the same components at rest, under a load alone.
StokesProblem problem_under(StokesProblem problem, const SparseVector<double>& load) {
  problem.background.resize(0);
  if (problem.cell && problem.cell->pressure_gradient) problem.cell->pressure_gradient = 0.0;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    Component& component = problem.components[k];
    component.velocity = ComplexVector::Zero(component.velocity.size());
    const auto first = static_cast<Index>(3 * k);
    component.force = {load.coeff(first), load.coeff(first + 1)};
    component.torque = load.coeff(first + 2);
  }
  return problem;
}

// Assembles the right-hand side of the system for a load alone. The singularities of the few bodies
// on which a load acts are summed directly, unless they have images.
ComplexVector rhs_under(const StokesProblem& problem, const SparseVector<double>& load,
                        const Plan& plan) {
  const StokesProblem loaded = problem_under(problem, load);
  const Closure closure(loaded);
  if (!problem.cell) return closure.right_hand_side();
  const ComplexVector none = ComplexVector::Zero(node_offsets(loaded).back());
  return -FastSum(loaded, plan.sum_tolerance).velocity(none, closure.given_loads());
}

// Returns the cosine of the angle between two loads.
double cosine(const SparseVector<double>& p, const SparseVector<double>& q) {
  return std::abs(p.dot(q)) / (p.norm() * q.norm());
}

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

// Returns the factors that scale loads: 1 for forces, 1 over the radius of gyration for torques; 0
// for loads that supports bear.
VectorXd load_scales(const Discretisation& discretisation) {
  VectorXd factors = VectorXd::Zero(static_cast<Index>(3 * discretisation.size()));
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation[k];
    if (discretised.kind != ComponentKind::free_body) continue;
    factors.segment<3>(static_cast<Index>(3 * k)) << 1.0, 1.0, 1.0 / discretised.gyration_radius;
  }
  return factors;
}

}  // namespace

MatrixXd definite_correction(const MatrixXd& loads, const MatrixXd& works) {
  const MatrixXd none = MatrixXd::Zero(loads.rows(), loads.cols());
  const auto m = loads.cols();
  if (m == 0 || !(works.diagonal().minCoeff() > 0.0)) return none;
  const VectorXd scale = works.diagonal().cwiseSqrt();
  const VectorXd unit = scale.cwiseInverse();
  const MatrixXd scaled = unit.asDiagonal() * works * unit.asDiagonal();
  const MatrixXd symmetric = 0.5 * (scaled + scaled.transpose());
  if (symmetric.llt().info() == Eigen::Success) return none;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> modes(symmetric);
  const VectorXd& eigenvalues = modes.eigenvalues();
  const VectorXd increase = (-eigenvalues.minCoeff() - eigenvalues.array()).cwiseMax(0.0);
  const MatrixXd vectors = scale.asDiagonal() * modes.eigenvectors();
  const MatrixXd change = vectors * increase.asDiagonal() * vectors.transpose();
  // The least V' with F^T V' = change: F (F^T F)^+ change, where loads may depend on each other.
  const MatrixXd gram = loads.transpose() * loads;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> of_gram(gram);
  const VectorXd& squares = of_gram.eigenvalues();
  const double zero =
      std::numeric_limits<double>::epsilon() * static_cast<double>(m) * squares.maxCoeff();
  const VectorXd inverse = (squares.array() > zero).select(squares.cwiseInverse(), 0.0);
  MatrixXd along = of_gram.eigenvectors().transpose() * change;
  along = inverse.asDiagonal() * along;
  return loads * (of_gram.eigenvectors() * along);
}

ContactMobility::ContactMobility(const SuspensionSolver& solver, const Solution& solution,
                                 MobilityColumns earlier, std::optional<double> exact)
    : solver_(solver),
      solution_(solution),
      earlier_(std::move(earlier)),
      combination_tolerance_(exact.value_or(solver.plan().gmres_tolerance)),
      column_tolerance_(std::max(earlier_.tolerance, combination_tolerance_)),
      flow_norm_(solution.system->system.right_hand_side().norm()),
      load_scales_(load_scales(solution.discretisation)),
      most_correction_(most_correction * solver.scene().solver.tolerance) {
  if (solution.system->is_factorised()) return;  // back substitutions need no guesses
  const Configuration& configuration = solution.instant.configuration;
  const Eigen::MatrixXcd guesses =
      earlier_.densities.guess(0.0, configuration, solution.discretisation);
  for (Index i = 0; i < earlier_.loads.cols(); ++i) {
    const VectorXd at_bodies = earlier_.loads.col(i);
    const SparseVector<double> load = rotate_forces(at_bodies, configuration, 1.0).sparseView();
    earlier_columns_.push_back({.load = load,
                                .scaled_load = load_scales_.asDiagonal() * load,
                                .density = guesses.col(i),
                                .rhs_norm = earlier_.rhs_norms[i]});
  }
}

void ContactMobility::reuse_similar(Column& column) const {
  const Column* nearest = nullptr;
  double most = 0.0;
  for (const std::vector<Column>& known : {std::cref(columns_), std::cref(earlier_columns_)}) {
    for (const Column& other : known) {
      const double similarity = cosine(column.scaled_load, other.scaled_load);
      if (!(similarity > most)) continue;
      most = similarity;
      nearest = &other;
    }
  }
  if (nearest == nullptr) return;
  const double part =
      column.scaled_load.dot(nearest->scaled_load) / nearest->scaled_load.squaredNorm();
  column.density = part * nearest->density;
  if (most > similar_from) {
    column.tolerance = MobilityColumns::most_tolerance;
    complete(column, std::abs(part) * nearest->rhs_norm);
  }
}

void ContactMobility::solve_by_factors(Column& column) const {
  const LinearSystem& discrete = *solution_.system;
  const ComplexVector rhs = rhs_under(discrete.problem(), column.load, solver_.plan());
  column.density = deinterleaved(discrete.precondition(interleaved(rhs)));
  column.tolerance = combination_tolerance_;
  complete(column, rhs.norm());
}

// The motions of free bodies are functionals of the density; they do not depend on the load.
void ContactMobility::complete(Column& column, double rhs_norm) const {
  column.rhs_norm = rhs_norm;
  column.motions = solution_.system->system.closure().complete(column.density).motions;
}

GmresResult ContactMobility::run_gmres(const ComplexVector& rhs, double tolerance,
                                       const ComplexVector& guess) {
  const GmresOptions options{tolerance, solver_.scene().solver.gmres_max_iterations};
  GmresResult result = solve(*solution_.system, rhs, options, guess);
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

std::size_t ContactMobility::find_or_add(Column column) {
  const auto known = std::ranges::find_if(columns_, [&](const Column& other) {
    return (column.scaled_load - other.scaled_load).norm() <= same_load * column.scaled_load.norm();
  });
  if (known != columns_.end()) return static_cast<std::size_t>(known - columns_.begin());
  if (solution_.system->is_factorised()) {
    solve_by_factors(column);
  } else {
    reuse_similar(column);
  }
  columns_.push_back(std::move(column));
  refinement_iterations_ = 0;
  return columns_.size() - 1;
}

// Nearly parallel loads, of two contact points in one flat gap, require a tolerance that is tighter
// in proportion to the angle between them.
void ContactMobility::solve_to_tolerance(Column& column, double angle) {
  if (column.tolerance <= std::max(combination_tolerance_, angle * column_tolerance_)) return;
  column.tolerance =
      std::max(combination_tolerance_, angle * std::min(column_tolerance_, most_solved_tolerance));
  const ComplexVector rhs = rhs_under(solution_.system->problem(), column.load, solver_.plan());
  column.density = deinterleaved(run_gmres(rhs, column.tolerance, column.density).solution);
  complete(column, rhs.norm());
}

MatrixXd ContactMobility::operator()(const SparseMatrix<double>& loads) {
  velocities_ = MatrixXd::Zero(loads.rows(), loads.cols());
  const SparseMatrix<double> scaled_loads = load_scales_.asDiagonal() * loads;
  const VectorXd angles = smallest_angles(scaled_loads);
  latest_columns_.clear();
  for (Index j = 0; j < loads.cols(); ++j) {
    latest_columns_.push_back(find_or_add({loads.col(j), scaled_loads.col(j), {}}));
    Column& column = columns_[latest_columns_.back()];
    solve_to_tolerance(column, angles[j]);
    for (std::size_t k = 0; k < column.motions.size(); ++k) {
      const auto& [velocity, omega] = column.motions[k];
      velocities_.block<3, 1>(static_cast<Index>(3 * k), j) << velocity.real(), velocity.imag(),
          omega;
    }
  }
  correction_ = MatrixXd::Zero(loads.rows(), loads.cols());
  if (corrects_) {
    const MatrixXd works = loads.transpose() * velocities_;
    correction_ = load_scales_.asDiagonal() * definite_correction(scaled_loads, works);
  }
  return velocities_ + correction_;
}

double ContactMobility::relative_correction(const VectorXd& multipliers) const {
  if (multipliers.isZero(0.0)) return 0.0;
  const double scale =
      std::max(solution_.velocity_scale, largest_motion(velocities_ * multipliers, load_scales_));
  return largest_motion(correction_ * multipliers, load_scales_) / scale;
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
    const Column& column = columns_[static_cast<std::size_t>(i)];
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
  const ComplexVector rhs = rhs_under(solution_.system->problem(), load, solver_.plan());
  const double strength = std::max(flow_norm_, rhs.norm());
  const GmresResult found = run_gmres(rhs, combination_tolerance_ * strength / rhs.norm(), density);
  combination_weights_ = weights;
  allowed_residual_ = 0.5 * combination_tolerance_ * strength;
  if (found.iterations == 0) return false;
  const double residual = found.history.front() * rhs.norm(), more_than_known = residual / missing;
  const bool diverges =
      residual > std::exchange(combination_residual_, residual) && refinement_iterations_ > 0;
  refinement_iterations_ += found.iterations;
  if (diverges) tighten();
  const ComplexVector change = (deinterleaved(found.solution) - density) / weights.squaredNorm();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double weight = weights[static_cast<Index>(i)];
    if (weight == 0.0) continue;
    Column& column = columns_[i];
    column.tolerance *= std::max(1.0, more_than_known);
    column.density += weight * change;
    complete(column, column.rhs_norm);
  }
  return true;
}

bool ContactMobility::accept_any_correction() {
  corrects_ = true;
  return std::exchange(most_correction_, infinite) < infinite;
}

bool ContactMobility::tighten() {
  if (column_tolerance_ <= combination_tolerance_) return false;
  column_tolerance_ = std::max(combination_tolerance_, tightening * column_tolerance_);
  refinement_iterations_ = 0;
  return true;
}

std::pair<SparseVector<double>, ComplexVector> ContactMobility::combine(
    const VectorXd& multipliers) const {
  SparseVector<double> load(columns_.front().load.size());
  ComplexVector density = ComplexVector::Zero(columns_.front().density.size());
  for (std::size_t i = 0; i < latest_columns_.size(); ++i) {
    const Column& column = columns_[latest_columns_[i]];
    const double multiplier = multipliers[static_cast<Index>(i)];
    load += multiplier * column.load;
    density += multiplier * column.density;
  }
  return {load, density};
}

Solution ContactMobility::loaded_solution(const VectorXd& multipliers) const {
  Solution loaded = solution_;
  if (!(multipliers.array() > 0.0).any()) return loaded;
  const auto [load, density] = combine(multipliers);
  const Completion added =
      Closure(problem_under(solution_.system->problem(), load)).complete(density);
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

MobilityColumns ContactMobility::columns() const {
  if (columns_.empty()) return earlier_;
  const Configuration& configuration = solution_.instant.configuration;
  const Index m = std::ssize(columns_);
  Eigen::MatrixXcd densities(columns_.front().density.size(), m);
  MobilityColumns result{MatrixXd(columns_.front().load.size(), m), VectorXd(m)};
  for (Index i = 0; i < m; ++i) {
    const Column& column = columns_[static_cast<std::size_t>(i)];
    result.loads.col(i) = rotate_forces(column.load, configuration, -1.0);
    result.rhs_norms[i] = column.rhs_norm;
    densities.col(i) = column.density;
  }
  result.densities.add(0.0, configuration, solution_.discretisation, std::move(densities));
  result.tolerance = std::min(MobilityColumns::most_tolerance, loosening * column_tolerance_);
  return result;
}

}  // namespace stokesbook
