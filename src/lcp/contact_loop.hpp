#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "lcp/lemke.hpp"

namespace stokesbook {

/// Identifies a row. A row keeps its key from one iteration to the next as long as it belongs to
/// the same point.
struct ContactKey {
  std::int64_t contact = 0;  ///< number of the contact: two bodies and the place where they meet
  std::int64_t point = 0;    ///< number of the point within the contact
  auto operator<=>(const ContactKey&) const = default;  ///< compares contacts, then points
};

/// Derivatives of gaps with respect to velocities, a row for each gap.
using GapGradient = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Gaps g at the end of a step with the velocity U: all violated gaps, and small gaps that may be
/// violated in a later iteration, but no gaps of two bodies neither of which can move.
struct ContactRows {
  Eigen::VectorXd gap;   ///< g(U), m lengths; a negative gap violates the separation
  GapGradient gradient;  ///< J, m x n, with \f$ dg = \Delta t\, J\, dU \f$
  /// J_f, m x n: forces are \f$ J_f^T \lambda \f$; 0 x 0: J_f equals J.
  GapGradient force_gradient{};
  std::vector<ContactKey> keys;  ///< m keys, all different
  Eigen::VectorXd at_rest{};     ///< k, changes of gaps at U = 0 by other motions; empty: none
};

/// A step without contact, with the functions of geometry and flow that resolve_contact() requires.
struct ContactStep {
  Eigen::VectorXd free_velocity;  ///< U*, n velocities
  double dt = 0.0;                ///< length of the step, > 0
  double separation = 0.0;        ///< least distance between bodies, at which gaps are 0; a length
  double tolerance = 0.0;         ///< violation of a gap that is accepted, a length > 0
  std::function<ContactRows(const Eigen::VectorXd&)> rows;  ///< maps U to its rows
  /// Maps forces F, n x m, to the velocities B F that they add. B must be symmetric, and must be
  /// the same in all calls of a step until refine() changes it. If discretisation makes B slightly
  /// unsymmetric, use (B + B^T)/2.
  std::function<Eigen::MatrixXd(const Eigen::SparseMatrix<double>&)> respond;
  /// Improves an inaccurate respond() for the m multipliers of its latest columns, and returns
  /// whether respond() is more accurate from now on. The loop calls refine() when contact is
  /// resolved, and solves the latest linear problem once more if the result is true.
  std::function<bool(const Eigen::VectorXd&)> refine{};
  /// Velocity at which gaps are linearised first if U* violates some of them, for example the
  /// velocity of the step before; empty: U*.
  Eigen::VectorXd guess{};
  /// Returns the name of a row for ContactResult::reason; empty: the numbers of contact and point.
  std::function<std::string(const ContactKey&)> name{};
};

/// Limits of the loop, and the solver of its linear problems.
struct ContactLoopOptions {
  int max_iterations = 8;  ///< largest number of linear problems
  int open_gap_after = 6;  ///< iterations after which the loop ends although a gap with a force
                           ///< is wider than the tolerance: resolved up to open_gap, else failed
  double open_gap = 0.1;   ///< widest gap with a force that is then accepted, relative to the
                           ///< separation
  int restore_rows_after = 4;  ///< iterations after which rows that were violated earlier come back
                               ///< with their last linearisation if some are still violated
  LcpSolver solver = lemke;    ///< for the linear problems; if it fails, fischer_newton() is used
};

/// How the loop ended.
enum class ContactStatus {
  resolved,           ///< no gap is violated, and no force acts across an open gap
  not_converged,      ///< gaps were still violated in the last iteration
  open_gap,           ///< a force acts across an open gap
  response_not_seen,  ///< a gap does not open under its own force: N_ii <= 0 or not a number, for
                      ///< example because the quadrature does not resolve the gap
  no_linear_solution  ///< neither solver solved the linear problem
};

/// Velocity with contact, contact forces, and counts of the work.
struct ContactResult {
  ContactStatus status = ContactStatus::not_converged;  ///< how the loop ended
  std::string reason{};            ///< why the loop failed, with contacts and numbers; else empty
  Eigen::VectorXd velocity;        ///< U, n velocities; the last iterate if not resolved
  Eigen::VectorXd multipliers{};   ///< lambda >= 0 of the rows, forces; 0 if not found
  std::vector<ContactKey> keys{};  ///< keys of the rows of the latest linear problem
  GapGradient force_gradient{};    ///< J_f of these rows
  Eigen::VectorXd response{};      ///< N_ii of these rows, length / force
  Eigen::VectorXd gaps{};  ///< least gap of each row's contact at U; infinite if it has no row at U
  Eigen::VectorXd force{};  ///< \f$ J_f^T \lambda \f$, n forces and torques on the bodies
  double power = 0.0;       ///< power of these forces
  /// Largest violation or largest \f$ \min(g_i, N_{ii}\lambda_i) \f$, whichever is larger, a
  /// length.
  double kkt_residual = 0.0;
  int iterations = 0;  ///< number of iterations, each with a linear problem
  int columns = 0;     ///< number of forces to which respond() was applied
  int rays = 0;        ///< linear problems without a solution, in which max(c, k) replaced c
  /// Largest violation at U*, and after each iteration, lengths >= 0.
  std::vector<double> violations{};
};

/// Finds the velocity U with
/// \f$ U = U^* + B J_f^T \lambda, \quad 0 \le g(U) \perp \lambda \ge 0 \f$ (11.9).
///
/// At each iterate U_k the gaps are replaced by \f$ g_k + \Delta t\, J (U - U_k) \f$, which leads
/// to the linear problem \f$ 0 \le b + N \lambda \perp \lambda \ge 0 \f$ (11.10) with
/// \f$ N = \Delta t\, J B J_f^T,\ b = c + \Delta t\, J U^*,\ c = g_k - \Delta t\, J U_k \f$. The
/// unknown is the total multiplier, not an increment: a force of an earlier iteration vanishes if
/// it is no longer needed.
///
/// c is the linearised gap at U = 0. If c >= 0, as for a gap along a straight path, and J_f = J,
/// there is a solution whose contact forces do no positive work (11.11). If the linear problem ends
/// in a ray, \f$ \max(c, k) \f$ replaces c: k is ContactRows::at_rest, or zero. The gaps themselves
/// are never clipped: the result is accepted only when all gaps of rows(U) are at least -tolerance.
///
/// A force acts if its effect on its own gap, \f$ N_{ii} \lambda_i \f$, exceeds the tolerance. The
/// force acts across an open gap if the least gap of all rows at U with the same
/// ContactKey::contact exceeds the bound, or if the contact has no row at U.
/// @throws std::invalid_argument when sizes do not agree, or dt or the tolerance is not positive
/// @throws std::domain_error when a number is not finite
/// @par Accuracy    gaps to the tolerance, @ref claim_11_16; an iteration multiplies the error of U
///                  by a factor in proportion to the depth of the free motion, @ref claim_11_14,
///                  and squares the error if J_f does not depend on U, @ref claim_11_15
/// @par Cost        at most max_iterations + 1 calls of rows(), and one more with a guess;
///                  max_iterations calls of respond(); one more call of both for each refinement
/// @sa source: Josephy, Newton's method for generalized equations, MRC report 1965 (1979)
ContactResult resolve_contact(const ContactStep& step, const ContactLoopOptions& options = {});

}  // namespace stokesbook
