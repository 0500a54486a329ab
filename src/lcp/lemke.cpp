// Solves a linear complementarity problem by Lemke's complementary pivoting along (11.4), with the
// lexicographic rule for ties, and finds rays (11.5) (section "Pivots" of chapter 11).
#include "lcp/lemke.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <Eigen/LU>

#include "lcp/scaled_problem.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int side_changes = 40;    // at most so many indices change sides after pivoting
constexpr double rounding = 1e-15;  // rounding errors of z and w, in units in which max |q_i| = 1
constexpr double smallest_pivot = 1e-11;  // relative to the largest entry of its column
constexpr double tie = 1e-13;             // relative to the largest of the compared numbers

// The linear system w - M z - e t = q (11.4), solved for the basic variables:
// basic + rows nonbasic = values. Variables are numbered w_0 .. w_{m-1}, z_0 .. z_{m-1}, t; the
// artificial variable is t.
class Tableau {
 public:
  explicit Tableau(const LcpProblem& problem)
      : m_{problem.offset.size()},
        basic_(static_cast<std::size_t>(m_)),
        nonbasic_(static_cast<std::size_t>(m_ + 1)),
        rows_(m_, m_ + 1),
        values_{problem.offset} {
    std::iota(basic_.begin(), basic_.end(), Index{0});
    std::iota(nonbasic_.begin(), nonbasic_.end(), m_);
    rows_ << -problem.matrix, VectorXd::Constant(m_, -1.0);
  }

  Index artificial() const { return 2 * m_; }
  Index complement(Index variable) const { return variable < m_ ? variable + m_ : variable - m_; }
  Index basic(Index row) const { return basic_[static_cast<std::size_t>(row)]; }
  const VectorXd& values() const { return values_; }

  Index column_of(Index variable) const {
    return std::ranges::find(nonbasic_, variable) - nonbasic_.begin();
  }

  // Returns by how much each basic variable falls when a nonbasic variable grows by one.
  VectorXd fall(Index variable) const { return rows_.col(column_of(variable)); }

  // Performs the ratio test with the lexicographic rule: among the rows whose divisor is positive
  // beyond rounding, returns the row for which (value, row of the inverse basis) / divisor is
  // lexicographically least; -1 if there is no such row. If the artificial variable's
  // value / divisor ties with the least one, its row is returned.
  Index leaving_row(const VectorXd& divisor) const {
    const double least = smallest_pivot * divisor.cwiseAbs().maxCoeff();
    std::vector<Index> rows;
    for (Index i = 0; i < m_; ++i) {
      if (divisor[i] > least) rows.push_back(i);
    }
    if (rows.empty()) return -1;
    keep_least(rows, divisor, values_);
    for (const Index row : rows) {
      if (basic(row) == artificial()) return row;
    }
    for (Index j = 0; j < m_ && rows.size() > 1; ++j) keep_least(rows, divisor, inverse_column(j));
    return rows.front();
  }

  // Exchanges the basic variable of the row with the nonbasic one.
  void pivot(Index row, Index column) {
    const double by = rows_(row, column);
    const VectorXd fall = rows_.col(column);
    rows_.row(row) /= by;
    values_[row] /= by;
    rows_(row, column) = 1.0 / by;
    for (Index i = 0; i < m_; ++i) {
      if (i == row) continue;
      rows_(i, column) = 0.0;
      if (fall[i] == 0.0) continue;
      rows_.row(i) -= fall[i] * rows_.row(row);
      values_[i] -= fall[i] * values_[row];
    }
    std::swap(basic_[static_cast<std::size_t>(row)], nonbasic_[static_cast<std::size_t>(column)]);
  }

 private:
  // Returns a column of the inverse basis: the column of w_j in the tableau.
  VectorXd inverse_column(Index j) const {
    const auto row = std::ranges::find(basic_, j);
    if (row == basic_.end()) return rows_.col(column_of(j));
    return VectorXd::Unit(m_, row - basic_.begin());
  }

  // Keeps those rows whose v / divisor is least, up to ties.
  static void keep_least(std::vector<Index>& rows, const VectorXd& divisor, const VectorXd& v) {
    double least = std::numeric_limits<double>::infinity(), size = 0.0;
    for (const Index row : rows) {
      least = std::min(least, v[row] / divisor[row]);
      size = std::max(size, std::abs(v[row]));
    }
    std::erase_if(rows, [&](Index row) { return v[row] - least * divisor[row] > tie * size; });
  }

  Index m_;
  std::vector<Index> basic_, nonbasic_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_;
  VectorXd values_;
};

