// Defines hard instants that have an answer: narrow gaps, slender and lobed bodies, nearby walls,
// lengths and viscosities far from one. Errors are differences from closed forms, from symmetries,
// or from a solution to more digits.
#include <cmath>
#include <numbers>

#include "hard_case.hpp"
#include "support/closed_forms.hpp"
#include "support/eccentric_annulus.hpp"

namespace stokesbook::verification::hard_cases {

using namespace test;
using std::numbers::pi;

namespace {

Measure against(std::size_t component, const RigidMotion& exact, double length = 1.0) {
  return [=](const Solution& solution) {
    return distance_of_motions(solution.motions[component], exact, length);
  };
}

HardCase narrow_gap(double gap) {
  return {"12",
          text("two circles in extension, gap %g of the radius", gap),
          [=] {
            const double speed = CirclePair{1.0, gap}.speed_in_extension(1.0);
            return solve(circles_in_extension(gap, 1e-6), against(1, {speed, 0.0}));
          },
          gap < 1e-6 ? Due::either : Due::answer,
          {"rounding"}};
}

HardCase loaded_needle(double aspect) {
  return {"03", text("an ellipse %.0f:1 pushed and turned", aspect), [=] {
            const Ellipse needle{1.0, 1.0 / aspect};
            const Load load{{0.7, -0.3}, 0.2};
            Body pushed = body(needle, {0.5, 0.8}, 0.3);
            pushed.force = load.force;
            pushed.torque = load.torque;
            Scene alone = scene(QuiescentFlow{}, {pushed}, 1e-6);
            alone.gauge_length = 5.0;
            return solve(alone, against(0, loaded_ellipse(needle, 0.3, load, 1.0, 5.0)));
          }};
}

HardCase needle_in_shear(double aspect) {
  return {"02", text("an ellipse %.0f:1 in shear", aspect), [=] {
            const Ellipse needle{1.0, 1.0 / aspect};
            const double omega = free_ellipse_omega(needle, 0.3, -1.0, 0.0, 0.5);
            return solve(scene(ShearFlow{1.0}, {body(needle, 0.0, 0.3)}, 1e-8),
                         against(0, {0.0, omega}));
          }};
}

// Solves for a rotor near the wall that encloses it.
HardCase near_a_wall(double gap) {
  return {"04",
          text("a turning disk next to its container's wall, gap %g of its radius; "
               "relative error of force and torque",
               gap),
          [=] {
            const EccentricAnnulus annulus{1.0, 3.0, 2.0 - gap, 0.0, {0.0, 1.0}, {0.0, 0.0}};
            const Load exact = inner_load(annulus, 1.0);
            Body rotor = body(Circle{1.0}, annulus.inner_centre);
            rotor.held = true;
            rotor.omega = 1.0;
            Scene cell = scene(QuiescentFlow{}, {rotor}, 1e-6);
            cell.walls = {{.role = WallRole::outer, .shape = Circle{3.0}}};
            return solve(cell, [=](const Solution& solution) {
              const Load& load = solution.loads[0];
              return std::max(std::abs(load.force - exact.force) / std::abs(exact.force),
                              std::abs(load.torque / exact.torque - 1.0));
            });
          }};
}

HardCase in_units(const std::string& what, double length, double viscosity) {
  return {"03", what, [=] {
            const double force = 1.0, gap = 0.1;
            Scene pair = circles_in_extension(gap, 1e-10);
            pair.flow = QuiescentFlow{};
            pair.viscosity = viscosity;
            for (Body& disk : pair.bodies) {
              disk.force = disk.position.real() > 0.0 ? force : -force;
              disk.position *= length;
              disk.shape = Circle{length};
            }
            const double speed = CirclePair{length, gap * length}.speed_of_pull(force, viscosity);
            return solve(pair, against(1, {speed, 0.0}, length));
          }};
}

// Solves for a five-armed star with an arm in the valley between two arms of another star.
HardCase tip_in_valley() {
  return {"06", "a lobe of one star in the valley of another; against more digits", [] {
            const Star star{1.0, 0.25, 5};
            const Scene pair =
                scene(ShearFlow{1.0}, {body(star, 0.0, pi / 5), body(star, 2.05, pi)}, 1e-6);
            return solve(pair, against_finer(pair));
          }};
}

HardCase cornered(int power) {
  return {"01", text("a superellipse of power %.0f, nearly a square, in shear", power), [=] {
            return solve(
                scene(ShearFlow{1.0}, {body(Superellipse{1.0, 1.0, power}, 0.0, 0.4)}, 1e-6),
                against(0, {0.0, -0.5}));  // symmetry: the shape repeats after a quarter turn
          }};
}

// At this gauge length the logarithm of the Stokeslet cancels the drag of a disk, so that a force
// does not move the disk (03.12).
HardCase degenerate_gauge() {
  return {"03", "a pushed disk whose gauge length is degenerate: it must stay", [] {
            Body disk = body(Circle{1.0}, 0.0);
            disk.force = 1.0;
            Scene alone = scene(QuiescentFlow{}, {disk}, 1e-10);
            alone.gauge_length = std::exp(-0.5);
            return solve(alone, against(0, {0.0, 0.0}));
          }};
}

// The walls are two circles, one inside the other, and there are no bodies: the torque is
// 4 pi mu omega / (R1^-2 - R2^-2).
HardCase walls_only() {
  return {"04", "walls and no body; relative error of the torque", [] {
            Scene cell = scene(QuiescentFlow{}, {}, 1e-10);
            cell.walls = {
                {.role = WallRole::outer, .shape = Circle{2.0}, .motion = RotatingWall{1.0}},
                {.role = WallRole::inner, .shape = Circle{1.9}}};
            const double torque = 4.0 * pi / (1.0 / (1.9 * 1.9) - 0.25);
            return solve(cell, [=](const Solution& solution) {
              return std::abs(solution.loads[0].torque / torque - 1.0);
            });
          }};
}

// The flow outside a turning disk is (perp x) / |x|^2: pressure and vorticity vanish.
HardCase stress_at_a_surface() {
  return {"07", "pressure, vorticity and strain 1e-10 from a turning disk", [] {
            Body rotor = body(Circle{1.0}, 0.0);
            rotor.held = true;
            rotor.omega = 1.0;
            Scene alone = scene(QuiescentFlow{}, {rotor}, 1e-8);
            const double rho = 1.0 + 1e-10;
            return solve(alone, [=](const Solution& solution) {
              const SuspensionSolver solver(alone);
              const FlowDerivatives found =
                  solver.derivatives(solution, ComplexVector{{Complex{rho}}})[0];
              const Complex strain{0.0, -2.0 / (rho * rho)};
              return std::max({std::abs(found.pressure), std::abs(found.vorticity),
                               std::abs(found.strain - strain)});
            });
          }};
}

}  // namespace

std::vector<HardCase> answers() {
  std::vector<HardCase> cases;
  for (const double gap : {1e-2, 1e-4, 1e-6, 1e-7, 1e-8}) cases.push_back(narrow_gap(gap));
  for (const double aspect : {10.0, 30.0, 100.0}) cases.push_back(needle_in_shear(aspect));
  for (const double aspect : {10.0, 30.0, 100.0}) cases.push_back(loaded_needle(aspect));
  for (const double gap : {1e-2, 1e-4}) cases.push_back(near_a_wall(gap));
  cases.push_back(tip_in_valley());
  for (const int power : {8, 20}) cases.push_back(cornered(power));
  cases.push_back(in_units("lengths of 1e-6", 1e-6, 1.0));
  cases.push_back(in_units("lengths of 1e6", 1e6, 1.0));
  cases.push_back(in_units("a viscosity of 1e-3", 1.0, 1e-3));
  cases.push_back(in_units("a viscosity of 1e3", 1.0, 1e3));
  cases.push_back(degenerate_gauge());
  cases.push_back(walls_only());
  cases.push_back(stress_at_a_surface());
  return cases;
}

}  // namespace stokesbook::verification::hard_cases
