// Shows why clusters of held bodies can be local: measures how forces between held bodies decay
// with distance, and the force due to closed pores (13.6).
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/once.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;

namespace {

/// Selects whether the other bodies are held or free while one body is moved.
enum class Others { held, free };

/// Returns the motions and loads of all bodies if the body in the middle of the list moves at unit
/// speed. The gauge length of the Stokeslets is a hundred radii.
Completion moved_middle(Scene scene, Others others, PreconditionerKind preconditioner) {
  const std::size_t middle = scene.bodies.size() / 2;
  scene.flow = QuiescentFlow{};
  scene.gauge_length = 100.0;
  for (Body& body : scene.bodies) body.held = others == Others::held;
  scene.bodies[middle].held = true;
  scene.bodies[middle].velocity = std::polar(1.0, 0.4);
  const test::Discretised system(test::with_preconditioner(std::move(scene), preconditioner));
  const GmresResult result =
      solve(system.discrete, system.discrete.system.right_hand_side(), {1e-5, 2000});
  return system.discrete.system.closure().complete(deinterleaved(result.solution));
}

/// Returns the forces of held disks in a hexagonal patch, or the velocities of free disks, relative
/// to the force or velocity of the moved disk. Each value is the root mean square over the disks at
/// equal distance from the moved disk.
std::vector<Measurement> responses(int rings, Others others) {
  const Scene scene = test::disk_hexagon(rings, 0.05, 1e-2);
  const Completion completion = moved_middle(scene, others, PreconditionerKind::clusters);
  const auto response = [&](std::size_t k) {
    return std::abs(others == Others::held ? completion.loads[k].force
                                           : completion.motions[k].velocity);
  };
  const std::size_t middle = scene.bodies.size() / 2;
  const double own = others == Others::held ? response(middle) : 1.0;
  std::map<long, std::vector<double>> at_distance;  // keys in millionths of a radius
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const double r = std::abs(scene.bodies[k].position - scene.bodies[middle].position);
    if (k != middle) at_distance[std::lround(1e6 * r)].push_back(response(k) / own);
  }
  std::vector<Measurement> measurements;
  for (const auto& [distance, values] : at_distance) {
    const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
    measurements.push_back({.x = 1e-6 * static_cast<double>(distance),
                            .error = std::sqrt(squares / static_cast<double>(values.size()))});
  }
  return measurements;
}

Measure by_distance(Others others) {
  return [=](Size size) {
    static test::Once<std::pair<int, Others>, std::vector<Measurement>> measured;
    const int rings = size == Size::full ? 5 : 4;
    return measured({rings, others}, [&] { return responses(rings, others); });
  };
}

const std::vector<double> pore_gaps{0.005, 0.01, 0.02};

/// Returns the force on the middle disk of seven disks, which moves among six held disks.
double force_in_hexagon(double gap) {
  return std::abs(moved_middle(test::disk_hexagon(1, gap, 1e-3), Others::held,
                               PreconditionerKind::block_diagonal)
                      .loads[3]
                      .force);
}

/// Returns the sum of the same force over the six pairs.
double force_of_pairs(double gap) {
  const Scene hexagon = test::disk_hexagon(1, gap, 1e-3);
  Complex force = 0.0;
  for (std::size_t k = 0; k < hexagon.bodies.size(); ++k) {
    if (k == 3) continue;
    Scene pair = hexagon;
    pair.bodies = {hexagon.bodies[k], hexagon.bodies[3]};
    force += moved_middle(pair, Others::held, PreconditionerKind::block_diagonal).loads[1].force;
  }
  return std::abs(force);
}

using Force = double (*)(double gap);

Measure forces(Force force) {
  return [=](Size) {
    static test::Once<std::pair<Force, double>, double> forces;
    std::vector<Measurement> measurements;
    for (const double gap : pore_gaps) {
      measurements.push_back({.x = gap, .error = forces({force, gap}, [&] { return force(gap); })});
    }
    return measurements;
  };
}

}  // namespace

Experiment screening() {
  return {.key = "screening",
          .title = "Effect of a moved disk on others in a hexagonal patch, gap 0.05",
          .x = "distance of the centres, in radii, r",
          .error = "force or velocity, relative to that of the moved disk",
          .lines = {
              {.key = "held",
               .label = "forces on held disks",
               .measure = by_distance(Others::held),
               .claim =
                   Claim{.id = "13_7",
                         .statement = "The forces that a moved disk exerts on held disks fall with "
                                      "the square of the distance.",
                         .law = Algebraic{2.0, 0.3},
                         .window = {.from = 3.0, .to = 6.5},
                         .reason = "held disks are a porous medium: the pressure is harmonic "
                                   "(Darcy), that of a moved disk a dipole's, 1 / r, and forces "
                                   "go like its gradient; the first shell is no continuum yet, "
                                   "and an open edge at a distance R adds (r / R)^4 / 2, at 9 "
                                   "radii a tenth for r = 6.5",
                         .api = {"stokesbook::ClusterPreconditioner"}},
               .control = Control{"free disks in place of held ones", by_distance(Others::free)}},
              {.key = "free",
               .label = "velocities of free disks",
               .measure = by_distance(Others::free)}}};
}

Experiment pores() {
  return {
      .key = "pores",
      .title = "Force on the middle one of seven held disks",
      .x = "gap, in radii, g",
      .error = "force, over viscosity and velocity",
      .lines = {
          {.key = "hexagon",
           .label = "all seven together",
           .measure = forces(force_in_hexagon),
           .claim =
               Claim{.id = "13_8",
                     .statement = "Where gaps close pores, resistances of held disks grow like "
                                  "g^(-5/2), and are not sums over pairs.",
                     .law = Algebraic{2.5, 0.1},
                     .reason = "what a moved disk displaces from the pores about it flows "
                               "through gaps, which takes a pressure of g^(-5/2) "
                               "(Reynolds); a pair, with open pores, has g^(-3/2)",
                     .api = {"stokesbook::ClusterPreconditioner"}},
           .control = Control{"the sum over the six pairs of the disk", forces(force_of_pairs)}},
          {.key = "pairs", .label = "sum over six pairs", .measure = forces(force_of_pairs)}}};
}

}  // namespace stokesbook::verification::preconditioning
