// Plots the tables of a run over time, and draws the paths of its bodies.
#include "analysis/plots.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "record/picture.hpp"
#include "study/plot.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

namespace {

/// Plots columns of a table over time, without those that the scene does not define.
study::Plot plot_of(const NumberTable& table, const std::string& label,
                    const std::vector<std::string>& columns, bool logarithmic) {
  study::Plot plot{
      .title = label, .x_label = "t", .y_label = label, .log_x = false, .log_y = logarithmic};
  for (const std::string& column : columns) {
    const std::vector<double>& values = table[column];
    if (std::ranges::none_of(values, [](double x) { return std::isfinite(x); })) continue;
    study::PlotLine& line = plot.lines.emplace_back(study::PlotLine{column});
    for (std::size_t k = 0; k < values.size(); ++k) {
      line.points.push_back({table["t"][k], values[k]});
    }
  }
  return plot;
}

std::string draw_paths(const Run& run, const std::vector<std::size_t>& bodies) {
  constexpr Eigen::Index points = 128;
  const auto& [scene, table] = std::tie(run.scene, run.bodies);
  Outlines outlines;
  Frame frame{.t = run.times().back(), .bodies = {}, .walls = {}};
  for (const Wall& wall : scene.walls) {
    outlines.walls.push_back(
        {sample(wall.shape, points, Side::fluid_outside).x, wall.role == WallRole::outer});
    frame.walls.push_back({wall.position, wall.orientation, {}});
  }
  std::vector<ComplexVector> positions;
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    outlines.bodies.push_back({sample(scene.bodies[body].shape, points, Side::fluid_outside).x});
    ComplexVector& path = positions.emplace_back(std::ssize(run.times()));
    std::size_t row = body;
    for (Complex& point : path) {
      point = {table["x"][row], table["y"][row]};
      row += scene.bodies.size();
    }
    row -= scene.bodies.size();
    frame.bodies.push_back(body_state(table, row));
  }
  std::vector<BodyPath> paths;
  for (const std::size_t body : bodies) {
    if (body >= positions.size()) {
      throw SceneError("--bodies: the run has " + std::to_string(positions.size()) +
                       " bodies, numbered from 0; there is no body " + std::to_string(body));
    }
    paths.push_back({body, positions[body]});
  }
  return draw_configuration(frame, outlines, scene.title, paths);
}

}  // namespace

std::vector<std::size_t> bodies_to_draw(const Scene& scene) {
  constexpr std::size_t readable = 20, chosen = 10;
  const std::size_t count = scene.bodies.size();
  std::vector<std::size_t> bodies(count > readable ? chosen : count);
  for (std::size_t k = 0; k < bodies.size(); ++k) bodies[k] = k * count / bodies.size();
  return bodies;
}

std::map<std::string, std::string> draw_run(const Run& run,
                                            const std::vector<std::size_t>& bodies) {
  std::map<std::string, std::string> pictures{{"paths.svg", draw_paths(run, bodies)}};
  const auto add = [&](const std::string& name, const study::Plot& plot) {
    if (!plot.lines.empty()) pictures[name + ".svg"] = study::draw_plot(plot);
  };
  for (const char* name : {"dissipation", "torque_ratio", "order_parameter", "viscosity",
                           "normal_stress_difference", "particle_pressure"}) {
    if (run.rheology.has(name)) add(name, plot_of(run.rheology, name, {name}, false));
  }
  add("stresslet", plot_of(run.rheology, "stresslet", {"s11", "s12"}, false));
  add("gaps", plot_of(run.steps, "least gap", {"min_gap"}, true));
  add("cost", plot_of(run.steps, "cost and length of a step", {"matvecs", "seconds", "dt"}, true));
  return pictures;
}

}  // namespace stokesbook
