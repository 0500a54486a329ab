// Draws the figures of an experiment: errors against the varied quantity, and errors against costs.
#include "study/figures.hpp"

#include <cmath>
#include <optional>

#include "study/plot.hpp"
#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

/// Makes the guide of a line from its claimed law, through the first used point (x_0, e_0).
struct GuideOfLaw {
  std::size_t line;
  Measurement first, last;  ///< used points with the smallest and the largest x

  std::optional<Guide> operator()(const Algebraic& law) const {
    // The guide e_0 (x / x_0)^{-p} spans the middle half of the used points.
    const double x0 = first.x * std::pow(last.x / first.x, 0.25);
    const double x1 = first.x * std::pow(last.x / first.x, 0.75);
    const auto y = [&](double x) { return first.error * std::pow(x / first.x, -law.order); };
    return Guide{.line = line,
                 .from = {x0, y(x0)},
                 .to = {x1, y(x1)},
                 .slope = law.order == 0.0 ? "" : short_number(std::abs(law.order))};
  }

  std::optional<Guide> operator()(const Geometric& law) const {
    // The guide e_0 (x / x_0)^q exp(-alpha (x - x_0)) spans all used points.
    const double gained = law.rate * (last.x - first.x);
    const double power = std::pow(last.x / first.x, law.power);
    return Guide{.line = line,
                 .from = {first.x, first.error},
                 .to = {last.x, first.error * power * std::exp(-gained)}};
  }

  std::optional<Guide> operator()(const auto&) const { return std::nullopt; }
};

}  // namespace

std::string convergence_figure(const ExperimentResult& result) {
  const auto& [experiment, lines] = result;
  Plot plot{.title = experiment.title,
            .x_label = experiment.x,
            .y_label = experiment.error,
            .log_x = experiment.axes == Axes::log_log,
            .cells = experiment.axes == Axes::nominal};
  for (const auto& [line, measurements, verdict, _] : lines) {
    PlotLine& drawn = plot.lines.emplace_back(PlotLine{line.label});
    std::vector<Measurement> used;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
      const bool left_out = verdict && !verdict->used[i];
      drawn.points.push_back({measurements[i].x, measurements[i].error, left_out});
      if (!left_out) used.push_back(measurements[i]);
    }
    if (!verdict) continue;
    if (line.claim->window.floor > 0.0) plot.floors.push_back(line.claim->window.floor);
    if (verdict->outcome == Outcome::inconclusive || used.empty()) continue;
    const GuideOfLaw guide_of_law{plot.lines.size() - 1, used.front(), used.back()};
    const std::optional<Guide> guide = std::visit(guide_of_law, line.claim->law);
    if (guide) plot.guides.push_back(*guide);
  }
  return draw_plot(plot);
}

std::string work_precision_figures(const ExperimentResult& result) {
  const auto& [experiment, lines] = result;
  std::string svg;
  for (const CostMeasure& cost : measured_costs(result)) {
    Plot plot{.title = experiment.title + ": error against " + cost.name,
              .x_label = cost.name,
              .y_label = experiment.error};
    for (const LineResult& found : lines) {
      PlotLine& drawn = plot.lines.emplace_back(PlotLine{found.line.label});
      for (const Measurement& point : found.measurements) {
        drawn.points.push_back({point.*cost.value, point.error});
      }
    }
    svg += draw_plot(plot);
  }
  return svg;
}

}  // namespace stokesbook::study
