#pragma once

#include <span>

namespace stokesbook {

/// @addtogroup sweep
/// @{

/// The mean of independent runs and its uncertainty.
struct Estimate {
  double mean;            ///< nan without runs
  double standard_error;  ///< of the mean; nan with fewer than two runs
  double interval;        ///< half the width of Student's 95 % confidence interval; nan as above
};

/// Estimates the mean of the distribution from which values are drawn.
///
/// With n values of mean m, the standard error is
/// \f$ e = \sqrt{\sum_k (x_k - m)^2 / (n (n - 1))} \f$. If the values are normally distributed, the
/// interval \f$ m \pm t_{n-1}(0.975)\, e \f$ contains the true mean in 95 of 100 cases, where
/// \f$ t_{n-1} \f$ is the quantile function of Student's distribution with n - 1 degrees of
/// freedom.
/// @param  values  independent values
/// @return         the estimate, in the unit of the values
Estimate estimate_mean(std::span<const double> values);

/// @}

}  // namespace stokesbook
