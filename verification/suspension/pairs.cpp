// Compares two unit circles on automatic nodes with closed forms, down to small gaps, and checks
// the law of lubrication.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "scenes.hpp"
#include "support/closed_forms.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

// Flow and forces that move the circles along their line of centres.
struct PairDrive {
  BackgroundFlow flow;
  double force = 0.0;  // on the right circle; the left circle has the opposite force

  double exact(double gap) const {
    const CirclePair circles{1.0, gap};
    return force == 0.0 ? circles.speed_in_extension(1.0) : circles.speed_of_pull(force, 1.0);
  }

  Scene scene(double gap) const {
    Scene pair;
    pair.flow = flow;
    for (const double side : {-1.0, 1.0}) {
      pair.bodies.push_back({.shape = Circle{1.0}, .position = side * (1.0 + 0.5 * gap)});
      pair.bodies.back().force = side * force;
    }
    return pair;
  }
};

const PairDrive in_extension{ExtensionalFlow{1.0}}, pulled_apart{QuiescentFlow{}, 1.0};

// This is the tightest tolerance that the solver meets at the narrowest gaps, relative to the
// largest velocity. The solver's estimate includes all rounding errors; the speed itself is less
// affected.
constexpr double least_tolerance = 1e-10;

// Returns the speed of the right circle, solved to a relative error. The nodes are given or
// automatic.
double speed(const PairDrive& drive, double gap, double relative_error, int n_nodes,
             NearSingular near = NearSingular::automatic) {
  Scene scene = drive.scene(gap);
  scene.solver.near_singular = near;
  scene = with_nodes(std::move(scene), n_nodes, n_nodes);
  // The solver's tolerance is relative to the largest velocity of the data, about 2 in extension
  // and 1 / 4 under forces. The tolerance is not below the level of rounding errors.
  scene.solver.tolerance = std::clamp(
      relative_error * drive.exact(gap) / (drive.force == 0.0 ? 2.0 : 0.25), least_tolerance, 0.1);
  scene.solver.gmres_tol = 1e-14;
  const SuspensionSolver solver(scene);
  const Instant start = solver.start();
  if (n_nodes == automatic_nodes) {
    return solver.solve(start).motions[1].velocity.real();
  }
  return solved_at(solver, resolutions_of(solver.discretisation()), 1e-14)
      .completion.motions[1]
      .velocity.real();
}

Measure relative_errors(const PairDrive& drive, int n_nodes) {
  return [=](Size) {
    std::vector<Measurement> points;
    for (const double gap : {1e-4, 1e-3, 1e-2, 1e-1}) {
      const double exact = drive.exact(gap);
      points.push_back(
          {.x = gap, .error = std::abs(speed(drive, gap, 1e-8, n_nodes) / exact - 1.0)});
    }
    return points;
  };
}

Measure speeds(const PairDrive& drive, int n_nodes) {
  return [=](Size) {
    std::vector<Measurement> points;
    for (const double gap : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
      points.push_back({.x = gap, .error = speed(drive, gap, 1e-3, n_nodes)});
    }
    return points;
  };
}

Measure errors_to_the_narrowest(int n_nodes, NearSingular near) {
  return [=](Size) {
    std::vector<Measurement> points;
    for (const double gap : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.03, 0.1, 0.3, 1.0}) {
      const double found = speed(in_extension, gap, 1e-3, n_nodes, near);
      points.push_back({.x = gap, .error = std::abs(found / in_extension.exact(gap) - 1.0)});
    }
    return points;
  };
}

/// Measures the speed at which unit forces open the gap, relative to the exact speed.
///
/// @param  n_nodes  nodes of each circle; the unit of the gap is the spacing of 32 nodes
Measure responses(int n_nodes, NearSingular near) {
  return [=](Size) {
    std::vector<Measurement> points;
    for (const double spacings : {0.05, 0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0}) {
      const double gap = spacings * std::numbers::pi / 16.0;
      points.push_back(
          {.x = spacings,
           .error = speed(pulled_apart, gap, 1e-6, n_nodes, near) / pulled_apart.exact(gap)});
    }
    return points;
  };
}

/// Measures the difference of these relative speeds from 1.
Measure response_errors(int n_nodes, NearSingular near) {
  return [=](Size size) {
    std::vector<Measurement> points = responses(n_nodes, near)(size);
    for (Measurement& point : points) point.error = std::abs(point.error - 1.0);
    return points;
  };
}

