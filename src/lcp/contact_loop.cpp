#include "lcp/contact_loop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "lcp/fischer_newton.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using SparseRow = Eigen::SparseVector<double, Eigen::RowMajor>;

// A linearised gap: clearance + dt gradient . U >= 0.
struct Cut {
  double clearance = 0.0;
  SparseRow gradient, force_gradient;
};

// Of all gaps of a linear problem. A map: one for each point, the last one.
using Cuts = std::map<ContactKey, Cut>;

void require_valid(const ContactStep& step) {
  if (!(step.dt > 0.0) || !(step.tolerance > 0.0)) {
    std::ostringstream message;
    message << "contact needs a time step and a tolerance > 0, not " << step.dt << " and "
            << step.tolerance;
    throw std::invalid_argument(message.str());
  }
}

ContactRows rows_at(const ContactStep& step, const VectorXd& velocity) {
  ContactRows rows = step.rows(velocity);
  if (rows.force_gradient.size() == 0) rows.force_gradient = rows.gradient;
  const Index m = rows.gap.size(), n = velocity.size();
  const auto fits = [&](const GapGradient& gradient) {
    return gradient.rows() == m && (m == 0 || gradient.cols() == n);
  };
  if (!fits(rows.gradient) || !fits(rows.force_gradient) ||
      static_cast<Index>(rows.keys.size()) != m) {
    throw std::invalid_argument("gaps, their gradients and their keys differ in number");
  }
  if (!rows.gap.allFinite()) throw std::domain_error("a gap is not finite");
  return rows;
}

Cuts linearised(const ContactRows& rows, const VectorXd& velocity, double dt) {
  const VectorXd clearance = rows.gap - dt * (rows.gradient * velocity);
  Cuts cuts;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const ContactKey key = rows.keys[static_cast<std::size_t>(i)];
    const Cut cut{clearance[i], rows.gradient.row(i), rows.force_gradient.row(i)};
    if (!cuts.emplace(key, cut).second) {
      throw std::invalid_argument("two rows of contact " + std::to_string(key.contact) +
                                  " are point " + std::to_string(key.point));
    }
  }
  return cuts;
}

Cuts violated(const ContactRows& rows, const Cuts& cuts, double tolerance) {
  Cuts result;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const ContactKey key = rows.keys[static_cast<std::size_t>(i)];
    if (rows.gap[i] < -tolerance) result.emplace(key, cuts.at(key));
  }
  return result;
}

double violation(const ContactRows& rows) {
  return rows.gap.size() == 0 ? 0.0 : std::max(0.0, -rows.gap.minCoeff());
}

// The linear problem of an iteration, and what its solution means.
struct LinearProblem {
  std::vector<ContactKey> keys;
  VectorXd clearance;
  GapGradient gradient, force_gradient;
  MatrixXd velocities;  // B J_f^T
  MatrixXd matrix;      // N
};

LinearProblem linear_problem(const Cuts& cuts, const ContactStep& step) {
  const auto m = static_cast<Index>(cuts.size());
  const Index n = step.free_velocity.size();
  LinearProblem problem{{}, VectorXd(m), GapGradient(m, n), GapGradient(m, n), {}, {}};
  Index i = 0;
  for (const auto& [key, cut] : cuts) {
    problem.keys.push_back(key);
    problem.clearance[i] = cut.clearance;
    problem.gradient.row(i) = cut.gradient;
    problem.force_gradient.row(i) = cut.force_gradient;
    ++i;
  }
  problem.velocities = step.respond(problem.force_gradient.transpose());
  if (problem.velocities.rows() != n || problem.velocities.cols() != m) {
    throw std::invalid_argument("the response to forces has another size than the forces");
  }
  problem.matrix = step.dt * (problem.gradient * problem.velocities);
  return problem;
}

// Multipliers of an earlier iteration where the points are the same, zero elsewhere.
VectorXd matched(const ContactResult& earlier, const std::vector<ContactKey>& keys) {
  std::map<ContactKey, double> known;
  for (std::size_t i = 0; i < earlier.keys.size(); ++i) {
    known[earlier.keys[i]] = earlier.multipliers[static_cast<Index>(i)];
  }
  VectorXd result = VectorXd::Zero(static_cast<Index>(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (const auto found = known.find(keys[i]); found != known.end()) {
      result[static_cast<Index>(i)] = found->second;
    }
  }
  return result;
}

// Least gap of each contact of `keys`, by the rows as they are now.
VectorXd gaps_now(const std::vector<ContactKey>& keys, const ContactRows& rows) {
  std::map<std::int64_t, double> least;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const std::int64_t contact = rows.keys[static_cast<std::size_t>(i)].contact;
    const auto [entry, first] = least.emplace(contact, rows.gap[i]);
    if (!first) entry->second = std::min(entry->second, rows.gap[i]);
  }
  VectorXd gaps(static_cast<Index>(keys.size()));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto found = least.find(keys[i].contact);
    gaps[static_cast<Index>(i)] =
        found == least.end() ? std::numeric_limits<double>::infinity() : found->second;
  }
  return gaps;
}

