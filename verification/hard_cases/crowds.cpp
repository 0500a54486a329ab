// Defines hard instants of many bodies that nearly touch.
#include <algorithm>

#include "hard_case.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

HardCase hexagon(double gap) {
  return {"05", text("seven disks in shear, all gaps %g of the radius; against more digits", gap),
          [=] {
            const Scene scene = disk_hexagon(1, gap, 1e-4);
            return solve(scene, against_finer(scene));
          }};
}

HardCase packing(int count) {
  return {"05", text("%.0f disks at an area fraction of 0.6 in shear; against more digits", count),
          [=] {
            Scene scene = disk_packing(count);
            scene.solver.tolerance = 1e-3;
            return solve(scene, against_finer(scene));
          }};
}

// Bodies in a turning container turn with it as one rigid body, for any gaps.
Finding turning_container(Scene scene, double radius) {
  scene.flow = QuiescentFlow{};
  scene.walls = {{.role = WallRole::outer, .shape = Circle{radius}, .motion = RotatingWall{1.0}}};
  return solve(scene, [=](const Solution& solution) {
    double most = 0.0;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      const RigidMotion turning{Complex{0.0, 1.0} * scene.bodies[k].position, 1.0};
      most = std::max(most, distance_of_motions(solution.motions[k], turning, 1.0));
    }
    return most;
  });
}

}  // namespace

std::vector<HardCase> crowds() {
  return {hexagon(1e-2),
          hexagon(1e-3),
          packing(30),
          {"12", "seven disks with gaps of 0.001 in a container that turns: all turn with it",
           [] { return turning_container(disk_hexagon(1, 1e-3, 1e-3), 3.5); }},
          {"12",
           "two disks with a gap of 1e-8 in a container that turns: both turn with it",
           [] { return turning_container(circles_in_extension(1e-8, 1e-3), 2.5); },
           Due::either,
           {"rounding"}}};
}

}  // namespace stokesbook::verification::hard_cases
