// Computes columns of the mobility for contact forces: reuses those of earlier configurations, and
// solves for new ones loosely (chapter 12, section "Contact").
#include "suspension/contact/load_columns.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

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

// Returns the cosine of the angle between two loads.
double cosine(const SparseVector<double>& p, const SparseVector<double>& q) {
  return std::abs(p.dot(q)) / (p.norm() * q.norm());
}

// Computes LoadColumns::load_scales().
VectorXd load_scales_of(const Discretisation& discretisation) {
  VectorXd factors = VectorXd::Zero(static_cast<Index>(3 * discretisation.size()));
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    const DiscretisedShape& discretised = *discretisation[k];
    if (discretised.kind != ComponentKind::free_body) continue;
    factors.segment<3>(static_cast<Index>(3 * k)) << 1.0, 1.0, 1.0 / discretised.gyration_radius;
  }
  return factors;
}

}  // namespace

LoadColumns::LoadColumns(const SuspensionSolver& solver, Solution solution, MobilityColumns earlier,
                         double tightest, double t)
    : solver_(solver),
      solution_(std::move(solution)),
      earlier_(std::move(earlier)),
      tightest_(tightest),
      tolerance_(std::max(earlier_.tolerance, tightest)),
      t_(t),
      load_scales_(load_scales_of(solution_.discretisation)) {
  if (earlier_.loads.cols() == 0) earlier_.t = t;
  if (solution_.system->is_factorised()) return;  // back substitutions need no guesses
  const Configuration& configuration = solution_.instant.configuration;
  const Eigen::MatrixXcd guesses =
      earlier_.densities.guess(0.0, configuration, solution_.discretisation);
  for (Index i = 0; i < earlier_.loads.cols(); ++i) {
    const VectorXd at_bodies = earlier_.loads.col(i);
    const SparseVector<double> load = rotate_forces(at_bodies, configuration, 1.0).sparseView();
    earlier_columns_.push_back({.load = load,
                                .scaled_load = load_scales_.asDiagonal() * load,
                                .density = guesses.col(i),
                                .rhs_norm = earlier_.rhs_norms[i]});
  }
}

FoundColumns LoadColumns::find(const SparseMatrix<double>& loads) {
  const SparseMatrix<double> scaled_loads = load_scales_.asDiagonal() * loads;
  const VectorXd angles = smallest_angles(scaled_loads);
  const std::size_t known = columns_.size();
  FoundColumns found;
  for (Index j = 0; j < loads.cols(); ++j) {
    const std::size_t column = find_or_add({loads.col(j), scaled_loads.col(j), {}});
    const bool has_changed = solve_to_tolerance(columns_[column], angles[j]);
    found.solved_again |= has_changed && column < known;
    found.columns.push_back(column);
  }
  return found;
}