class ContactLoop {
 public:
  ContactLoop(const ContactStep& step, const ContactLoopOptions& options)
      : step_{step}, options_{options} {
    result_.force = VectorXd::Zero(step.free_velocity.size());
    move_to(step.free_velocity);
  }

  ContactResult run() {
    bool ended = settled();
    const bool guessed = step_.guess.size() > 0 && options_.max_iterations > 0;
    if (!ended && guessed) rows_ = rows_at(step_, result_.velocity = step_.guess);
    while (!ended && !diverges() && result_.iterations < options_.max_iterations) {
      ++result_.iterations;
      const Cuts cuts = next_cuts();
      do {
        ended = !apply(linear_problem(cuts, step_)) || settled();
      } while (ended && is_refined());
    }
    if (!ended) give_up_on_violation();
    return result_;
  }

 private:
  void move_to(const VectorXd& velocity) {
    result_.velocity = velocity;
    rows_ = rows_at(step_, velocity);
    result_.violations.push_back(violation(rows_));
    result_.gaps = gaps_now(result_.keys, rows_);
  }

  // Whether an iterate is farther off than the free motion ever was: the next would be farther
  // still, and its long paths take long to follow.
  bool diverges() const {
    const double allowed = std::max(result_.violations.front(), step_.separation);
    return result_.violations.back() > options_.divergence * allowed;
  }

  // Whether the response has become more exact for the forces that resolve contact.
  bool is_refined() const {
    return result_.status == ContactStatus::resolved && step_.refine &&
           step_.refine(result_.multipliers);
  }

  // The rows as they are now, and those that were violated before where some still are later in the
  // loop: where none is, they would only hold gaps open, as their linearisations are old.
  Cuts next_cuts() {
    Cuts cuts = linearised(rows_, result_.velocity, step_.dt);
    Cuts now = violated(rows_, cuts, step_.tolerance);
    rows_come_back_ |= result_.iterations > options_.cuts_after && !now.empty();
    if (rows_come_back_) cuts.insert(violated_.begin(), violated_.end());
    now.merge(violated_);
    violated_ = std::move(now);
    return cuts;
  }

  // Moves to the solution of the linear problem; false where there is none to be had.
  bool apply(const LinearProblem& problem) {
    const VectorXd guess = matched(result_, problem.keys);
    result_.keys = problem.keys;
    result_.force_gradient = problem.force_gradient;
    result_.response = problem.matrix.diagonal();
    result_.multipliers = VectorXd::Zero(result_.response.size());
    result_.gaps = gaps_now(problem.keys, rows_);
    result_.columns += static_cast<int>(problem.keys.size());
    for (Index i = 0; i < result_.response.size(); ++i) {
      if (!(result_.response[i] > 0.0)) return give_up_on_response(i);
    }
    const LcpResult solution = solve(problem, guess);
    if (solution.status != LcpStatus::solved) return give_up_on_linear_problem(solution);
    result_.multipliers = solution.z;
    result_.force = problem.force_gradient.transpose() * solution.z;
    move_to(step_.free_velocity + problem.velocities * solution.z);
    result_.power = result_.force.dot(result_.velocity);
    return true;
  }

  LcpResult solve(const LinearProblem& problem, const VectorXd& guess) {
    const VectorXd free_opening = step_.dt * (problem.gradient * step_.free_velocity);
    const LcpOptions options{.guess = guess};
    LcpProblem lcp{problem.matrix, problem.clearance + free_opening};
    LcpResult solution = options_.solver(lcp, options);
    //! [clip]
    if (solution.status == LcpStatus::ray) {
      ++result_.rays;
      lcp.offset = problem.clearance.cwiseMax(0.0) + free_opening;
      solution = options_.solver(lcp, options);
    }
    //! [clip]
    return solution.status == LcpStatus::solved ? solution : fischer_newton(lcp, options);
  }

