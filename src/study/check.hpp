#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/claim.hpp"
#include "study/measurement.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// The outcome of a check. A check with too few points is not a success.
enum class Outcome {
  holds,        ///< the measured number lies in the band
  fails,        ///< the measured number lies outside, or an error is not finite
  inconclusive  ///< fewer than three points in the window
};

/// Returns the name of an outcome.
///
/// @param  outcome  outcome of a check
/// @return          "holds", "fails" or "inconclusive"
std::string to_string(Outcome outcome);

/// The result of a check of a claim against measurements.
struct Verdict {
  Outcome outcome = Outcome::inconclusive;  ///< whether the claim holds
  double measured = unmeasured;  ///< order, rate, level or largest error, depending on the law
  double constant = unmeasured;  ///< C of the fitted law, if a law was fitted
  std::string explanation;       ///< the measured and the claimed number in one line of text
  std::vector<bool> used;        ///< for each measurement: whether the check used it
};

/// Checks a claim against measurements.
///
/// Orders and rates are slopes of the least-squares line through the logarithms of the errors. The
/// fit uses only points in the window whose errors are at least ten times the floor of the window.
/// @param  claim         law and window
/// @param  measurements  ascending in x
/// @return               the verdict; its outcome is never Outcome::holds with fewer than three
///                       points, or with an error that is not finite
Verdict check(const Claim& claim, std::span<const Measurement> measurements);

/// Computes the order between successive points, \f$ -\log(e_i/e_{i-1})/\log(x_i/x_{i-1}) \f$.
///
/// @param  measurements  ascending in x
/// @return  one order for each measurement; not a number for the first, and where one of the two
///          errors is zero
std::vector<double> local_orders(std::span<const Measurement> measurements);

/// Computes the rate between successive points, \f$ -\log(e_i/e_{i-1})/(x_i-x_{i-1}) \f$.
///
/// @param  measurements  ascending in x
/// @return  rates, in the form of local_orders()
std::vector<double> local_rates(std::span<const Measurement> measurements);

/// @}

}  // namespace stokesbook::study
