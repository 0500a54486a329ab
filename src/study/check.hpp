#pragma once

#include <span>
#include <string>
#include <vector>

#include "study/claim.hpp"
#include "study/measurement.hpp"

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// How a claim fared. Too few points to tell is no success.
enum class Outcome {
  holds,        ///< the measured number lies in the band
  fails,        ///< it does not
  inconclusive  ///< fewer than three points in the window
};

/// Names an outcome.
///
/// @param  outcome  of a check
/// @return          "holds", "fails" or "inconclusive"
std::string to_string(Outcome outcome);

/// A claim held against measurements.
struct Verdict {
  Outcome outcome = Outcome::inconclusive;  ///< whether the claim holds
  double measured = unmeasured;  ///< order, rate, level or largest error, as the law has it
  double constant = unmeasured;  ///< C of the fitted law, where one was fitted
  std::string explanation;       ///< a line for people
  std::vector<bool> used;        ///< for each measurement: whether the check rests on it
};

/// Holds a claim against measurements.
///
/// A fit of order or rate is a least-squares line through the logarithms of the points that lie in
/// the window and at least ten times above its floor.
/// @param  claim         law and window
/// @param  measurements  ascending in x
/// @return               never Outcome::holds with fewer than three points, nor with an error that
///                       is not finite
Verdict check(const Claim& claim, std::span<const Measurement> measurements);

/// Computes the order between successive points, \f$ -\log(e_i/e_{i-1})/\log(x_i/x_{i-1}) \f$.
///
/// @param  measurements  ascending in x
/// @return  as many as measurements; the first, and those next to a zero, are unmeasured
std::vector<double> local_orders(std::span<const Measurement> measurements);

/// Computes the rate between successive points, \f$ -\log(e_i/e_{i-1})/(x_i-x_{i-1}) \f$.
///
/// @param  measurements  ascending in x
/// @return  as local_orders()
std::vector<double> local_rates(std::span<const Measurement> measurements);

/// @}

}  // namespace stokesbook::study
