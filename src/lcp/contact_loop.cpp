#include "lcp/contact_loop.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

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

struct Multipliers {
  LcpResult solution;
  int rays = 0;
};

Multipliers solve(const LinearProblem& problem, const ContactStep& step, const LcpSolver& solver,
                  const VectorXd& guess) {
  const VectorXd free_opening = step.dt * (problem.gradient * step.free_velocity);
  LcpProblem lcp{problem.matrix, problem.clearance + free_opening};
  const LcpOptions options{.guess = guess};
  Multipliers result{solver(lcp, options)};
  //! [clip]
  if (result.solution.status == LcpStatus::ray) {
    ++result.rays;
    lcp.offset = problem.clearance.cwiseMax(0.0) + free_opening;
    result.solution = solver(lcp, options);
  }
  //! [clip]
  if (result.solution.status != LcpStatus::solved) result.solution = fischer_newton(lcp, options);
  return result;
}

// Least gap of each contact of `keys`, by the rows as they are now.
VectorXd gaps_now(const std::vector<ContactKey>& keys, const ContactRows& rows) {
  std::map<std::int64_t, double> least;
  for (Index i = 0; i < rows.gap.size(); ++i) {
    const auto [entry, first] =
        least.emplace(rows.keys[static_cast<std::size_t>(i)].contact, rows.gap[i]);
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

// Of the gaps across which a force acts, the widest; none: -1.
Index widest_with_force(const ContactResult& result, double tolerance) {
  Index widest = -1;
  for (Index i = 0; i < result.gaps.size(); ++i) {
    if (result.response[i] * result.multipliers[i] <= tolerance) continue;
    if (widest < 0 || result.gaps[i] > result.gaps[widest]) widest = i;
  }
  return widest;
}

std::string name(const ContactKey& key) {
  return "contact " + std::to_string(key.contact) + ", point " + std::to_string(key.point);
}

ContactResult given_up(ContactResult result, ContactStatus status, const std::string& reason) {
  result.status = status;
  result.reason = reason;
  return result;
}

ContactResult response_not_seen(ContactResult result, Index i) {
  std::ostringstream reason;
  reason << name(result.keys[static_cast<std::size_t>(i)]) << ": a unit force opens its own gap by "
         << result.response[i]
         << ", which must be positive: the quadrature does not resolve the gap, or nothing there "
            "can move";
  return given_up(std::move(result), ContactStatus::response_not_seen, reason.str());
}

ContactResult no_linear_solution(ContactResult result, const LcpResult& solution) {
  std::ostringstream reason;
  reason << "the linear problem of iteration " << result.iterations << " with "
         << result.keys.size() << " rows was not solved: its residual is " << solution.residual;
  return given_up(std::move(result), ContactStatus::no_linear_solution, reason.str());
}

ContactResult open_gap(ContactResult result, Index i) {
  std::ostringstream reason;
  reason << name(result.keys[static_cast<std::size_t>(i)]) << ": the force "
         << result.multipliers[i] << " acts across a gap of " << result.gaps[i]
         << " beyond the separation after " << result.iterations << " iterations";
  return given_up(std::move(result), ContactStatus::open_gap, reason.str());
}

ContactResult not_converged(ContactResult result, const ContactRows& rows) {
  Index worst = 0;
  std::ostringstream reason;
  rows.gap.minCoeff(&worst);
  reason << name(rows.keys[static_cast<std::size_t>(worst)]) << ": the gap is " << rows.gap[worst]
         << " beyond the separation after " << result.iterations << " iterations";
  return given_up(std::move(result), ContactStatus::not_converged, reason.str());
}

}  // namespace

ContactResult resolve_contact(const ContactStep& step, const ContactLoopOptions& options) {
  require_valid(step);
  ContactResult result;
  result.velocity = step.free_velocity;
  result.force = VectorXd::Zero(step.free_velocity.size());
  ContactRows rows = rows_at(step, result.velocity);
  result.violations.push_back(violation(rows));
  result.kkt_residual = result.violations.back();
  if (result.violations.back() <= step.tolerance) {
    result.status = ContactStatus::resolved;
    return result;
  }
  Cuts earlier;
  while (result.iterations < options.max_iterations) {
    ++result.iterations;
    Cuts cuts = linearised(rows, result.velocity, step.dt);
    Cuts now = violated(rows, cuts, step.tolerance);
    if (result.iterations > options.cuts_after) cuts.insert(earlier.begin(), earlier.end());
    now.merge(earlier);
    earlier = std::move(now);

    const LinearProblem problem = linear_problem(cuts, step);
    result.columns += static_cast<int>(problem.keys.size());
    const VectorXd guess = matched(result, problem.keys);
    result.keys = problem.keys;
    result.force_gradient = problem.force_gradient;
    result.response = problem.matrix.diagonal();
    for (Index i = 0; i < result.response.size(); ++i) {
      if (!(result.response[i] > 0.0)) return response_not_seen(result, i);
    }

    const auto [solution, rays] = solve(problem, step, options.solver, guess);
    result.rays += rays;
    if (solution.status != LcpStatus::solved) return no_linear_solution(result, solution);
    result.multipliers = solution.z;
    result.force = problem.force_gradient.transpose() * solution.z;
    result.velocity = step.free_velocity + problem.velocities * solution.z;
    result.power = result.force.dot(result.velocity);

    rows = rows_at(step, result.velocity);
    result.gaps = gaps_now(result.keys, rows);
    result.violations.push_back(violation(rows));
    const Index widest = widest_with_force(result, step.tolerance);
    const double open = widest < 0 ? 0.0 : result.gaps[widest];
    result.kkt_residual = std::max(result.violations.back(), open);
    const bool violates = result.violations.back() > step.tolerance;
    const bool pushes = open > options.open_gap * step.separation;
    if (!violates && !pushes) {
      result.status = ContactStatus::resolved;
      return result;
    }
    if (!violates && (result.iterations >= options.open_gap_after ||
                      result.iterations == options.max_iterations)) {
      return open_gap(result, widest);
    }
  }
  return not_converged(result, rows);
}

}  // namespace stokesbook