StokesProblem LoadColumns::problem_under(const SparseVector<double>& load) const {
  StokesProblem problem = solution_.system->problem();
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

// The singularities of the few bodies on which a load acts are summed directly, unless they have
// images.
ComplexVector LoadColumns::rhs_under(const SparseVector<double>& load) const {
  const StokesProblem problem = problem_under(load);
  const Closure closure(problem);
  if (!problem.cell) return closure.right_hand_side();
  const ComplexVector none = ComplexVector::Zero(node_offsets(problem).back());
  return -FastSum(problem, solver_.plan().sum_tolerance).velocity(none, closure.given_loads());
}

void LoadColumns::reuse_similar(LoadColumn& column) const {
  const LoadColumn* nearest = nullptr;
  double most = 0.0;
  for (const std::vector<LoadColumn>& known : {std::cref(columns_), std::cref(earlier_columns_)}) {
    for (const LoadColumn& other : known) {
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

void LoadColumns::solve_by_factors(LoadColumn& column) const {
  const ComplexVector rhs = rhs_under(column.load);
  column.density = deinterleaved(solution_.system->precondition(interleaved(rhs)));
  column.tolerance = tightest_;
  complete(column, rhs.norm());
}

// The motions of free bodies are functionals of the density; they do not depend on the load.
void LoadColumns::complete(LoadColumn& column, double rhs_norm) const {
  column.rhs_norm = rhs_norm;
  column.motions = solution_.system->system.closure().complete(column.density).motions;
}

GmresResult LoadColumns::solve(const ComplexVector& rhs, double tolerance,
                               const ComplexVector& guess) {
  const GmresOptions options{tolerance, solver_.scene().solver.gmres_max_iterations};
  GmresResult result = stokesbook::solve(*solution_.system, rhs, options, guess);
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

std::size_t LoadColumns::find_or_add(LoadColumn column) {
  const auto known = std::ranges::find_if(columns_, [&](const LoadColumn& other) {
    return (column.scaled_load - other.scaled_load).norm() <= same_load * column.scaled_load.norm();
  });
  if (known != columns_.end()) return static_cast<std::size_t>(known - columns_.begin());
  if (solution_.system->is_factorised()) {
    solve_by_factors(column);
  } else {
    reuse_similar(column);
  }
  columns_.push_back(std::move(column));
  return columns_.size() - 1;
}

// Nearly parallel loads, of two contact points in one flat gap, require a tolerance that is tighter
// in proportion to the angle between them. Returns whether the column has changed.
bool LoadColumns::solve_to_tolerance(LoadColumn& column, double angle) {
  if (column.tolerance <= std::max(tightest_, angle * tolerance_)) return false;
  column.tolerance = std::max(tightest_, angle * std::min(tolerance_, most_solved_tolerance));
  const ComplexVector rhs = rhs_under(column.load);
  const GmresResult result = solve(rhs, column.tolerance, column.density);
  column.density = deinterleaved(result.solution);
  complete(column, rhs.norm());
  return result.iterations > 0;
}

void LoadColumns::correct(std::size_t column, const ComplexVector& change, double tolerance) {
  LoadColumn& corrected = columns_[column];
  corrected.tolerance = std::max(corrected.tolerance, tolerance);
  corrected.density += change;
  complete(corrected, corrected.rhs_norm);
}

ComplexVector LoadColumns::expected_change(const SparseVector<double>& load) const {
  if (elapsed() == 0.0 || earlier_.drift.load.size() == 0) return {};
  const Configuration& configuration = solution_.instant.configuration;
  const VectorXd drifting =
      load_scales_.asDiagonal() * rotate_forces(earlier_.drift.load, configuration, 1.0);
  const double part =
      drifting.dot(load_scales_.asDiagonal() * VectorXd(load)) / drifting.squaredNorm();
  return elapsed() * part *
         earlier_.drift.density.guess(0.0, configuration, solution_.discretisation);
}

void LoadColumns::remember_change(const SparseVector<double>& load, const ComplexVector& change) {
  if (elapsed() == 0.0) return;
  const Configuration& configuration = solution_.instant.configuration;
  earlier_.drift.load = rotate_forces(load, configuration, -1.0);
  earlier_.drift.density.add(0.0, configuration, solution_.discretisation, change / elapsed());
  earlier_.t = t_;
}

bool LoadColumns::tighten() {
  if (tolerance_ <= tightest_) return false;
  tolerance_ = std::max(tightest_, tightening * tolerance_);
  return true;
}

MobilityColumns LoadColumns::for_next_configuration() const {
  if (columns_.empty()) return earlier_;
  const Configuration& configuration = solution_.instant.configuration;
  const Index m = std::ssize(columns_);
  Eigen::MatrixXcd densities(columns_.front().density.size(), m);
  MobilityColumns result{MatrixXd(columns_.front().load.size(), m), VectorXd(m)};
  for (Index i = 0; i < m; ++i) {
    const LoadColumn& column = columns_[static_cast<std::size_t>(i)];
    result.loads.col(i) = rotate_forces(column.load, configuration, -1.0);
    result.rhs_norms[i] = column.rhs_norm;
    densities.col(i) = column.density;
  }
  result.densities.add(0.0, configuration, solution_.discretisation, std::move(densities));
  result.tolerance = std::min(MobilityColumns::most_tolerance, loosening * tolerance_);
  result.t = t_;
  result.drift = earlier_.drift;
  return result;
}

}  // namespace stokesbook
