// Estimates a mean with its standard error and Student's 95 % confidence interval.
#include "sweep/estimate.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gsl/gsl_cdf.h>

namespace stokesbook {

Estimate estimate_mean(std::span<const double> values) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {undefined, undefined, undefined};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() == 1) return {mean, undefined, undefined};
  // Standard error e = sqrt(sum_k (x_k - m)^2 / (n (n - 1))), half width t_{n-1}(0.975) e.
  double squares = 0.0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const double standard_error = std::sqrt(squares / (n * (n - 1.0)));
  return {mean, standard_error, gsl_cdf_tdist_Pinv(0.975, n - 1.0) * standard_error};
}

}  // namespace stokesbook
