#pragma once

#include <span>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// The mean of independent runs, and how well they determine it.
struct Estimate {
  double mean;            ///< nan without runs
  double standard_error;  ///< of the mean; nan with fewer than two runs
  double interval;        ///< half the width of Student's 95 % confidence interval; nan likewise
};

/// Estimates the mean of the distribution that values are drawn from.
///
/// With n values of mean m, the standard error is
/// \f$ e = \sqrt{\sum_k (x_k - m)^2 / (n (n - 1))} \f$, and where they are normally distributed,
/// \f$ m \pm t_{n-1}(0.975)\, e \f$ holds the true mean in 95 of 100 cases, with the quantile of
/// Student's distribution of n - 1 degrees of freedom.
/// @param  values  independent
/// @return         the estimate, in their unit
Estimate estimate_mean(std::span<const double> values);

/// @}

}  // namespace stokesbook
