// Defines hard runs with contact: steps that are far too long, bodies pressed together in various
// ways, crowds.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hard_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;

namespace {

Body pushed(const Shape& shape, Complex position, Complex force) {
  Body result = body(shape, position);
  result.force = force;
  return result;
}

Body held(const Shape& shape, Complex position, double orientation = 0.0) {
  Body result = body(shape, position, orientation);
  result.held = true;
  return result;
}

// Returns a scene of loaded and held bodies in an unbounded fluid.
Scene pressed(const std::vector<Body>& bodies, double separation) {
  Scene scene = in_contact(QuiescentFlow{}, bodies, separation);
  scene.gauge_length = 100.0;
  scene.solver.tolerance = 1e-3;
  return scene;
}

// The body would pass a held body within one step: only swept bounding boxes detect the contact.
Finding tunnelling() {
  Scene bullet =
      pressed({pushed(Circle{0.3}, {0.1, 2.0}, {0.0, -100.0}), held(Ellipse{1.5, 0.4}, 0.0)}, 0.05);
  const SuspensionSolver solver(bullet);
  const double speed = std::abs(solver.solve(solver.start()).motions[0].velocity);
  bullet = over(bullet, 4.0 / speed, 4.0 / speed);
  return run(bullet, 1e-3, [&](const RecordedRun& recorded) {
    const bool is_through = recorded.frames.back().bodies[0].position.imag() < 0.0;
    return is_through ? 1.0 : shortfall(bullet, recorded);
  });
}

// Pushes all disks of a square lattice towards its centre.
Finding lattice() {
  constexpr int side = 9;
  constexpr double separation = 0.1;
  std::vector<Body> disks;
  for (int k = 0; k < side * side; ++k) {
    const Complex place{k % side - 0.5 * (side - 1), k / side - 0.5 * (side - 1)};
    disks.push_back(pushed(Circle{0.5}, (1.0 + 1.001 * separation) * place, -10.0 * place));
  }
  Scene crowd = over(in_contact(QuiescentFlow{}, disks, separation), 0.1, 0.1);
  crowd.solver.tolerance = 1e-2;
  return run(crowd, 1e-3, [&](const RecordedRun& recorded) {
    const bool is_crowd = recorded.steps.back().contacts >= 140;
    return is_crowd ? shortfall(crowd, recorded) : unknown;
  });
}

// Runs a heavy ellipse that lies on the floor of a container.
Finding thousand_steps_in_contact() {
  Body heavy = pushed(Ellipse{0.5, 0.3}, {0.1, -1.6}, {0.0, -20.0});
  heavy.orientation = 0.1;
  Scene cell = over(in_contact(QuiescentFlow{}, {heavy}, 0.05), 100.0, 0.1);
  cell.walls = {{.role = WallRole::outer, .shape = Circle{2.0}}};
  cell.solver.tolerance = 1e-3;
  cell.output.dt_write = 1.0;
  return run(cell, 1e-3, [&](const RecordedRun& recorded) { return shortfall(cell, recorded); });
}

// An extension drives two circles together along their line of centres, and only contact stops
// them. Their final gap must be the separation.
Finding head_on() {
  const double separation = 0.1;
  Scene pair = in_contact(ExtensionalFlow{-30.0}, {body(Circle{1.0}, -1.4), body(Circle{1.0}, 1.4)},
                          separation);
  pair.solver.tolerance = 1e-3;
  pair = over(pair, 1.0, 1.0);
  return run(pair, 1e-3, [=](const RecordedRun& recorded) {
    const bool in_one_step = recorded.steps.size() == 1;
    const std::vector<BodyState>& bodies = recorded.frames.back().bodies;
    const double missed =
        std::max(std::abs(bodies[0].position + 1.05), std::abs(bodies[1].position - 1.05)) /
        separation;
    return in_one_step ? missed : unknown;
  });
}

// Returns the sum of the load of a body at rest and the contact forces on it, relative to the load.
double missing_support(const Frame& end, std::size_t body, Complex load) {
  Complex sum = 0.0;
  for (const ContactForce& contact : end.contacts) {
    const bool is_a = !contact.a.is_wall && contact.a.number == body;
    sum += (is_a ? 1.0 : -1.0) * contact.force * contact.normal;
  }
  return std::abs(sum + load) / std::abs(load);
}

// Runs a body that comes to rest at two or more contacts with held bodies. The contacts together
// must carry its load.
Finding resting_on_two(const Body& pressed_body, const std::vector<Body>& held_bodies) {
  std::vector<Body> bodies{pressed_body};
  bodies.insert(bodies.end(), held_bodies.begin(), held_bodies.end());
  const Scene scene = over(pressed(bodies, 0.09), 2.0, 0.1);
  return run(scene, 1e-3, [=](const RecordedRun& recorded) {
    const Frame& end = recorded.frames.back();
    if (end.contacts.size() < 2) return unknown;
    return std::max(shortfall(scene, recorded), missing_support(end, 0, pressed_body.force));
  });
}

Finding valley() {
  const Star star{1.0, 0.45, 3};
  return resting_on_two(pushed(Circle{0.45}, std::polar(1.5, std::numbers::pi / 3),
                               -300.0 * std::polar(1.0, std::numbers::pi / 3)),
                        {held(star, 0.0)});
}

Finding pinch() {
  return resting_on_two(pushed(Circle{0.8}, {0.01, 1.6}, {0.0, -200.0}),
                        {held(Circle{1.0}, {-1.2, 0.0}), held(Circle{1.0}, {1.2, 0.0})});
}

// Runs two ellipses whose long sides face each other. The film between the ellipses is as long as
// they are, and they turn and slide apart.
Finding flat_pair() {
  Scene pair = in_contact(QuiescentFlow{},
                          {pushed(Ellipse{1.0, 0.1}, {0.02, 0.1252}, {0.0, -100.0}),
                           pushed(Ellipse{1.0, 0.1}, {0.0, -0.1252}, {0.0, 100.0})},
                          0.05);
  pair.solver.tolerance = 1e-3;
  pair = over(pair, 1.0, 0.1);
  return run(pair, 1e-3, [=](const RecordedRun& recorded) {
    const bool met = std::ranges::any_of(recorded.steps, &StepInfo::contacts);
    return met ? shortfall(pair, recorded) : unknown;
  });
}

// All bodies of a container turn with it as one body: no gap opens or closes.
Finding turning_crowd() {
  const double gap = 0.021;
  Scene crowd = disk_hexagon(1, gap, 1e-3);
  crowd.flow = QuiescentFlow{};
  crowd.walls = {
      {.role = WallRole::outer, .shape = Circle{3.0 + 2.0 * gap}, .motion = RotatingWall{1.0}}};
  crowd.contact = ContactSettings{0.02};
  crowd = over(crowd, 1.0, 0.1, SteppingMethod::heun);
  return run(crowd, 1e-3, [=](const RecordedRun& recorded) { return shortfall(crowd, recorded); });
}

// Runs the published ellipses by the lagged coupling, with steps of a given length.
HardCase lagged(double dt) {
  return {"12",
          text("48 ellipses in vortices by the lagged coupling, with contact and steps of %g", dt),
          [=] {
            Scene scene = ellipses_in_vortices(1e-2);
            scene.contact = ContactSettings{0.00313};
            scene.solver.coupling = Coupling::local;
            return run(over(scene, 1.0, dt), 1e-2, [](const RecordedRun&) { return unknown; });
          },
          Due::refusal,
          {"lagged coupling diverges", "global"}};
}

}  // namespace

std::vector<HardCase> contacts() {
  return {
      {"10", "a step that would end beyond a held body; shortfall of the separation", tunnelling},
      {"10", "two disks driven through each other by one step; distance from where they must stop",
       head_on},
      {"10", "a disk pressed into the valley of a star; shortfall, and load not carried", valley},
      {"10", "a disk pressed between two others; shortfall, and load not carried", pinch},
      {"10", "two ellipses 10:1 pressed flat on each other; shortfall of the separation",
       flat_pair},
      {"11", "81 disks pressed to a point, 140 contacts; shortfall of the separation", lattice},
      {"11", "a thousand steps at rest in contact; shortfall of the separation",
       thousand_steps_in_contact},
      {"12", "a crowd that fills a container that turns; shortfall of the separation",
       turning_crowd},
      lagged(2.5e-2),
      lagged(2.5e-4),
      lagged(2.5e-6)};
}

}  // namespace stokesbook::verification::hard_cases
