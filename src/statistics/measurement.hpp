#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "sweep/results.hpp"

namespace stokesbook {

/// Quantities that are functions of one variable, as means over the written times of a run.
struct Measurement {
  std::string name;                                   ///< "pair_correlation"
  std::string variable;                               ///< "r"
  std::vector<double> at;                             ///< values of the variable
  std::vector<std::string> quantities = {};           ///< names of the quantities
  std::vector<std::vector<MeanEstimate>> means = {};  ///< for each quantity, one for each value
  bool is_logarithmic = false;                        ///< whether plots have a logarithmic x axis

  /// Adds a quantity from its values at m written times, m x n for n values of the variable.
  void add(const std::string& quantity, const std::vector<double>& t,
           const Eigen::MatrixXd& values);
};

/// Estimates a mean as mean_over_time() does over all times; the mean of a single time has no
/// error.
MeanEstimate mean_of_all(const std::vector<double>& t, std::span<const double> values);

/// Writes a table: a column for the variable, and columns for mean, standard error and 95 %
/// confidence interval of each quantity.
std::string to_csv(const Measurement& measurement);

/// Plots a quantity and its confidence interval over the variable, as SVG.
std::string draw(const Measurement& measurement, std::size_t quantity);

}  // namespace stokesbook
