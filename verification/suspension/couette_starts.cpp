// The published Couette cells at their first instant: the viscosity that the inner wall feels.
#include <cmath>
#include <filesystem>

#include "experiments.hpp"
#include "scene/parse.hpp"
#include "support/once.hpp"
#include "suspension/rheology.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

/// A published cell: its scene, and what is printed that bodies add to the viscosity, in thousandths.
struct Cell {
  const char* scene;
  double printed;
};

constexpr Cell dilute{"couette.toml", 108.0}, dense{"couette_dense.toml", 297.0};

enum class Bodies {
  all,
  nine_of_ten  ///< a planted defect
};

double added_viscosity(const Cell& cell, double tolerance, Bodies bodies) {
  static test::Once<std::tuple<std::string, double, Bodies>, double> found;
  return found({cell.scene, tolerance, bodies}, [&] {
    Scene scene = read_scene(std::filesystem::path(STOKESBOOK_SCENES) / cell.scene);
    std::vector<Body> kept;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      if (bodies == Bodies::all || k % 10 != 0) kept.push_back(scene.bodies[k]);
    }
    for (Body& body : kept) body.n_nodes = stokesbook::automatic_nodes;
    for (Wall& wall : scene.walls) wall.n_nodes = stokesbook::automatic_nodes;
    scene.bodies = kept;
    scene.solver.tolerance = tolerance;
    const SuspensionSolver solver(scene);
    const Configuration start = solver.initial_configuration();
    return 1e3 * (Rheometer(solver)(start, solver.solve(start)).torque_ratio - 1.0);
  });
}

std::vector<double> tolerances(Size size) {
  return size == Size::full ? std::vector{1e-6, 1e-5, 1e-4, 1e-3, 1e-2}
                            : std::vector{1e-4, 1e-3, 1e-2};
}

Measure added_viscosities(const Cell& cell) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double tolerance : tolerances(size)) {
      measurements.push_back(
          {.x = tolerance, .error = added_viscosity(cell, tolerance, Bodies::all)});
    }
    return measurements;
  };
}

Measure differences(const Cell& cell, Bodies bodies) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double tolerance : tolerances(size)) {
      const double found = added_viscosity(cell, tolerance, bodies);
      measurements.push_back({.x = tolerance, .error = std::abs(found - cell.printed)});
    }
    return measurements;
  };
}

Line difference(const std::string& key, const std::string& id, const std::string& label,
                const Cell& cell) {
  return {.key = key + "_off",
          .label = label + ": difference from print",
          .measure = differences(cell, Bodies::all),
          .claim = Claim{.id = id,
                         .statement = "The first instant of the published Couette run with " +
                                      label + " has the published viscosity, to its digits.",
                         .law = Identity{0.6},
                         .reason = "printed to four digits, of positions known to four digits",
                         .api = {"stokesbook::Rheometer"}},
          .control = Control{"one body in ten left out", differences(cell, Bodies::nine_of_ten)}};
}

}  // namespace

Experiment couette_starts() {
  return {
      .key = "couette_starts",
      .title = "The published Couette cells at their first instant",
      .x = "tolerance e",
      .error = "what bodies add to the torque of the inner wall, in thousandths",
      .lines = {
          {.key = "dilute", .label = "80 ellipses 3:1, 5 %", .measure = added_viscosities(dilute)},
          {.key = "dense", .label = "320 ellipses 6:1, 10 %", .measure = added_viscosities(dense)},
          difference("dilute", "12_30", "80 ellipses 3:1", dilute),
          difference("dense", "12_31", "320 ellipses 6:1", dense)}};
}

}  // namespace stokesbook::verification::suspension