  // Resolved, or given up because of a force across an open gap. Gaps with a force are closed to
  // the tolerance; where that takes too long, less is enough.
  bool settled() {
    const Index widest = widest_with_force();
    const double open = widest < 0 ? 0.0 : result_.gaps[widest];
    result_.kkt_residual = std::max(result_.violations.back(), uncomplementary_gap());
    if (result_.violations.back() > step_.tolerance) return false;
    const int last = std::min(options_.open_gap_after, options_.max_iterations);
    const bool closed = open <= step_.tolerance;
    if (!closed && result_.iterations < last) return false;
    if (!closed && open > options_.open_gap * step_.separation) return give_up_on_open_gap(widest);
    result_.status = ContactStatus::resolved;
    return true;
  }

  // Of all rows the largest part of complementarity that is left, as a length.
  double uncomplementary_gap() const {
    if (result_.gaps.size() == 0) return 0.0;
    const VectorXd opened = result_.response.cwiseProduct(result_.multipliers);
    return std::max(0.0, result_.gaps.cwiseMin(opened).maxCoeff());
  }

  // Of the gaps across which a force acts, the widest; none: -1.
  Index widest_with_force() const {
    Index widest = -1;
    for (Index i = 0; i < result_.gaps.size(); ++i) {
      if (result_.response[i] * result_.multipliers[i] <= step_.tolerance) continue;
      if (widest < 0 || result_.gaps[i] > result_.gaps[widest]) widest = i;
    }
    return widest;
  }

  std::string name(const ContactKey& key) const {
    if (step_.name) return step_.name(key);
    return "contact " + std::to_string(key.contact) + ", point " + std::to_string(key.point);
  }

  std::string name(Index i) const { return name(result_.keys[static_cast<std::size_t>(i)]); }

  bool give_up_on_response(Index i) {
    std::ostringstream reason;
    reason << name(i) << ": a unit force opens its own gap by " << result_.response[i]
           << ", which must be positive: the quadrature does not resolve the gap, or nothing there "
              "can move";
    result_.status = ContactStatus::response_not_seen;
    result_.reason = reason.str();
    return false;
  }

  bool give_up_on_linear_problem(const LcpResult& solution) {
    std::ostringstream reason;
    reason << "the linear problem of iteration " << result_.iterations << " with "
           << result_.keys.size() << " rows was not solved, its residual is " << solution.residual
           << ":";
    for (Index i = 0; i < result_.response.size(); ++i) {
      reason << (i == 0 ? " " : ", ") << name(i) << " (a unit force opens its own gap by "
             << result_.response[i] << ")";
    }
    result_.status = ContactStatus::no_linear_solution;
    result_.reason = reason.str();
    return false;
  }

  bool give_up_on_open_gap(Index i) {
    std::ostringstream reason;
    reason << name(i) << ": the force " << result_.multipliers[i] << " acts across ";
    if (std::isinf(result_.gaps[i])) {
      reason << "a contact that is gone";
    } else {
      reason << "a gap of " << result_.gaps[i] << " beyond the separation";
    }
    reason << " after " << result_.iterations << " iterations; a unit force opens it by "
           << result_.response[i];
    result_.status = ContactStatus::open_gap;
    result_.reason = reason.str();
    return true;
  }

  void give_up_on_violation() {
    std::map<std::int64_t, Index> worst;  // row of each contact
    for (Index i = 0; i < rows_.gap.size(); ++i) {
      if (rows_.gap[i] >= -step_.tolerance) continue;
      const auto [row, first] = worst.emplace(rows_.keys[static_cast<std::size_t>(i)].contact, i);
      if (!first && rows_.gap[i] < rows_.gap[row->second]) row->second = i;
    }
    std::ostringstream reason;
    reason << "the separation is violated after " << result_.iterations << " iterations:";
    const char* before = " ";
    for (const auto& [contact, row] : worst) {
      const ContactKey& key = rows_.keys[static_cast<std::size_t>(row)];
      reason << std::exchange(before, ", ") << name(key) << " by " << -rows_.gap[row];
      const auto known = std::ranges::find(result_.keys, key);
      if (known == result_.keys.end()) continue;
      reason << " (a unit force opens it by " << result_.response[known - result_.keys.begin()]
             << ")";
    }
    result_.status = ContactStatus::not_converged;
    result_.reason = reason.str();
  }

  const ContactStep& step_;
  const ContactLoopOptions& options_;
  ContactResult result_;
  ContactRows rows_;             // at the velocity of the result
  Cuts violated_;                // in earlier iterations
  bool rows_come_back_ = false;  // of these
};

}  // namespace

ContactResult resolve_contact(const ContactStep& step, const ContactLoopOptions& options) {
  require_valid(step);
  return ContactLoop(step, options).run();
}

}  // namespace stokesbook
