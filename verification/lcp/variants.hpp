#pragma once

#include <functional>

#include "support/contact_scenes.hpp"

/// Contains naive and published methods for comparison with the library. Some of these methods are
/// wrong.
namespace stokesbook::verification::lcp {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Tries all 2^m sets of contacts, the empty one first.
/// @return  `iterations` counts the sets; the status is stalled for more than 12 rows, or if no set
///          gives a solution
LcpResult try_all_sets(const LcpProblem& problem);

/// Solves M z = -q, and sets negative entries to zero.
VectorXd clipped_equation(const LcpProblem& problem);

/// Returns z after sweeps from zero that set z_i to max(0, z_i - w_i / M_ii). If `in_turn`, w_i
/// uses the new z of the earlier rows (Gauss-Seidel), otherwise the old z of all rows (Jacobi).
VectorXd swept(const LcpProblem& problem, int sweeps, bool in_turn);

/// Returns the radius r of a pair (z_i, w_i) in Fischer's Jacobian, which has the entries z_i/r - 1
/// and w_i/r - 1 (11.8).
using Radius = std::function<double(double z, double w)>;
double true_radius(double z, double w);       ///< sqrt(z^2 + w^2)
double published_radius(double z, double w);  ///< sqrt(z + w), a misprint

/// Returns z after steps of Newton's method for Fischer's functions, without scaling, line search
/// or regularisation.
VectorXd bare_fischer(const LcpProblem& problem, VectorXd z, const Radius& radius, int steps);

/// Returns z after a Newton step in which the rows with z > 0 are the contacts.
VectorXd step_by_sign_of_z(const LcpProblem& problem, const VectorXd& z);

/// Holds the result of the loop in increments.
struct Increments {
  VectorXd velocity;
  double residual = 0.0;  ///< largest violation of a gap, or largest gap across which a force acts
};

/// Solves the contact step by a nonlinear loop that adds increments to the multipliers. Each
/// increment is >= 0, so the loop never reduces a multiplier.
Increments increments(const ContactStep& step, int iterations);

}  // namespace stokesbook::verification::lcp
