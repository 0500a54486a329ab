// Computes the viscosity of the published Couette cells at their first instant, from the torque on
// the inner wall, and compares it with the printed value.
#include <cmath>
#include <optional>
#include <random>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "suspension/solver/rheology.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

/// A published cell: its scene, and the printed viscosity that bodies add, in thousandths.
struct CellStart {
  const char* scene;
  double printed;
};

constexpr CellStart dilute_start{"couette", 108.0}, dense_start{"couette_dense", 297.0};

Scene scene_of(const CellStart& cell) {
  return shipped_scene(cell.scene);
}

double added_viscosity(const Scene& scene) {
  const SuspensionSolver solver(scene);
  return 1e3 * (Rheometer(solver)(solver.solve(solver.start())).torque_ratio - 1.0);
}

enum class Bodies {
  all,
  nine_of_ten  ///< a planted defect
};

double added_viscosity(const CellStart& cell, double tolerance, Bodies bodies) {
  static test::Once<std::tuple<std::string, double, Bodies>, double> found;
  return found({cell.scene, tolerance, bodies}, [&] {
    Scene scene = scene_of(cell);
    std::vector<Body> kept;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      if (bodies == Bodies::all || k % 10 != 0) kept.push_back(scene.bodies[k]);
    }
    scene.bodies = kept;
    scene.solver.tolerance = tolerance;
    return added_viscosity(scene);
  });
}

std::vector<double> tolerances(Size size) {
  return size == Size::full ? std::vector{1e-6, 1e-5, 1e-4, 1e-3, 1e-2}
                            : std::vector{1e-3, 3e-3, 1e-2};
}

Measure added_viscosities(const CellStart& cell) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double tolerance : tolerances(size)) {
      measurements.push_back(
          {.x = tolerance, .error = added_viscosity(cell, tolerance, Bodies::all)});
    }
    return measurements;
  };
}

Measure differences_at_start(const CellStart& cell, Bodies bodies) {
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
                const CellStart& cell) {
  return {.key = key + "_off",
          .label = label + ": difference from print",
          .measure = differences_at_start(cell, Bodies::all),
          .claim = Claim{.id = id,
                         .statement = "The first instant of the published Couette run with " +
                                      label + " has the published viscosity, to its digits.",
                         .law = Identity{0.6},
                         .reason = "printed to four digits, of positions known to four digits",
                         .api = {"stokesbook::Rheometer"}},
          .control =
              Control{"one body in ten left out", differences_at_start(cell, Bodies::nine_of_ten)}};
}

// Discretises with the nodes of the published run and its near integrals. The solver's tolerance is
// so loose that all nodes meet it.
Scene on_published_nodes(Scene scene) {
  scene = with_nodes(std::move(scene), 32, 256);
  scene.solver.near_singular = NearSingular::interpolation;
  scene.solver.tolerance = 0.1;
  scene.solver.gmres_tol = 1e-9;
  return scene;
}

Scene on_automatic_nodes(Scene scene) {
  scene.solver.tolerance = 1e-4;
  return scene;
}

constexpr double half_digit = 5e-5;  // half a unit of the last digit of the published positions

/// Returns the viscosity that the bodies of the dense cell add if each coordinate and angle changes
/// at random.
///
/// @param  most  largest change; 0 returns the value of the start, for any seed
double added_when_moved(Scene (*nodes)(Scene), unsigned seed, double most) {
  static test::Once<std::tuple<Scene (*)(Scene), unsigned, double>, double> found;
  return found({nodes, seed, most}, [&] {
    Scene scene = nodes(scene_of(dense_start));
    std::mt19937_64 random(seed);
    for (Body& body : scene.bodies) {
      const double x = uniform(random, -most, most), y = uniform(random, -most, most);
      body.position += Complex(x, y);
      body.orientation += uniform(random, -most, most);
    }
    return added_viscosity(scene);
  });
}

/// @param  expected  added viscosity to compare with, in thousandths; without a value: that of the
///                   unchanged start
Measure when_moved(Scene (*nodes)(Scene), std::optional<double> expected,
                   double most = half_digit) {
  return [=](Size) {
    const double reference = expected ? *expected : added_when_moved(nodes, 0, 0.0);
    std::vector<Measurement> measurements;
    for (unsigned seed = 1; seed <= 12U; ++seed) {
      const double found = added_when_moved(nodes, seed, most);
      measurements.push_back(
          {.x = static_cast<double>(seed), .error = 100.0 * std::abs(found - reference)});
    }
    return measurements;
  };
}

}  // namespace

Experiment couette_starts() {
  return left_to_full({.key = "couette_starts",
                       .title = "The published Couette cells at their first instant",
                       .x = "tolerance ε",
                       .error = "what bodies add to the torque of the inner wall, in thousandths",
                       .lines = {{.key = "dilute",
                                  .label = "80 ellipses 3:1, 5 %",
                                  .measure = added_viscosities(dilute_start)},
                                 {.key = "dense",
                                  .label = "320 ellipses 6:1, 10 %",
                                  .measure = added_viscosities(dense_start)},
                                 difference("dilute", "12_30", "80 ellipses 3:1", dilute_start),
                                 difference("dense", "12_31", "320 ellipses 6:1", dense_start)}});
}

Experiment couette_digits() {
  constexpr double recomputed = 296.94;
  return left_to_full(
      {.key = "couette_digits",
       .title = "320 ellipses 6:1 at their first instant, each moved and turned at random by up to "
                "half a unit of the last digit that is known",
       .x = "seed k",
       .error = "difference of the viscosity, in hundred-thousandths",
       .axes = Axes::nominal,
       .lines = {
           {.key = "moved",
            .label = "from that without moves",
            .measure = when_moved(on_automatic_nodes, {}),
            .claim = Claim{.id = "12_38",
                           .statement = "Positions known to four digits give the viscosity of the "
                                        "first instant to a hundred-thousandth.",
                           .law = AtMost{1.0},
                           .reason = "a mean over 320 bodies, whose errors are independent",
                           .api = {"stokesbook::Rheometer"}},
            .control = Control{"moves a hundred times as large",
                               when_moved(on_automatic_nodes, {}, 100.0 * half_digit)}},
           {.key = "published_nodes",
            .label = "from 1.29694, on 32 nodes a body and 256 a wall",
            .measure = when_moved(on_published_nodes, recomputed),
            .claim = Claim{.id = "12_39",
                           .statement =
                               "On the published nodes, with the published near integrals, the "
                               "viscosity at the first instant is 1.29694, the recomputed value.",
                           .law = Identity{1.0},
                           .reason = "half a unit of its last digit, and as much for the positions",
                           .api = {"stokesbook::Rheometer"}},
            .control =
                Control{"nodes chosen for 1e-4", when_moved(on_automatic_nodes, recomputed)}},
           {.key = "automatic_nodes",
            .label = "from 1.29694, on nodes chosen for 1e-4",
            .measure = when_moved(on_automatic_nodes, recomputed)}}});
}

}  // namespace stokesbook::verification::suspension
