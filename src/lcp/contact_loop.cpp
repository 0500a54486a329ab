// Finds the velocity of a step with contact (11.9) by Newton's method: at each iterate the gaps are
// linearised, and a linear complementarity problem (11.10) gives the total contact forces.
#include "lcp/contact_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "lcp/newton.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The loop gives up when the violation exceeds this factor times the separation, or times the
// violation at U* if that is larger.
constexpr double divergence = 10.0;

using SparseRow = Eigen::SparseVector<double, Eigen::RowMajor>;

// The linear constraint clearance + dt gradient . U >= 0, with c of (11.10) for the clearance, and
// the gap at the velocity of the linearisation.
struct LinearisedGap {
  double gap, clearance, at_rest;
  SparseRow gradient, force_gradient;
};

// The linearised gaps of a linear problem. Each point has one gap, from its latest linearisation.
using LinearisedGaps = std::map<ContactKey, LinearisedGap>;

// Joins texts and numbers.
std::string joined(const auto&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

// Throws std::invalid_argument with a message unless a condition is met.
void require(bool is_met, const auto&... message) {
  if (!is_met) throw std::invalid_argument(joined(message...));
}

std::string contact_point(const ContactKey& key) {
  return joined("contact ", key.contact, ", point ", key.point);
}

// Evaluates the rows at a velocity, and checks their sizes.
ContactRows evaluate_rows(const ContactStep& step, const VectorXd& velocity) {
  ContactRows rows = step.rows(velocity);
  if (rows.force_gradient.size() == 0) rows.force_gradient = rows.gradient;
  if (rows.at_rest.size() == 0) rows.at_rest = VectorXd::Zero(rows.gap.size());
  const Index m = rows.gap.size(), n = velocity.size();
  const auto fits = [&](const GapGradient& gradient) {
    return gradient.rows() == m && (m == 0 || gradient.cols() == n);
  };
  require(fits(rows.gradient) && fits(rows.force_gradient) && std::ssize(rows.keys) == m &&
              rows.at_rest.size() == m,
          m, " gaps have gradients of ", rows.gradient.rows(), " x ", rows.gradient.cols(),
          " (forces ", rows.force_gradient.rows(), " x ", rows.force_gradient.cols(), "), ",
          rows.keys.size(), " keys and ", rows.at_rest.size(), " changes at rest");
  for (Index i = 0; i < m; ++i) {
    if (std::isfinite(rows.gap[i])) continue;
    throw std::domain_error("the gap of " + contact_point(rows.keys[static_cast<std::size_t>(i)]) +
                            " is not finite");
  }
  return rows;
}

// Linearises the gaps at the velocity U_k: c = g_k - dt J_k U_k (11.10).
LinearisedGaps linearise(const ContactRows& rows, const VectorXd& velocity, double dt) {
  const VectorXd clearance = rows.gap - dt * (rows.gradient * velocity);
  LinearisedGaps gaps;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const ContactKey key = rows.keys[static_cast<std::size_t>(i)];
    const LinearisedGap gap{rows.gap[i], clearance[i], rows.at_rest[i], rows.gradient.row(i),
                            rows.force_gradient.row(i)};
    require(gaps.emplace(key, gap).second, "two rows have the same key: ", contact_point(key));
  }
  return gaps;
}

// Returns the largest violation, a length >= 0.
double violation(const ContactRows& rows) {
  return rows.gap.size() == 0 ? 0.0 : std::max(0.0, -rows.gap.minCoeff());
}

// The linear problem (11.10) of an iteration, and the velocities that unit forces cause.
struct LinearProblem {
  std::vector<ContactKey> keys;
  VectorXd clearance, at_rest;
  GapGradient gradient, force_gradient;
  MatrixXd velocities;  // B J_f^T
  MatrixXd matrix;      // N
};

// Assembles N = dt J B J_f^T (11.10).
LinearProblem assemble_problem(const LinearisedGaps& gaps, const ContactStep& step) {
  const auto m = static_cast<Index>(gaps.size());
  const Index n = step.free_velocity.size();
  LinearProblem problem{{}, VectorXd(m), VectorXd(m), GapGradient(m, n), GapGradient(m, n), {}, {}};
  Index i = 0;
  for (const auto& [key, gap] : gaps) {
    problem.keys.push_back(key);
    problem.clearance[i] = gap.clearance;
    problem.at_rest[i] = gap.at_rest;
    problem.gradient.row(i) = gap.gradient;
    problem.force_gradient.row(i) = gap.force_gradient;
    ++i;
  }
  problem.velocities = step.respond(problem.force_gradient.transpose());
  require(problem.velocities.rows() == n && problem.velocities.cols() == m, "respond() returned ",
          problem.velocities.rows(), " x ", problem.velocities.cols(), " velocities for ", n, " x ",
          m, " forces");
  problem.matrix = step.dt * (problem.gradient * problem.velocities);
  return problem;
}

