#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/SparseCore>

#include "lcp/lemke.hpp"

namespace stokesbook {

/// @addtogroup lcp
/// @{

/// Names a row: the same from iteration to iteration while it is the same point.
struct ContactKey {
  std::int64_t contact = 0;  ///< two bodies, and the place where they meet
  std::int64_t point = 0;    ///< one of the contact's points
  /// Compares contacts, then points.
  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

/// Derivatives of gaps with respect to velocities, a row for each gap.
using GapGradient = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Gaps g at the end of a step with the velocity U, as far as they matter: all that are violated,
/// and those that are small; none between bodies of which neither can move.
struct ContactRows {
  Eigen::VectorXd gap;   ///< g(U), m lengths; less than 0 violates the separation
  GapGradient gradient;  ///< J, m x n, with \f$ dg = \Delta t\, J\, dU \f$
  GapGradient
      force_gradient{};  ///< J_f, m x n: forces are \f$ J_f^T \lambda \f$; 0 x 0: as the gradient
  std::vector<ContactKey> keys;  ///< m names, none twice
};

/// A step without contact, and what contact needs to know of geometry and flow.
struct ContactStep {
  Eigen::VectorXd free_velocity;  ///< U*, n velocities
  double dt = 0.0;                ///< length of the step, > 0
  double separation = 0.0;        ///< least distance between bodies, from which gaps count
  double tolerance = 0.0;         ///< of gaps, a length > 0
  std::function<ContactRows(const Eigen::VectorXd&)> rows;  ///< U -> rows
  /// Forces, n x m, -> the velocities that they add, B times them. B must be the same in all calls
  /// of a step until it is refined, and symmetric; where discretisation leaves it not quite so,
  /// (B + B^T)/2.
  std::function<Eigen::MatrixXd(const Eigen::SparseMatrix<double>&)> respond;
  /// Where respond() is cheap and coarse: the multipliers of its latest columns, m numbers ->
  /// whether it answers them more exactly from now on. Asked when all else is resolved; then the
  /// latest linear problem is solved once more. Empty: never.
  std::function<bool(const Eigen::VectorXd&)> refine{};
  /// Velocity at which gaps are linearised first where U* violates some, such as that of the step
  /// before; empty: U*.
  Eigen::VectorXd guess{};
  /// Names the bodies of a row in reasons; empty: contacts and points are shown by their numbers.
  std::function<std::string(const ContactKey&)> name{};
};

/// When the loop gives up, and with what it solves.
struct ContactLoopOptions {
  int max_iterations = 8;    ///< linear problems
  int open_gap_after = 6;    ///< iterations after which a force across an open gap is given up
  double open_gap = 0.1;     ///< in units of the separation: a gap that is open
  double divergence = 10.0;  ///< in units of the separation, or of the violation at U* if that is
                             ///< larger: a violation after which the loop gives up
  int cuts_after = 4;        ///< iterations after which rows violated earlier come back, if some
                             ///< still are
  LcpSolver solver = lemke;  ///< of the linear problems; where it fails, fischer_newton()
};

/// How the loop ended.
enum class ContactStatus {
  resolved,           ///< no gap is violated, and no force acts across an open gap
  not_converged,      ///< gaps were violated to the last iteration
  open_gap,           ///< a force acts across an open gap
  response_not_seen,  ///< a gap does not open under its own force: not resolved by the quadrature
  no_linear_solution  ///< neither solver solved the linear problem
};

/// Velocity with contact, and what it took.
struct ContactResult {
  ContactStatus status = ContactStatus::not_converged;  ///< how the loop ended
  std::string reason{};            ///< unless resolved: why it gave up, with contacts and numbers
  Eigen::VectorXd velocity;        ///< U, n velocities; where not resolved, of the last iterate
  Eigen::VectorXd multipliers{};   ///< lambda >= 0 of the rows, forces; 0 where they were not found
  std::vector<ContactKey> keys{};  ///< of the rows
  GapGradient force_gradient{};    ///< J_f of the rows
  Eigen::VectorXd response{};      ///< N_ii of the rows, length / force
  Eigen::VectorXd gaps{};   ///< at U: least gap of each row's contact; infinite where it is gone
  Eigen::VectorXd force{};  ///< \f$ J_f^T \lambda \f$, n forces and torques on the bodies
  double power = 0.0;       ///< of these forces
  /// Length: the largest violation, or \f$ \min(g_i, N_{ii}\lambda_i) \f$ where that is larger: the
  /// gap across which a force acts, or what the force opens if that is less.
  double kkt_residual = 0.0;
  int iterations = 0;  ///< linear problems
  int columns = 0;     ///< columns of response asked for
  int rays = 0;        ///< linear problems that had no solution as they were
  std::vector<double>
      violations{};  ///< largest violation at U*, and after each iteration, lengths >= 0
};

/// Finds the velocity U with
/// \f$ U = U^* + B J_f^T \lambda, \quad 0 \le g(U) \perp \lambda \ge 0 \f$.
///
/// At each iterate U_k the gaps are replaced by \f$ g_k + \Delta t\, J (U - U_k) \f$, which leaves
/// the linear problem \f$ 0 \le b + N \lambda \perp \lambda \ge 0 \f$ with
/// \f$ N = \Delta t\, J B J_f^T,\ b = c + \Delta t\, J U^*,\ c = g_k - \Delta t\, J U_k \f$. Its
/// unknown is the total multiplier, not an increment: a force of an earlier iteration vanishes
/// where it is no longer needed.
///
/// c is the gap that the linearisation gives U = 0. Where c >= 0, as it is for a gap along a
/// straight path, U = 0 violates nothing, so that with J_f = J there is a solution,
/// \f$ |U|_{B^{-1}} \le |U^*|_{B^{-1}} \f$, and the power of contact is
/// \f$ -\lambda \cdot c / \Delta t \le 0 \f$. Where the linear problem ends in a ray, max(c, 0)
/// takes the place of c. Gaps themselves are never clipped: the result is accepted only when all of
/// rows(U) are at least -tolerance.
///
/// Where rows are still violated after some iterations, those that were violated earlier and whose
/// points are no longer among rows(U_k) come back with their last linearisation. Without them,
/// points that take turns at being the deepest never agree.
///
/// Force and gap belong together by ContactKey::contact: a force counts (its effect on its own gap,
/// \f$ N_{ii} \lambda_i \f$, is more than the tolerance) as across an open gap when no row of its
/// contact at U has a gap below the bound, or none is left.
/// @param  step     to resolve
/// @param  options  limits and solver
/// @return          a result for every step: resolved, or the reason why it is not
/// @throws std::invalid_argument when sizes do not agree, or dt or the tolerance is not positive
/// @throws std::domain_error when a number is not finite
/// @par Accuracy    gaps to the tolerance, @ref claim_11_16; an iteration multiplies the error of U
///                  by something in proportion to the depth of the free motion, @ref claim_11_14,
///                  and squares it where J_f does not depend on U, @ref claim_11_15
/// @par Cost        at most max_iterations + 1 calls of rows, and one more with a guess;
///                  max_iterations of respond; one more of both each time that the response is
///                  refined
/// @sa source: Josephy, Newton's method for generalized equations, MRC report 1965 (1979)
ContactResult resolve_contact(const ContactStep& step, const ContactLoopOptions& options = {});

/// @}

}  // namespace stokesbook
