// Draws the figures of an experiment: errors against the varied quantity, and errors against costs.
#include "study/figures.hpp"

#include <algorithm>
#include <cmath>

#include "study/plot.hpp"
#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

/// The used points with the smallest and the largest x.
struct FittedRange {
  Measurement first, last;
};

FittedRange fitted_range(const LineResult& result) {
  FittedRange range;
  bool found = false;
  for (std::size_t i = 0; i < result.measurements.size(); ++i) {
    if (!result.verdict->used[i]) continue;
    if (!found) range.first = result.measurements[i];
    range.last = result.measurements[i];
    found = true;
  }
  return range;
}

/// Makes the guides of a line from its claimed law, through the first used point (x_0, e_0).
struct GuideOfLaw {
  std::size_t line;
  FittedRange range;

  std::vector<Guide> operator()(const Algebraic& law) const {
    // The guide e_0 (x / x_0)^{-p} spans the middle half of the used points.
    const double x0 = range.first.x * std::pow(range.last.x / range.first.x, 0.25);
    const double x1 = range.first.x * std::pow(range.last.x / range.first.x, 0.75);
    const auto y = [&](double x) {
      return range.first.error * std::pow(x / range.first.x, -law.order);
    };
    return {{.line = line,
             .from = {x0, y(x0)},
             .to = {x1, y(x1)},
             .triangle = law.order != 0.0,
             .label = short_number(law.order)}};
  }

  std::vector<Guide> operator()(const Geometric& law) const {
    // The guide e_0 (x / x_0)^q exp(-alpha (x - x_0)) spans all used points.
    const double gained = law.rate * (range.last.x - range.first.x);
    const double power = std::pow(range.last.x / range.first.x, law.power);
    return {{.line = line,
             .from = {range.first.x, range.first.error},
             .to = {range.last.x, range.first.error * power * std::exp(-gained)}}};
  }

  std::vector<Guide> operator()(const auto&) const { return {}; }
};

}  // namespace

std::string convergence_figure(const Experiment& experiment, const std::vector<LineResult>& lines) {
  Plot plot{.title = experiment.title,
            .x_label = experiment.x,
            .y_label = experiment.error,
            .log_x = experiment.axes == Axes::log_log};
  for (std::size_t k = 0; k < lines.size(); ++k) {
    PlotLine& drawn = plot.lines.emplace_back(PlotLine{experiment.lines[k].label, {}});
    const std::optional<Verdict>& verdict = lines[k].verdict;
    for (std::size_t i = 0; i < lines[k].measurements.size(); ++i) {
      const Measurement& point = lines[k].measurements[i];
      drawn.points.push_back({point.x, point.error, verdict && !verdict->used[i]});
    }
    if (!verdict) continue;
    const Claim& claim = *experiment.lines[k].claim;
    if (claim.window.floor > 0.0) plot.floors.push_back(claim.window.floor);
    if (verdict->outcome == Outcome::inconclusive) continue;
    std::ranges::copy(std::visit(GuideOfLaw{k, fitted_range(lines[k])}, claim.law),
                      std::back_inserter(plot.guides));
  }
  return draw_plot(plot);
}

std::string work_precision_figures(const Experiment& experiment,
                                   const std::vector<LineResult>& lines) {
  std::string svg;
  for (const CostMeasure& cost : measured_costs(experiment, lines)) {
    Plot plot{.title = experiment.title + ": error against " + cost.name,
              .x_label = cost.name,
              .y_label = experiment.error};
    for (std::size_t k = 0; k < lines.size(); ++k) {
      PlotLine& drawn = plot.lines.emplace_back(PlotLine{experiment.lines[k].label, {}});
      for (const Measurement& point : lines[k].measurements) {
        drawn.points.push_back({point.*cost.value, point.error});
      }
    }
    svg += draw_plot(plot);
  }
  return svg;
}

}  // namespace stokesbook::study