// Returns for each key the least gap of its contact among the current rows; infinity if the contact
// has no row.
VectorXd find_least_gaps(const std::vector<ContactKey>& keys, const ContactRows& rows) {
  std::map<std::int64_t, double> least;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const std::int64_t contact = rows.keys[static_cast<std::size_t>(i)].contact;
    double& gap = least.emplace(contact, rows.gap[i]).first->second;
    gap = std::min(gap, rows.gap[i]);
  }
  return VectorXd::NullaryExpr(std::ssize(keys), [&](Index i) {
    const auto found = least.find(keys[static_cast<std::size_t>(i)].contact);
    return found == least.end() ? std::numeric_limits<double>::infinity() : found->second;
  });
}

// Returns the largest min(g_i, N_ii lambda_i), the length by which rows miss complementarity: the
// gap across which a force acts, or the distance by which the force opens it.
double complementarity_residual(const ContactResult& result) {
  if (result.gaps.size() == 0) return 0.0;
  const VectorXd opened = result.response.cwiseProduct(result.multipliers);
  return std::max(0.0, result.gaps.cwiseMin(opened).maxCoeff());
}

// Returns the row with the widest gap across which a force acts; -1 if no force acts.
Index find_widest_with_force(const ContactResult& result, double tolerance) {
  Index widest = -1;
  for (Index i = 0; i < result.gaps.size(); ++i) {
    if (result.response[i] * result.multipliers[i] <= tolerance) continue;
    if (widest < 0 || result.gaps[i] > result.gaps[widest]) widest = i;
  }
  return widest;
}

// Runs Newton's method for (11.9): solves the linear problem (11.10), moves to its velocity, and
// repeats.
class ContactLoop {
 public:
  ContactLoop(const ContactStep& step, const ContactLoopOptions& options)
      : step_{step}, options_{options}, name_{step.name ? step.name : contact_point} {
    result_.force = VectorXd::Zero(step.free_velocity.size());
    move_to(step.free_velocity);
  }

  ContactResult run() {
    bool ended = is_finished();
    const bool guessed = step_.guess.size() > 0 && options_.max_iterations > 0;
    if (!ended && guessed) rows_ = evaluate_rows(step_, result_.velocity = step_.guess);
    while (!ended && !diverges() && result_.iterations < options_.max_iterations) {
      ++result_.iterations;
      const LinearisedGaps gaps = linearise_gaps();
      do {
        ended = !apply(assemble_problem(gaps, step_)) || is_finished();
      } while (ended && is_refined());
    }
    if (!ended) {
      give_up(ContactStatus::not_converged, "the separation is violated after ", result_.iterations,
              " iterations: ", list_violated_rows());
    }
    return result_;
  }

 private:
  // Makes a velocity the current iterate, and evaluates its rows.
  void move_to(const VectorXd& velocity) {
    result_.velocity = velocity;
    rows_ = evaluate_rows(step_, velocity);
    result_.violations.push_back(violation(rows_));
    result_.gaps = find_least_gaps(result_.keys, rows_);
  }

  // Returns whether the violation is far larger than that of the free motion. The next iterate
  // would be even farther away, and its long paths are expensive to follow.
  bool diverges() const {
    const double allowed = std::max(result_.violations.front(), step_.separation);
    return result_.violations.back() > divergence * allowed;
  }

  // Returns whether refine() has made the response more accurate for the forces that were found.
  bool is_refined() const {
    return result_.status == ContactStatus::resolved && step_.refine &&
           step_.refine(result_.multipliers);
  }

  // Linearises the gaps of the current rows. Once rows are still violated after
  // `restore_rows_after` iterations, the rows that were violated earlier are added with their last
  // linearisation (chapter 11, "Rows that come back"). These rows are not added sooner, because an
  // old linearisation may hold a gap open.
  LinearisedGaps linearise_gaps() {
    LinearisedGaps gaps = linearise(rows_, result_.velocity, step_.dt);
    LinearisedGaps now = gaps;
    std::erase_if(now, [&](const auto& entry) { return entry.second.gap >= -step_.tolerance; });
    restores_rows_ |= result_.iterations > options_.restore_rows_after && !now.empty();
    if (restores_rows_) gaps.insert(violated_.begin(), violated_.end());
    now.merge(violated_);
    violated_ = std::move(now);
    return gaps;
  }

