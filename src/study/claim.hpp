#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// @name Laws: what a claim says of the errors e at the points x
/// Bands about a known number have two sides: a method that is better than its theory is not
/// understood. One side have what is zero but for rounding, and orders that grow without bound.
/// @{

/// \f$ e = C x^{-p} \f$.
struct Algebraic {
  double order;        ///< p
  double band = 0.15;  ///< largest difference of the fitted order
};

/// \f$ e = C x^q e^{-\alpha x} \f$.
struct Geometric {
  double rate;         ///< \f$ \alpha \f$, of the nearest singularity
  double band = 0.05;  ///< largest relative difference of the fitted rate
  double power = 0.0;  ///< q, known from theory
};

/// The order between successive points grows, and passes every bound.
struct Superalgebraic {
  double order;  ///< least order between the last two points
};

/// The errors lie at a level, which is known.
struct Floor {
  double level;          ///< of the errors, > 0
  double factor = 10.0;  ///< the median lies within level / factor and level * factor
};

/// What is zero in exact arithmetic, or equal to a printed value to its digits.
struct Identity {
  double tolerance;  ///< largest error anywhere
};

/// \f$ \mathrm{operations} = C x^p \f$, in counted operations.
struct Cost {
  double order;        ///< p
  double band = 0.05;  ///< largest difference of the fitted order
};

/// The error asked for, x, is met, and not by doing far too much.
struct ErrorBelowTolerance {
  double most;   ///< largest e / x anywhere
  double least;  ///< smallest e / x anywhere
};

/// @}

/// One of the laws.
using Law =
    std::variant<Algebraic, Geometric, Superalgebraic, Floor, Identity, Cost, ErrorBelowTolerance>;

/// Where a law is claimed. Points outside are shown, and left out of the check.
struct Window {
  double from = 0.0;                                    ///< smallest x
  double to = std::numeric_limits<double>::infinity();  ///< largest x
  double floor = 0.0;  ///< level of rounding: a fit leaves errors below ten times it out
};

/// What is claimed, before anything is measured.
struct Claim {
  std::string id;         ///< chapter and number, "02_1"; the page's anchor is claim_02_1
  std::string statement;  ///< a sentence for people
  Law law;                ///< what holds
  Window window = {};     ///< where it holds
  std::string reason;     ///< where the law's numbers come from
  std::vector<std::string> api =
      {};  ///< what of the library the claim is about, as Doxygen names it
};

/// Returns a law as text, such as "error = C N^-2".
///
/// @param  law   what is claimed
/// @param  axis  name of what is varied, with its letter last: "nodes N"
/// @return       one line
std::string law_text(const Law& law, const std::string& axis);

/// Returns the number that a law claims: order, rate, level, tolerance.
///
/// @param  law  what is claimed
/// @return      the number that Verdict::measured is compared with
double claimed_number(const Law& law);

/// @}

}  // namespace stokesbook::study