// Returns z from a number for each row: nonbasic z are zero.
VectorXd basic_z(const Tableau& tableau, const VectorXd& numbers) {
  const Index m = numbers.size();
  VectorXd z = VectorXd::Zero(m);
  for (Index i = 0; i < m; ++i) {
    const Index variable = tableau.basic(i);
    if (variable >= m && variable != tableau.artificial()) z[variable - m] = numbers[i];
  }
  return z;
}

// Returns the set A of indices whose z is basic.
std::vector<Index> active_set(const Tableau& tableau, Index m) {
  std::vector<Index> active;
  for (Index i = 0; i < m; ++i) {
    if (tableau.basic(i) >= m) active.push_back(tableau.basic(i) - m);
  }
  return active;
}

// Solves M_AA z_A = -q_A, and solves once more for the residual that rounding left.
VectorXd solve_active(const LcpProblem& problem, const std::vector<Index>& active) {
  const Eigen::PartialPivLU<MatrixXd> lu(problem.matrix(active, active));
  VectorXd z = VectorXd::Zero(problem.offset.size());
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd left = problem.offset + problem.matrix * z;
    z(active) -= lu.solve(left(active));
  }
  return z;
}

// Returns the index of the most negative number among z_i for i in the active set and w_i for all
// other i; -1 if none is negative beyond rounding.
Index worst_index(const std::vector<Index>& active, const VectorXd& z, const VectorXd& w) {
  VectorXd numbers = w;
  numbers(active) = z(active);
  Index worst = -1;
  return numbers.minCoeff(&worst) < -rounding ? worst : -1;
}

// Solves afresh for the active set that pivoting found, so that the rounding errors of pivots drop
// out. If M_AA is badly conditioned, pivoting may have put an index with z = w = 0 on the wrong
// side of the active set: such indices change sides, the worst index first.
LcpResult polish(const ScaledLcp& scaled, const Tableau& tableau, double tolerance) {
  LcpResult best = make_result(scaled, basic_z(tableau, tableau.values()), tolerance);
  std::vector<Index> active = active_set(tableau, scaled.problem.offset.size());
  for (int change = 0; change < side_changes && !active.empty(); ++change) {
    const VectorXd z = solve_active(scaled.problem, active);
    const LcpResult result = make_result(scaled, z, tolerance);
    if (!std::isfinite(result.residual)) break;  // M_AA is singular
    if (result.residual < best.residual) best = result;
    const Index worst = worst_index(active, z, scaled.problem.offset + scaled.problem.matrix * z);
    if (worst < 0) break;
    if (std::erase(active, worst) == 0) active.push_back(worst);
  }
  return best;
}

// Follows (11.4) from large t: pivots until t leaves the basis or the path ends in a ray (11.5).
LcpResult follow_path(const ScaledLcp& scaled, const LcpOptions& options) {
  const Index m = scaled.problem.offset.size();
  const int most = options.max_iterations.value_or(50000 + 20 * static_cast<int>(m));
  Tableau tableau(scaled.problem);
  Index entering = tableau.artificial();
  Index row = tableau.leaving_row(VectorXd::Ones(m));
  int pivots = 0;
  while (row >= 0 && pivots < most) {
    const Index leaving = tableau.basic(row);
    tableau.pivot(row, tableau.column_of(entering));
    ++pivots;
    if (leaving == tableau.artificial()) {
      LcpResult result = polish(scaled, tableau, options.tolerance);
      result.iterations = pivots;
      return result;
    }
    entering = tableau.complement(leaving);
    row = tableau.leaving_row(tableau.fall(entering));
  }
  LcpResult result = make_result(scaled, basic_z(tableau, tableau.values()), options.tolerance);
  result.iterations = pivots;
  result.status = row < 0 ? LcpStatus::ray : LcpStatus::stalled;
  if (row < 0) {
    // No basic variable falls: along the ray the entering z grows by one, the basic z by -fall.
    result.ray = basic_z(tableau, -tableau.fall(entering)).cwiseMax(0.0);
    if (entering >= m) result.ray[entering - m] = 1.0;
    result.ray = result.ray.cwiseProduct(scaled.scaling.scale);
  }
  return result;
}

}  // namespace

LcpResult lemke(const LcpProblem& problem, const LcpOptions& options) {
  const ScaledLcp scaled = scale_problem(problem);
  const Index m = scaled.problem.offset.size();
  if (m == 0 || scaled.problem.offset.minCoeff() >= 0.0) {
    return make_result(scaled, VectorXd::Zero(m), options.tolerance);
  }
  return follow_path(scaled, options);
}

}  // namespace stokesbook