  // Solves the linear problem for lambda, and moves to U = U* + B J_f^T lambda. Returns false if it
  // was not solved.
  bool apply(const LinearProblem& problem) {
    result_.keys = problem.keys;
    result_.force_gradient = problem.force_gradient;
    result_.response = problem.matrix.diagonal();
    result_.multipliers = VectorXd::Zero(result_.response.size());
    result_.gaps = find_least_gaps(problem.keys, rows_);
    result_.columns += static_cast<int>(problem.keys.size());
    for (Index i = 0; i < result_.response.size(); ++i) {
      if (result_.response[i] > 0.0) continue;
      give_up(ContactStatus::response_not_seen, name_row(i), ": a unit force opens its own gap by ",
              result_.response[i],
              ", which must be positive: the quadrature does not resolve the gap (add nodes), or "
              "neither body can move there");
      return false;
    }
    const LcpResult solution = solve(problem);
    if (solution.status != LcpStatus::solved) {
      give_up(ContactStatus::no_linear_solution, "the linear problem of iteration ",
              result_.iterations, " with ", result_.keys.size(),
              " rows was not solved, its residual is ", solution.residual, ": ", list_responses());
      return false;
    }
    result_.multipliers = solution.z;
    result_.force = problem.force_gradient.transpose() * solution.z;
    move_to(step_.free_velocity + problem.velocities * solution.z);
    result_.power = result_.force.dot(result_.velocity);
    return true;
  }

  // Solves (11.10) with the offset b = c + dt J U*.
  LcpResult solve(const LinearProblem& problem) {
    const VectorXd free_opening = step_.dt * (problem.gradient * step_.free_velocity);
    LcpProblem lcp{problem.matrix, problem.clearance + free_opening};
    LcpResult solution = options_.solver(lcp, {});
    // No solution: some c < k is an error of the linearisation. Replace c by max(c, k).
    if (solution.status == LcpStatus::ray) {
      ++result_.rays;
      lcp.offset = problem.clearance.cwiseMax(problem.at_rest) + free_opening;
      solution = options_.solver(lcp, {});
    }
    return solution.status == LcpStatus::solved ? solution : fischer_newton(lcp);
  }

  // Returns whether the loop ends: contact is resolved, or a force acts across an open gap. A gap
  // with a force must be closed to the tolerance; after `open_gap_after` iterations a gap below
  // `open_gap` separations suffices.
  bool is_finished() {
    const Index widest = find_widest_with_force(result_, step_.tolerance);
    const double open = widest < 0 ? 0.0 : result_.gaps[widest];
    result_.kkt_residual = std::max(result_.violations.back(), complementarity_residual(result_));
    if (result_.violations.back() > step_.tolerance) return false;
    const int last = std::min(options_.open_gap_after, options_.max_iterations);
    const bool closed = open <= step_.tolerance;
    if (!closed && result_.iterations < last) return false;
    if (!closed && open > options_.open_gap * step_.separation) {
      give_up(ContactStatus::open_gap, name_row(widest), ": the force ",
              result_.multipliers[widest], " acts across ",
              std::isinf(open) ? "a contact that has no row any more"
                               : joined("a gap of ", open, " beyond the separation"),
              " after ", result_.iterations, " iterations; a unit force opens it by ",
              result_.response[widest]);
    } else {
      result_.status = ContactStatus::resolved;
    }
    return true;
  }

  void give_up(ContactStatus status, const auto&... reason) {
    result_.status = status;
    result_.reason = joined(reason...);
  }

  std::string name_row(Index i) const { return name_(result_.keys[static_cast<std::size_t>(i)]); }

  // Lists all rows, and by how much their own forces open them.
  std::string list_responses() const {
    std::string list;
    for (Index i = 0; i < result_.response.size(); ++i) {
      list += joined(i == 0 ? "" : ", ", name_row(i), " (a unit force opens its own gap by ",
                     result_.response[i], ")");
    }
    return list;
  }

  // Lists the deepest row of each contact that is violated.
  std::string list_violated_rows() const {
    std::map<std::int64_t, Index> worst;  // row with the least gap, for each contact
    for (Index i = 0; i < rows_.gap.size(); ++i) {
      if (rows_.gap[i] >= -step_.tolerance) continue;
      const auto [row, first] = worst.emplace(rows_.keys[static_cast<std::size_t>(i)].contact, i);
      if (!first && rows_.gap[i] < rows_.gap[row->second]) row->second = i;
    }
    std::string list;
    for (const auto& [contact, row] : worst) {
      const ContactKey& key = rows_.keys[static_cast<std::size_t>(row)];
      list += joined(list.empty() ? "" : ", ", name_(key), " by ", -rows_.gap[row]);
      const auto known = std::ranges::find(result_.keys, key);
      if (known == result_.keys.end()) continue;
      list += joined(" (a unit force opens it by ", result_.response[known - result_.keys.begin()],
                     ")");
    }
    return list;
  }

  const ContactStep& step_;
  const ContactLoopOptions& options_;
  std::function<std::string(const ContactKey&)> name_;  // names a row in messages
  ContactResult result_;
  ContactRows rows_;            // at the velocity of the result
  LinearisedGaps violated_;     // linearisations of rows that were violated in earlier iterations
  bool restores_rows_ = false;  // whether the linear problem includes the rows of violated_
};

}  // namespace

ContactResult resolve_contact(const ContactStep& step, const ContactLoopOptions& options) {
  require(step.dt > 0.0 && step.tolerance > 0.0,
          "the contact loop requires a time step and a tolerance > 0, not ", step.dt, " and ",
          step.tolerance);
  return ContactLoop(step, options).run();
}

}  // namespace stokesbook