Line closed_form(const std::string& key, const std::string& id, const std::string& label,
                 const PairDrive& drive) {
  return {.key = key,
          .label = label,
          .measure = relative_errors(drive, automatic_nodes),
          .claim = Claim{.id = id,
                         .statement = "With automatic nodes the pair's speed is right to 1e-8 of "
                                      "itself, although it is 1e-7 of the flow's at the least gap.",
                         .law = Identity{1e-8},
                         .window = {},
                         .reason = "the nodes resolve the densities; rounding leaves about "
                                   "1e-16 g^(-3/2) of the flow, 1e-16 g^(-2) of the speed",
                         .api = {"stokesbook::SuspensionSolver"}},
          .control = Control{"48 nodes a circle", relative_errors(drive, 48)}};
}

Line lubrication_law(const std::string& key, const std::string& id, const std::string& label,
                     const PairDrive& drive) {
  return {.key = key,
          .label = label,
          .measure = speeds(drive, automatic_nodes),
          .claim = Claim{.id = id,
                         .statement = "The pair's speed falls like the gap to the power 3/2, over "
                                      "five decades.",
                         .law = Algebraic{-1.5, 0.03},
                         .window = {.from = 0.0, .to = 0.02, .floor = 0.0},
                         .reason = "lubrication between circles; the closed forms' next term is of "
                                   "relative size g",
                         .api = {"stokesbook::SuspensionSolver"}},
          .control = Control{"32 nodes a circle", speeds(drive, 32)}};
}

}  // namespace

Experiment pair_speeds() {
  return {.key = "pairs",
          .title = "Two circles, against closed forms",
          .x = "gap g",
          .error = "relative error of the speed along the line of centres",
          .lines = {closed_form("extension", "12_4", "in extension", in_extension),
                    closed_form("pull", "12_5", "pulled apart", pulled_apart)}};
}

Experiment narrow_gaps() {
  const Measure published = errors_to_the_narrowest(32, NearSingular::interpolation);
  return {.key = "narrow_gaps",
          .title = "How narrow a gap the published nodes resolve: two circles in extension",
          .x = "gap g",
          .error = "relative error of the speed along the line of centres",
          .lines = {{.key = "ours",
                     .label = "automatic nodes",
                     .measure = errors_to_the_narrowest(automatic_nodes, NearSingular::automatic),
                     .claim = Claim{.id = "12_46",
                                    .statement = "Automatic nodes give the pair's speed to 1e-3 of "
                                                 "itself at all gaps down to a millionth.",
                                    .law = AtMost{1e-3},
                                    .reason = "the relative error is the tolerance of the solve",
                                    .api = {"stokesbook::SuspensionSolver"}},
                     .control = Control{"32 equal nodes a circle, as published", published}},
                    {.key = "published",
                     .label = "published: 32 equal nodes, interpolation",
                     .measure = published}}};
}

Experiment contact_response() {
  constexpr int published = 32;
  return {.key = "contact_response",
          .title =
              "Response of a gap to forces of contact, by 32 equal nodes and by automatic ones: "
              "two circles pulled apart",
          .x = "gap in spacings of 32 nodes g",
          .error = "speed of opening over the exact speed, or as labelled",
          .axes = Axes::no_law,
          .lines = {{.key = "plain",
                     .label = "32 nodes, plain rule",
                     .measure = responses(published, NearSingular::off)},
                    {.key = "interpolation",
                     .label = "32 nodes, interpolation",
                     .measure = responses(published, NearSingular::interpolation)},
                    {.key = "cauchy",
                     .label = "32 nodes, Cauchy scheme",
                     .measure = responses(published, NearSingular::cauchy)},
                    {.key = "automatic",
                     .label = "automatic nodes",
                     .measure = responses(automatic_nodes, NearSingular::automatic)},
                    {.key = "automatic_off",
                     .label = "automatic nodes: difference from 1",
                     .measure = response_errors(automatic_nodes, NearSingular::automatic),
                     .claim = Claim{.id = "12_54",
                                    .statement = "Automatic nodes give the response to a force of "
                                                 "contact to 1e-6 of itself, down to a twentieth "
                                                 "of the spacing of 32 nodes.",
                                    .law = AtMost{1e-6},
                                    .reason = "the relative error is the tolerance of the solve",
                                    .api = {"stokesbook::SuspensionSolver"}},
                     .control = Control{"32 equal nodes by the plain rule",
                                        response_errors(published, NearSingular::off)}}}};
}

Experiment lubrication() {
  return {.key = "lubrication",
          .title = "The law of lubrication",
          .x = "gap g",
          .error = "speed along the line of centres",
          .lines = {lubrication_law("extension", "12_6", "in extension", in_extension),
                    lubrication_law("pull", "12_7", "pulled apart", pulled_apart)}};
}

}  // namespace stokesbook::verification::suspension
