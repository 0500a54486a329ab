// Averages quantities over time, writes them as a table, and plots them with their intervals.
#include "statistics/measurement.hpp"

#include <cmath>
#include <limits>

#include "study/plot.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

MeanEstimate mean_of_all(const std::vector<double>& t, std::span<const double> values) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  if (t.size() == 1) return {values[0], undefined, undefined};
  return mean_over_time(t, values, t.front(), t.back());
}

void Measurement::add(const std::string& quantity, const std::vector<double>& t,
                      const Eigen::MatrixXd& values) {
  quantities.push_back(quantity);
  means.emplace_back();
  for (Eigen::Index bin = 0; bin < values.cols(); ++bin) {
    means.back().push_back(mean_of_all(t, {values.col(bin).data(), t.size()}));
  }
}

std::string to_csv(const Measurement& measurement) {
  std::string text = measurement.variable;
  for (const std::string& name : measurement.quantities) {
    text += "," + name + "," + name + "_standard_error," + name + "_interval";
  }
  for (std::size_t bin = 0; bin < measurement.at.size(); ++bin) {
    text += '\n' + exact_number(measurement.at[bin]);
    for (const auto& means : measurement.means) {
      const auto& [mean, standard_error, interval] = means[bin];
      for (const double number : {mean, standard_error, interval})
        text += ',' + exact_number(number);
    }
  }
  return text + '\n';
}

std::string draw(const Measurement& measurement, std::size_t quantity) {
  const std::string& name = measurement.quantities[quantity];
  study::Plot plot{.title = name,
                   .x_label = measurement.variable,
                   .y_label = name,
                   .log_x = measurement.is_logarithmic,
                   .log_y = false,
                   .lines = {{"mean and 95 % confidence interval"}}};
  for (std::size_t bin = 0; bin < measurement.at.size(); ++bin) {
    const auto& [mean, standard_error, interval] = measurement.means[quantity][bin];
    if (!std::isfinite(mean)) continue;
    plot.lines[0].points.push_back(
        {.x = measurement.at[bin], .y = mean, .error = std::isfinite(interval) ? interval : 0.0});
  }
  return study::draw_plot(plot);
}

}  // namespace stokesbook
