#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace stokesbook::study {

/// @name Laws for the errors e at the points x
/// A band around a known number has two sides, since a method that is better than its theory is not
/// understood. Errors that are zero up to rounding, and orders that grow without bound, have a
/// bound on one side.
/// @{

/// Algebraic convergence, \f$ e = C x^{-p} \f$.
struct Algebraic {
  double order;        ///< p
  double band = 0.15;  ///< largest deviation of the fitted order
};

/// Geometric convergence, \f$ e = C x^q e^{-\alpha x} \f$.
struct Geometric {
  double rate;         ///< \f$ \alpha \f$, determined by the nearest singularity
  double band = 0.05;  ///< largest relative deviation of the fitted rate
  double power = 0.0;  ///< q, known from theory
};

/// Superalgebraic convergence: the order between successive points grows beyond every bound.
struct Superalgebraic {
  double order;  ///< least order between the last two points
};

/// The errors lie at a known level.
struct Floor {
  double level;          ///< level of the errors, > 0
  double factor = 10.0;  ///< the median lies within level / factor and level * factor
};

/// The errors are zero in exact arithmetic, or zero up to the digits of a printed value.
struct Identity {
  double tolerance;  ///< largest error anywhere
};

/// The value is at most a bound, such as a number of iterations or the share of another method's
/// work.
struct AtMost {
  double bound;  ///< largest value anywhere
};

/// Cost in counted operations, \f$ \mathrm{operations} = C x^p \f$.
struct Cost {
  double order;        ///< p
  double band = 0.05;  ///< largest deviation of the fitted order
};

/// The error e meets the requested tolerance x. A lower bound of e / x excludes methods that meet
/// the tolerance by doing far too much work.
struct ErrorBelowTolerance {
  double most;   ///< largest e / x anywhere
  double least;  ///< smallest e / x anywhere
};

/// @}

/// The law of a claim.
using Law = std::variant<Algebraic, Geometric, Superalgebraic, Floor, Identity, AtMost, Cost,
                         ErrorBelowTolerance>;

/// The range of x for which a law is claimed. Points outside are shown, but not checked.
struct Window {
  double from = 0.0;                                    ///< smallest x
  double to = std::numeric_limits<double>::infinity();  ///< largest x
  double floor = 0.0;  ///< level of rounding; a fit leaves out errors below ten times the floor
};

/// A claim, which is stated before anything is measured.
struct Claim {
  std::string id;         ///< chapter and number, "02_1"; the page's anchor is claim_02_1
  std::string statement;  ///< the claim in one sentence
  Law law;                ///< the claimed law
  Window window = {};     ///< range of x for which the law is claimed
  std::string reason;     ///< source of the law's numbers
  std::vector<std::string> api = {};  ///< Doxygen's names of what the claim is about
};

/// Returns a law as text, such as "error = C N^-2".
/// @param  axis  name of the varied quantity, with its letter last: "nodes N"
std::string law_text(const Law& law, const std::string& axis);

/// Returns the number that a law claims, with which Verdict::measured is compared: order, rate,
/// level, tolerance or bound; for errors that grow, their power.
double claimed_number(const Law& law);

}  // namespace stokesbook::study
