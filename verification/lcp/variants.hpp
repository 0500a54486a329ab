#pragma once

#include <functional>

#include "support/contact_scenes.hpp"

/// What is compared with the library: naive and published methods, some of them wrong.
namespace stokesbook::verification::lcp {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Tries all 2^m sets of contacts, the empty one first.
/// @return  iterations are sets; stalled for more than 12 rows, or when none fits
LcpResult try_all_sets(const LcpProblem& problem);

/// Solves M z = -q, and drops what pulls.
VectorXd clipped_equation(const LcpProblem& problem);

/// z after sweeps from zero that set z_i to max(0, z_i - w_i / M_ii), w_i with the new z of the
/// rows before (`in_turn`), or with the old z of all rows.
VectorXd swept(const LcpProblem& problem, int sweeps, bool in_turn);

/// r of a pair (z_i, w_i) in Fischer's Jacobian, whose entries are z_i/r - 1 and w_i/r - 1.
using Radius = std::function<double(double z, double w)>;
double true_radius(double z, double w);       ///< sqrt(z^2 + w^2)
double published_radius(double z, double w);  ///< sqrt(z + w), a misprint

/// z after steps of Newton's method for Fischer's functions: no units, no search, nothing added.
VectorXd bare_fischer(const LcpProblem& problem, VectorXd z, const Radius& radius, int steps);

/// z after a step that takes rows for contacts wherever z > 0.
VectorXd step_by_sign_of_z(const LcpProblem& problem, const VectorXd& z);

/// What the loop in increments leaves.
struct Increments {
  VectorXd velocity;
  double residual = 0.0;  ///< largest violation, or gap across which a force acts
};

/// The nonlinear loop in increments of the multipliers, each of them >= 0: none is taken back.
Increments increments(const ContactStep& step, int iterations);

}  // namespace stokesbook::verification::lcp
