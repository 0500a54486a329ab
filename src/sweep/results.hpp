#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sweep/sweep.hpp"
#include "sweep/task.hpp"

namespace stokesbook {

/// Averages a function of time over an interval: the integral of its piecewise linear interpolant
/// (the trapezoid rule), divided by the length of the interval.
///
/// Before the first time the function is taken to have its first value, since `steps.csv` has no
/// row at t = 0.
/// @param  t  times, ascending, at least one
/// @throws std::invalid_argument when the interval ends after the last time
/// @par Accuracy  exact if the function is linear between the times
double time_average(std::span<const double> t, std::span<const double> y, double from, double to);

/// The mean of independent runs and its uncertainty.
struct MeanEstimate {
  double mean;            ///< nan without runs
  double standard_error;  ///< standard error of the mean; nan with fewer than two runs
  double interval;        ///< half the width of Student's 95 % confidence interval; nan as above
};

/// Estimates the mean of the distribution from which independent values are drawn.
///
/// With n values of mean m, the standard error is
/// \f$ e = \sqrt{\sum_k (x_k - m)^2 / (n (n - 1))} \f$. If the values are normally distributed, the
/// interval \f$ m \pm t_{n-1}(0.975)\, e \f$ contains the true mean in 95 of 100 cases, where
/// \f$ t_{n-1} \f$ is the quantile function of Student's distribution with n - 1 degrees of
/// freedom.
MeanEstimate estimate_mean(std::span<const double> values);

/// Estimates the mean of a stationary function of time by its time_average() over an interval, and
/// the error of this estimate from the correlation of the function with itself.
///
/// The interval is divided into 32 blocks of equal length, or into one block for each of fewer
/// times in it. Their averages \f$ x_k \f$ are almost independent if blocks are much longer than
/// the time of correlation. What is left is described by the correlation \f$ \rho \f$ of
/// neighbours: n blocks count as \f$ m = n (1 - \rho) / (1 + \rho) \f$ independent ones, the
/// standard error is \f$ e = \sqrt{\sum_k (x_k - \bar x)^2 / ((n - 1) m)} \f$, and the interval is
/// \f$ t_{m-1}(0.975)\, e \f$. The estimate of \f$ \rho \f$ includes the correction of its bias.
/// @return  nan errors with fewer than 8 times in the interval
/// @throws std::invalid_argument as time_average() does
/// @par Accuracy  intervals contain the mean in 91 to 98 of 100 cases if the interval has at least
///                six times the correlation time, the integral of the correlation function
/// @sa source: Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989), 461, for blocks; Schmeiser, Oper.
///             Res. 30 (1982), 556, for their number; Marriott and Pope, Biometrika 41 (1954), 390,
///             for the bias
MeanEstimate mean_over_time(std::span<const double> t, std::span<const double> y, double from,
                            double to);

/// Reads a quantity from the tables in the folder of a run that is done; nan if the scene does not
/// define the quantity. An average has the errors of mean_over_time(), all other reductions have
/// none.
///
/// @throws RecordError when the table cannot be read, has no row of the body or wall, or ends too
///         early
MeanEstimate value_of(const std::filesystem::path& run, const Quantity& quantity);

/// The results of all runs with one combination of the axes' values.
struct ResultRow {
  std::vector<std::string> values;  ///< one for each column of the axes, in TOML's syntax
  int runs = 0;                     ///< number of runs that are done
  int failed = 0;                   ///< number of runs whose last attempt ended with an error
  int unfinished = 0;               ///< number of runs not begun, under way, or killed
  /// One for each quantity: over the runs that are done, or over the time of a single one.
  std::vector<MeanEstimate> estimates;
};

/// Collects the quantities of all runs that are done from the folder of a sweep.
///
/// @param   tasks  the tasks by their places, as open_sweep() returns them
/// @return  one row for each combination; the last axis varies fastest
/// @throws RecordError when the tables of a run that is done are damaged or end too early
std::vector<ResultRow> collect(const std::filesystem::path& out, const Sweep& sweep,
                               std::span<const Task> tasks);

/// Writes results as `results.csv`: columns of the axes, `runs,failed,unfinished`, and columns_of()
/// each quantity, with 17 digits.
std::string to_csv(const Sweep& sweep, const std::vector<ResultRow>& rows);

/// Writes results for the terminal in aligned columns: mean +- half the width of the 95 %
/// confidence interval.
std::string to_text(const Sweep& sweep, const std::vector<ResultRow>& rows);

}  // namespace stokesbook
