#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "study/claim.hpp"

namespace stokesbook::study {

/// The value of a quantity that was not measured.
inline constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

/// A measurement of an experiment: the varied quantity, the error, and the costs.
struct Measurement {
  double x = 0.0;                  ///< the varied quantity: nodes, distance, tolerance
  double error = 0.0;              ///< in the norm and unit that the experiment names, >= 0
  double unknowns = unmeasured;    ///< size of the system or number of samples
  double operations = unmeasured;  ///< counted: kernel evaluations, matrix-vector products
  double seconds = unmeasured;     ///< for diagrams only: no claim is about seconds
};

/// The outcome of a check. A check with too few points is not a success.
enum class Outcome {
  holds,        ///< the measured number lies in the band
  fails,        ///< the measured number lies outside, or an error is not finite
  inconclusive  ///< fewer than three points in the window
};

/// Returns the name of an outcome: "holds", "fails" or "inconclusive".
std::string to_string(Outcome outcome);

/// The result of a check of a claim against measurements.
struct Verdict {
  Outcome outcome = Outcome::inconclusive;  ///< whether the claim holds
  double measured = unmeasured;  ///< order, rate, level or largest error, depending on the law
  std::string explanation;       ///< the measured and the claimed number in one line of text
  std::vector<bool> used;        ///< for each measurement: whether the check used it
};

/// Checks a claim against measurements, which ascend in x.
///
/// Orders and rates are slopes of the least-squares line through the logarithms of the errors. The
/// fit uses only points in the window whose errors are at least ten times the floor of the window.
/// The outcome is never Outcome::holds with fewer than three points, or with an error that is not
/// finite.
Verdict check(const Claim& claim, std::span<const Measurement> measurements);

/// Computes the order between successive points, \f$ -\log(e_i/e_{i-1})/\log(x_i/x_{i-1}) \f$.
/// @return  one order for each measurement; not a number for the first, and where one of the two
///          errors is zero
std::vector<double> local_orders(std::span<const Measurement> measurements);

/// Computes the rate between successive points, \f$ -\log(e_i/e_{i-1})/(x_i-x_{i-1}) \f$, in the
/// form of local_orders().
std::vector<double> local_rates(std::span<const Measurement> measurements);

}  // namespace stokesbook::study
