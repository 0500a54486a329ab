// Compares the cost of steps with contact and of steps of the same scenes without contact, in
// matrix-vector products.
#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "crowds.hpp"
#include "experiments.hpp"
#include "scenes.hpp"
#include "support/once.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;
using namespace test;

namespace {

/// The scenes, with their numbers in the table.
enum class Priced { settling = 1, disks, crowds, vortices, dense, rotation };

/// Returns six heavy disks in an elliptic container that turns at the rate 1.
Scene six_disks() {
  std::vector<Body> disks;
  for (int k = 0; k < 6; ++k) {
    disks.push_back(
        {.shape = Circle{0.45}, .position = std::polar(0.98, std::numbers::pi * k / 3)});
  }
  for (Body& disk : disks) disk.force = {0.0, -10.0};
  Scene scene = in_contact(QuiescentFlow{}, disks, 0.05);
  scene.walls = {
      {.role = WallRole::outer, .shape = Ellipse{2.0, 1.5}, .motion = RotatingWall{1.0}}};
  scene.solver.tolerance = 1e-3;
  return scene;
}

std::vector<Scene> scenes_of(Priced priced, Size size) {
  const bool full = size == Size::full;
  const auto until = [](Scene scene, double t_final) {
    scene.time->t_final = t_final;
    return scene;
  };
  switch (priced) {
    case Priced::settling:
      return {until(shipped_scene("settling"), full ? 10.0 : 2.5)};
    case Priced::disks:
      return {over(six_disks(), full ? 20.0 : 2.0, 0.1, SteppingMethod::heun)};
    case Priced::crowds: {
      std::vector<Scene> scenes;
      for (unsigned seed = 2; seed < (full ? 200U : 20U); seed += 9) {
        const auto drive = static_cast<Drive>(seed / crowds % drives);
        scenes.push_back(
            crowded_scene({drive, static_cast<Crowd>(seed % crowds)}, seed, full ? 200 : 10));
      }
      return scenes;
    }
    case Priced::vortices: {
      Scene scene = ellipses_in_vortices(1e-3);
      scene.contact = ContactSettings{0.00313};
      return {over(scene, 30.0, 0.025)};
    }
    case Priced::dense:
      return {until(shipped_scene("couette_dense"), 1.0)};
    case Priced::rotation:
      return {over(turning_ellipses(size), full ? 3.0 : 1.2, 0.3)};
  }
  return {};
}

/// Holds steps and their matrix-vector products.
struct Work {
  double steps = 0.0, products = 0.0;

  double in_a_step() const { return products / steps; }
};

/// Holds the work of all steps in contact, and that of the steps without contact.
struct Price {
  Work in_contact, without;
};

void add(Work& work, const StepInfo& step) {
  work.steps += 1.0;
  work.products += step.matvecs;
}

void add_steps_in_contact(const std::vector<StepInfo>& steps, Work& work) {
  for (const StepInfo& step : steps) {
    if (step.ncp_iterations > 0) add(work, step);
  }
}

/// Runs a scene without contact until its end, or until a gap is less than a tenth of what contact
/// permits. Flows in narrower gaps take ever more nodes, and bodies overlap soon after.
void add_steps_without_contact(Scene scene, Work& work) {
  const double least = scene.contact->minimum_separation / 10.0;
  scene.contact.reset();
  Observer observer;
  observer.step = [&](const StepInfo& step) {
    add(work, step);
    if (step.min_gap < least) throw std::runtime_error("too close for a comparison");
  };
  const SuspensionSolver solver(scene);
  try {
    Simulation(solver, observer).run();
  } catch (const std::exception&) {
  }
}

/// Runs the scenes with contact, and without until bodies nearly touch. The steps without contact
/// are as long as those with contact are on average.
const Price& price(Priced priced, Size size) {
  static Once<std::pair<Priced, Size>, Price> prices;
  return prices({priced, size}, [&] {
    Price result;
    for (Scene scene : scenes_of(priced, size)) {
      const std::vector<StepInfo> steps = recorded_run(scene).steps;
      add_steps_in_contact(steps, result.in_contact);
      scene.time->dt =
          std::min(*scene.time->dt, steps.back().t / static_cast<double>(steps.size()));
      add_steps_without_contact(scene, result.without);
    }
    return result;
  });
}

double with_contact(const Price& price) {
  return price.in_contact.in_a_step();
}
double without_contact(const Price& price) {
  return price.without.in_a_step();
}
double ratio(const Price& price) {
  return with_contact(price) / without_contact(price);
}

Measure over_scenes(double (*quantity)(const Price& price)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Priced priced : {Priced::settling, Priced::disks, Priced::crowds, Priced::vortices,
                                Priced::dense, Priced::rotation}) {
      const bool is_long = priced == Priced::vortices || priced == Priced::dense;
      if (is_long && size == Size::quick) continue;
      measurements.push_back(
          {.x = static_cast<double>(priced), .error = quantity(price(priced, size))});
    }
    return measurements;
  };
}

/// Measures the ratio of a planted defect: contact without a preconditioner, solved to 1e-12. Short
/// runs of three scenes suffice.
std::vector<Measurement> wasteful_ratios(Size) {
  std::vector<Measurement> measurements;
  for (const Priced priced : {Priced::settling, Priced::disks, Priced::crowds}) {
    Work wasted;
    for (Scene scene : scenes_of(priced, Size::quick)) {
      scene.solver.preconditioner = PreconditionerKind::none;
      scene.solver.gmres_tol = 1e-12;
      add_steps_in_contact(recorded_run(scene).steps, wasted);
    }
    measurements.push_back(
        {.x = static_cast<double>(priced),
         .error = wasted.in_a_step() / without_contact(price(priced, Size::quick))});
  }
  return measurements;
}

}  // namespace

Experiment contact_price() {
  return {
      .key = "contact_price",
      .title =
          "Steps with contact and without: settling stars (1), six disks in an elliptic "
          "container that turns (2), random crowds (3), ellipses in vortices (4), the dense "
          "Couette cell (5), ellipses in a circular container that turns (6)",
      .x = "scene s",
      .error = "matrix-vector products of a step, or their ratio",
      .axes = Axes::nominal,
      .lines = {
          {.key = "with", .label = "steps in contact", .measure = over_scenes(with_contact)},
          {.key = "without",
           .label = "steps of the same scene without contact",
           .measure = over_scenes(without_contact)},
          {.key = "ratio",
           .label = "ratio",
           .measure = over_scenes(ratio),
           .claim = Claim{.id = "12_62",
                          .statement = "A step in contact takes at most four times the "
                                       "matrix-vector products of a step without contact, except "
                                       "where the flow without contact is a rigid rotation.",
                          .law = AtMost{4.0},
                          .window = {.to = 5.0},
                          .reason = "the responses of the step before are used again, and one "
                                    "solve corrects their sum; in a rigid rotation (scene 6) a "
                                    "step without contact takes next to no products",
                          .api = {"stokesbook::ContactMobility"}},
           .control =
               Control{"contact without a preconditioner, solved to 1e-12", wasteful_ratios}}}};
}

}  // namespace stokesbook::verification::suspension
