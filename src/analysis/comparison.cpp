// Compares two runs at their common written times, and judges how their difference grows.
#include "analysis/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Core>
#include <gsl/gsl_statistics_double.h>

#include "record/atomic_file.hpp"
#include "study/plot.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

/// A quantity of a run: one or two columns of a table.
struct Compared {
  const char* name;
  NumberTable Run::*table;
  std::array<const char*, 2> columns;  ///< the second may be null
};

constexpr std::array compared{
    Compared{"positions", &Run::bodies, {"x", "y"}},
    Compared{"angles", &Run::bodies, {"theta"}},
    Compared{"velocities", &Run::bodies, {"ux", "uy"}},
    Compared{"angular_velocities", &Run::bodies, {"omega"}},
    Compared{"forces", &Run::bodies, {"fx", "fy"}},
    Compared{"torques", &Run::bodies, {"torque"}},
    Compared{"wall_forces", &Run::walls, {"fx", "fy"}},
    Compared{"wall_torques", &Run::walls, {"torque"}},
    Compared{"dissipation", &Run::rheology, {"dissipation"}},
    Compared{"torque_ratio", &Run::rheology, {"torque_ratio"}},
    Compared{"order_parameter", &Run::rheology, {"order_parameter"}},
    Compared{"stresslet", &Run::rheology, {"s11", "s12"}},
    Compared{"uniform_velocity", &Run::rheology, {"uniform_x", "uniform_y"}},
    Compared{"viscosity", &Run::rheology, {"viscosity"}},
    Compared{"normal_stress_difference", &Run::rheology, {"normal_stress_difference"}},
    Compared{"particle_pressure", &Run::rheology, {"particle_pressure"}}};

/// Returns the values of a quantity, a row for each of its columns, a column for each row of the
/// table; without values if the scene does not define the quantity.
Eigen::ArrayXXd values_of(const Run& run, const Compared& quantity) {
  const NumberTable& table = run.*quantity.table;
  if (!table.has(quantity.columns[0])) return {};  // of walls or of a periodic cell
  const Eigen::Index components = quantity.columns[1] == nullptr ? 1 : 2;
  Eigen::ArrayXXd values(components, std::ssize(table.columns[0]));
  for (Eigen::Index k = 0; k < components; ++k) {
    values.row(k) = Eigen::ArrayXd::Map(table[quantity.columns[static_cast<std::size_t>(k)]].data(),
                                        values.cols());
  }
  if (values.isNaN().all()) return {};
  return values;
}

/// Returns pairs of indices of equal times of two ascending lists, up to rounding.
std::vector<std::array<Eigen::Index, 2>> common_times(const std::vector<double>& a,
                                                      const std::vector<double>& b) {
  const double rounding = 1e-12 * std::max(a.back(), b.back());
  std::vector<std::array<Eigen::Index, 2>> pairs;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (std::abs(a[i] - b[j]) <= rounding) {
      pairs.push_back({static_cast<Eigen::Index>(i++), static_cast<Eigen::Index>(j++)});
    } else {
      ++(a[i] < b[j] ? i : j);
    }
  }
  return pairs;
}

}  // namespace

const std::vector<double>& Comparison::operator[](std::string_view quantity) const {
  const auto found = std::ranges::find(differences, quantity, &Difference::name);
  if (found != differences.end()) return found->errors;
  throw SceneError("quantity " + std::string(quantity) + ": must be one that the scene defines: " +
                   joined(differences, ", ", &Difference::name));
}

double Comparison::rheology() const {
  double largest = 0.0;
  for (const Difference& difference : differences) {
    if (difference.of_rheology) largest = std::max(largest, std::ranges::max(difference.errors));
  }
  return largest;
}

