// Defines complementarity problems whose solution is known, and a problem without a solution.
#include <cmath>

#include "hard_case.hpp"
#include "lcp/lemke.hpp"
#include "lcp/newton.hpp"
#include "support/lcp_solvers.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

constexpr double pivoting_tolerance = 1e-9;

/// Solves by pivoting. The error is the error of z if z is unique, otherwise the error of
/// w = q + M z. The matrix M is symmetric and semidefinite, so that w is unique. Both errors are
/// independent of the units of rows.
Finding solve_by_pivoting(const PlantedLcp& lcp) {
  const auto& [matrix, offset] = lcp.problem;
  const LcpResult found = lemke(lcp.problem);
  Finding finding{.tolerance = pivoting_tolerance};
  if (!solved(found)) {
    finding.refusal = "not solved";
    return finding;
  }
  const VectorXd error = found.z - lcp.z, scale = matrix.diagonal().cwiseSqrt();
  finding.error =
      lcp.unique
          ? largest(error.cwiseProduct(scale)) / largest(lcp.z.cwiseProduct(scale))
          : largest((matrix * error).cwiseQuotient(scale)) / largest(offset.cwiseQuotient(scale));
  return finding;
}

/// Scales the rows to other units, over twelve decades.
PlantedLcp scaled(const PlantedLcp& lcp) {
  const Index m = lcp.z.size();
  const VectorXd scale = VectorXd::NullaryExpr(m, [=](Index i) {
    return std::pow(10.0, -12.0 * static_cast<double>(i) / static_cast<double>(m - 1));
  });
  return in_other_units(lcp, scale);
}

/// Poses two contacts that must both open, although the force at each contact closes the other
/// contact: there is no solution.
Finding without_solution() {
  const LcpProblem problem{matrix2(1.0, -1.0, -1.0, 1.0), vector2(-1.0, -1.0)};
  const LcpResult found = lemke(problem);
  if (solved(found)) return {.tolerance = pivoting_tolerance, .error = 0.0};
  const bool is_proof = found.status == LcpStatus::ray && proves_no_solution(found.ray, problem);
  return {.refusal = is_proof ? "no solution: the path ends in a ray, which proves it"
                              : "the path ends without a proof"};
}

}  // namespace

std::vector<HardCase> problems() {
  const auto solving = [](const std::string& asked, const PlantedLcp& lcp) {
    return HardCase{"11", asked, [=] { return solve_by_pivoting(lcp); }};
  };
  const PlantedLcp hilbert = planted("", hilbert_matrix(12), 4, false),
                   chain_of_400{"", chain(400), VectorXd::Ones(400), true},
                   definite = planted("", definite_matrix(50, 1), 1, true);
  return {solving("complementarity with Hilbert's matrix of 12 rows; gaps", hilbert),
          solving("with Murty's matrix of 10 rows, on which pivoting takes its longest way",
                  {"", murty(10), VectorXd::Unit(10, 0), true}),
          solving("with a chain of 400 contacts pushed at both ends", chain_of_400),
          solving("with 50 rows in units from 1 to 1e-12", scaled(definite)),
          solving("with every contact twice, but for 1e-6; gaps",
                  planted("", near_duplicates(definite_matrix(20, 5)), 5, false)),
          solving("with four times as many contacts as motions; gaps",
                  planted("", semidefinite_matrix(200, 50, 2), 2, false)),
          {"11",
           "two contacts that no forces can open both",
           without_solution,
           Due::refusal,
           {"no solution", "proves"}}};
}

}  // namespace stokesbook::verification::hard_cases
