// Reads the scene and the tables of a run.
#include "analysis/run.hpp"

#include <algorithm>

#include "record/atomic_file.hpp"
#include "scene/parse.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

Run read_run(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path / "trajectory.csv")) {
    throw RecordError(path, "must be the folder of a run whose output.formats contain \"csv\"");
  }
  Run run{.path = path, .scene = read_scene(path / "scene.toml").scene};
  const auto read = [&](const char* name, std::size_t rows) {
    NumberTable table = read_table(path / name);
    if (table.columns.at(0).size() == rows) return table;
    throw RecordError(table.path, "must have " + std::to_string(rows) +
                                      " rows, as many as rheology.csv and scene.toml require");
  };
  run.rheology = read_table(path / "rheology.csv");
  if (run.times().empty()) throw RecordError(run.rheology.path, "has no rows");
  run.bodies = read("trajectory.csv", run.times().size() * run.scene.bodies.size());
  if (!run.scene.walls.empty()) {
    run.walls = read("walls.csv", run.times().size() * run.scene.walls.size());
  }
  run.steps = read_table(path / "steps.csv");
  return run;
}

BodyState body_state(const NumberTable& bodies, std::size_t row) {
  return {.position = {bodies["x"][row], bodies["y"][row]},
          .orientation = bodies["theta"][row],
          .velocity = {bodies["ux"][row], bodies["uy"][row]},
          .omega = bodies["omega"][row],
          .force = {},
          .torque = 0.0};
}

double largest_radius(const Scene& scene) {
  constexpr Eigen::Index points = 256;
  double radius = 0.0;
  for (const Body& body : scene.bodies) {
    const Curve curve = sample(body.shape, points, Side::fluid_outside);
    radius = std::max(radius, bounding_radius(curve, 0.0));
  }
  return radius > 0.0 ? radius : 1.0;
}

}  // namespace stokesbook