Comparison compare(const Run& run, const Run& reference) {
  if (run.scene.bodies.size() != reference.scene.bodies.size() ||
      run.scene.walls.size() != reference.scene.walls.size()) {
    throw RecordError(reference.path, "must have as many bodies and walls as " + run.path.string());
  }
  const auto common = common_times(run.times(), reference.times());
  if (common.empty()) {
    throw RecordError(reference.path, "has no written time in common with " + run.path.string() +
                                          "; give both scenes the same output.dt_write");
  }
  Comparison result;
  for (const auto& [i, _] : common) {
    result.t.push_back(run.times()[static_cast<std::size_t>(i)]);
  }
  result.trajectory.assign(common.size(), 0.0);
  for (const Compared& quantity : compared) {
    const Eigen::ArrayXXd a = values_of(run, quantity), b = values_of(reference, quantity);
    if (a.size() == 0 || b.size() == 0) continue;
    const std::string_view name = quantity.name;
    const bool is_in_trajectory = name == "positions" || name == "angles";
    const double largest =
        std::sqrt(b.square().colwise().sum().maxCoeff<Eigen::PropagateNumbers>());
    Difference difference{
        .name = quantity.name,
        .of_rheology = quantity.table == &Run::rheology && name != "uniform_velocity",
        .unit = name == "positions"                  ? largest_radius(reference.scene)
                : is_in_trajectory || largest == 0.0 ? 1.0
                                                     : largest,
        .errors = {}};
    const Eigen::Index items = a.cols() / std::ssize(run.times());
    for (std::size_t k = 0; k < common.size(); ++k) {
      const auto& [i, j] = common[k];
      const auto error = (a.middleCols(i * items, items) - b.middleCols(j * items, items)).eval();
      difference.errors.push_back(std::sqrt(error.square().colwise().sum().maxCoeff()) /
                                  difference.unit);
      if (is_in_trajectory) {
        result.trajectory[k] = std::max(result.trajectory[k], difference.errors[k]);
      }
    }
    result.differences.push_back(std::move(difference));
  }
  return result;
}

std::string to_text(const Comparison& comparison) {
  std::vector<std::vector<std::string>> rows{
      {"difference of", "largest", "at t", "at the end", "unit"}};
  for (const auto& [name, _, unit, errors] : comparison.differences) {
    const auto largest = std::ranges::max_element(errors);
    const double t = comparison.t[static_cast<std::size_t>(largest - errors.begin())];
    rows.push_back({name, short_number(*largest), short_number(t, 6), short_number(errors.back()),
                    short_number(unit)});
  }
  return aligned_rows(rows);
}

std::string draw(const Comparison& comparison) {
  study::Plot plot{.title = "Difference of two runs",
                   .x_label = "t",
                   .y_label = "difference in its unit",
                   .log_x = false};
  for (const Difference& difference : comparison.differences) {
    if (std::ranges::max(difference.errors) == 0.0) continue;
    study::PlotLine& line = plot.lines.emplace_back(study::PlotLine{difference.name});
    for (std::size_t k = 0; k < comparison.t.size(); ++k) {
      line.points.push_back({comparison.t[k], difference.errors[k]});
    }
  }
  return study::draw_plot(plot);
}

Growth judge_growth(const std::vector<double>& t, const std::vector<double>& errors, double bound) {
  constexpr double saturated = 0.1, least_square = 0.9, least_factor = 100.0;
  Growth growth{errors.back(), {}, {}};
  std::vector<double> times, log_times, log_errors;
  double so_far = 0.0;
  for (std::size_t k = 0; k < t.size(); ++k) {
    so_far = std::max(so_far, errors[k]);
    if (!growth.exceeds && errors[k] > bound) growth.exceeds = t[k];
    if (t[k] <= 0.0 || so_far <= 0.0 || so_far > saturated) continue;
    times.push_back(t[k]);
    log_times.push_back(std::log(t[k]));
    log_errors.push_back(std::log(so_far));
  }
  const std::size_t n = times.size();
  if (n < 5 || log_errors.back() - log_errors.front() < std::log(least_factor)) return growth;
  const auto correlation = [&](const std::vector<double>& x) {
    return gsl_stats_correlation(x.data(), 1, log_errors.data(), 1, n);
  };
  const double linear = correlation(times);
  if (linear * linear >= least_square && linear > correlation(log_times)) {
    growth.rate = linear * gsl_stats_sd(log_errors.data(), 1, n) / gsl_stats_sd(times.data(), 1, n);
  }
  return growth;
}

}  // namespace stokesbook
