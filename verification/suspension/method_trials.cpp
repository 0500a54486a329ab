// Defines published experiments to run by the published method and by ours, and plots error against
// work and the share of work for equal errors.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "experiments.hpp"
#include "methods.hpp"
#include "scenes.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::suspension {

using namespace study;

namespace {

// Gives bodies the published number of nodes, and ends the run at a time.
Scene until(Scene scene, double t_final, int nodes_a_wall = 256) {
  scene = with_nodes(std::move(scene), 32, nodes_a_wall);
  scene.time = TimeSettings{.t_final = t_final};
  scene.output.dt_write = t_final;
  return scene;
}

Scene by(Scene scene, SteppingMethod method, double dt, double tolerance) {
  scene = with_nodes(std::move(scene), automatic_nodes, automatic_nodes);
  scene.solver = {.tolerance = tolerance};
  scene.solver.preconditioner = PreconditionerKind::block_diagonal;
  scene.time->method = method;
  scene.time->dt = dt;
  return scene;
}

Scene extension() {
  return until(shipped_scene("extension"), 6.0);
}

Scene disks() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  scene.reverse_at = {20.0};
  scene.bodies.assign(2, Body{.shape = Circle{0.5}});
  scene.bodies[0].position = {-8.0, 0.5};
  return until(scene, 40.0);
}

Scene lobed_row() {
  return until(shipped_scene("lobed_row"), 6.0);
}

// The published number of nodes on walls is not known; few nodes are taken here.
Scene injection_and_back() {
  Scene scene = shipped_scene("injection");
  scene.reverse_at = {2.5};
  return until(scene, 5.0, 64);
}

// Ends shortly before the first contact.
Scene vortices() {
  return until(test::ellipses_in_vortices(), 2.0);
}

Scene a_third_of_the_vortices() {
  Scene scene = vortices();
  std::erase_if(scene.bodies,
                [](const Body& body) { return std::abs(body.position.imag()) > 0.5; });
  return scene;
}

// Contact starts early, and lasts.
Scene crowd() {
  return until(shipped_crowd(), 0.5);
}

Scene four_rotors() {
  return until(shipped_scene("rotors"), 10.0);
}

Scene sedimentation() {
  return until(shipped_scene("sedimentation"), 3.0, 128);
}

// Returns a published cell whose bodies keep a separation. Five frames are written.
Scene couette(const std::string& name, double separation) {
  Scene scene = shipped_scene(name);
  scene.contact = ContactSettings{separation};
  scene = until(scene, 1.0);
  scene.output.dt_write = 0.25;
  return scene;
}

Scene dilute_couette() {
  return couette("couette", 0.03);
}

Scene dense_couette() {
  return couette("couette_dense", 0.002);
}

// Returns the mean of cos 2 theta over the bodies at the end.
std::vector<double> alignment(const std::vector<Frame>& frames) {
  return {frames.back().rheology.order_parameter};
}

// Returns the mean of the effective viscosity over the written times.
std::vector<double> mean_viscosity(const std::vector<Frame>& frames) {
  const double sum = std::accumulate(
      frames.begin(), frames.end(), 0.0,
      [](double so_far, const Frame& frame) { return so_far + frame.rheology.torque_ratio; });
  return {sum / static_cast<double>(frames.size())};
}

// The steps are the published steps where these are known. The references use equal steps of
// another length, or another method. Bodies that return to their start need no reference.
const Trial extension_trial{
    .key = "extension",
    .title = "Two disks that meet in extension and slide round each other, at t = 6",
    .error = "largest error of a position or angle, radius 1/2",
    .scene = extension,
    .adapted = SteppingMethod::heun,
    .steps = {0.05, 0.025, 0.0125},
    .tolerances = {0.3, 0.1, 0.03, 0.01},
    .reference = [](Scene scene) { return by(scene, SteppingMethod::heun, 0.005, 1e-6); },
    .least = Size::quick};

const Trial disks_trial{.key = "disks",
                        .title = "Two disks that pass each other in shear, and come back",
                        .error = "largest distance from the start, or angle, radius 1/2",
                        .scene = disks,
                        .adapted = SteppingMethod::dormand_prince54,
                        .steps = {0.04, 0.02, 0.01, 0.005},
                        .tolerances = {0.03, 1e-2, 1e-3, 1e-4},
                        .least = Size::quick};

const Trial lobed_trial{
    .key = "lobed",
    .title = "Eight lobed bodies in shear, kept 0.03 apart, at t = 6",
    .error = "largest error of a position or angle, radius 1/2",
    .scene = lobed_row,
    .adapted = SteppingMethod::heun,
    .steps = {0.1, 0.05, 0.025},
    .tolerances = {0.1, 0.03, 0.01, 3e-3},
    .reference = [](Scene scene) { return by(scene, SteppingMethod::heun, 0.025, 3e-4); }};

const Trial injection_trial{.key = "injection",
                            .title = "Injection through a ring of held disks, and back",
                            .error = "largest distance from the start, or angle",
                            .scene = injection_and_back,
                            .adapted = SteppingMethod::dormand_prince54,
                            .steps = {0.1, 0.05, 0.025},
                            .tolerances = {0.3, 0.1, 1e-2}};

Trial in_vortices(const std::string& key, const std::string& bodies, Scene (*scene)()) {
  return {.key = key,
          .title = bodies + " in Taylor-Green vortices at t = 2",
          .error = "largest error of a position or angle",
          .scene = scene,
          .adapted = SteppingMethod::dormand_prince54,
          .steps = {0.025, 0.0125, 0.00625},
          .tolerances = {0.1, 0.03, 0.01, 3e-3},
          .reference = [](Scene all) { return by(all, SteppingMethod::rk4, 0.05, 1e-5); }};
}

const Trial vortices_trial =
                in_vortices("vortices", "16 of the 48 ellipses", a_third_of_the_vortices),
            all_vortices_trial = in_vortices("all_vortices", "48 ellipses", vortices);

const Trial crowd_trial{
    .key = "crowd",
    .title = "36 ellipses in extension, kept 0.05 apart, at t = 1/2",
    .error = "error of the mean of cos 2θ",
    .scene = crowd,
    .adapted = SteppingMethod::heun,
    .steps = {0.05, 0.025, 0.0125},
    .tolerances = {0.3, 0.1, 0.03},
    .observed = alignment,
    .reference = [](Scene scene) { return by(scene, SteppingMethod::heun, 0.005, 1e-4); }};

Trial by_runge_kutta(const std::string& key, const std::string& title, Scene (*scene)()) {
  return {.key = key,
          .title = title,
          .error = "largest error of a position or angle, radius 1/2",
          .scene = scene,
          .adapted = SteppingMethod::dormand_prince54,
          .steps = {0.1, 0.05, 0.025},
          .tolerances = {0.3, 0.1, 0.03, 0.01},
          .reference = [](Scene all) { return by(all, SteppingMethod::rk4, 0.025, 1e-6); },
          .least = Size::quick};
}

const Trial rotors_trial = by_runge_kutta("rotors", "Four rotors at t = 10", four_rotors),
            sedimentation_trial = by_runge_kutta(
                "sedimentation", "A sedimenting pair in a container at t = 3", sedimentation);

Trial viscosity(const std::string& key, const std::string& title, Scene (*scene)(),
                double longest_step) {
  return {.key = key,
          .title = title,
          .error = "error of the effective viscosity, mean of five times",
          .scene = scene,
          .adapted = SteppingMethod::heun,
          .steps = {longest_step, 0.5 * longest_step, 0.25 * longest_step},
          .tolerances = {0.3, 0.1},
          .observed = mean_viscosity,
          .reference = [](Scene all) {
            all.contact.reset();
            return by(all, SteppingMethod::rk4, 0.05, 1e-5);
          }};
}

// With Euler steps of an eighth, the slender bodies of the dense cell are pressed so hard against
// the outer wall that contact shortens the following steps to thousandths. Steps of a sixteenth
// take less work than any of our runs, with an error hundreds of times as large.
const Trial couette_trial =
                viscosity("couette", "Couette cell with 80 ellipses 3:1, over the first radian",
                          dilute_couette, 0.125),
            dense_couette_trial = viscosity(
                "dense_couette", "Couette cell with 320 ellipses 6:1, over the first radian",
                dense_couette, 0.03125);

Measure points(const Trial& trial, Way way) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Outcome& outcome : outcomes(trial, way, size)) {
      measurements.push_back({.x = outcome.pairs,
                              .error = outcome.error,
                              .operations = outcome.pairs,
                              .seconds = outcome.seconds});
    }
    std::ranges::sort(measurements, {}, &Measurement::x);
    return measurements;
  };
}

Experiment figure(const Trial& trial) {
  return {.key = "methods_" + trial.key,
          .title = trial.title,
          .x = "million node pairs W",
          .error = trial.error,
          .lines = {{.key = "published",
                     .label = "published: equal nodes, Euler",
                     .measure = points(trial, Way::published),
                     .least = trial.least},
                    {.key = "steps",
                     .label = "equal nodes, adapted steps",
                     .measure = points(trial, Way::steps),
                     .least = trial.least},
                    {.key = "ours",
                     .label = "ours: automatic nodes, adapted steps",
                     .measure = points(trial, Way::ours),
                     .least = trial.least}},
          .work_precision = true,
          .operation = "million node pairs"};
}

/// Keeps the runs (listed by decreasing step) that are more accurate than every run with longer
/// steps.
std::vector<Outcome> worth_their_steps(const std::vector<Outcome>& runs) {
  std::vector<Outcome> found;
  for (const Outcome& run : runs) {
    if (found.empty() || run.error < found.back().error) found.push_back(run);
  }
  return found;
}

/// Measures, for the error of each published run, the least cost of our runs that are at least as
/// accurate, relative to the cost of the published run.
Measure shares(const Trial& trial, double Outcome::*cost, Way way) {
  return [=](Size size) {
    const std::vector<Outcome> contenders = outcomes(trial, way, size);
    std::vector<Measurement> measurements;
    for (const Outcome& published : worth_their_steps(outcomes(trial, Way::published, size))) {
      double least = std::numeric_limits<double>::infinity();
      for (const Outcome& ours : contenders) {
        if (ours.error <= published.error) least = std::min(least, ours.*cost);
      }
      measurements.push_back({.x = published.error, .error = least / published.*cost});
    }
    std::ranges::sort(measurements, {}, &Measurement::x);
    return measurements;
  };
}

Line share_of_work(const std::string& id, const std::string& label, const Trial& trial,
                   double share) {
  return {.key = trial.key,
          .label = label,
          .measure = shares(trial, &Outcome::pairs, Way::ours),
          .claim = Claim{.id = id,
                         .statement = "For the error of a published run, " + label +
                                      " take no more than this share of its work.",
                         .law = AtMost{share},
                         .reason = "steps of a higher order, where they are needed; nodes where "
                                   "they are needed",
                         .api = {"stokesbook::Simulation"}},
          .control = Control{"the published method in both places",
                             shares(trial, &Outcome::pairs, Way::published)},
          .least = trial.least};
}

Line share_of_steps(const std::string& label, const Trial& trial) {
  return {.key = trial.key,
          .label = label,
          .measure = shares(trial, &Outcome::steps, Way::ours),
          .least = trial.least};
}

Experiment shares_of_work() {
  return {.key = "methods_work",
          .title = "Our work for the error of a published run, over the work of that run",
          .x = "error of the published run e",
          .error = "node pairs of ours over those of the published run",
          .lines = {share_of_work("12_40", "two disks in extension", extension_trial, 0.6),
                    share_of_work("12_41", "two disks in shear, reversed", disks_trial, 0.6),
                    share_of_work("12_42", "eight lobed bodies in shear", lobed_trial, 0.6),
                    share_of_work("12_43", "injection, reversed", injection_trial, 0.6),
                    share_of_work("12_44", "16 ellipses in vortices", vortices_trial, 0.6),
                    share_of_work("12_45", "viscosity of a Couette cell", couette_trial, 0.5),
                    share_of_work("12_55", "a crowd in extension", crowd_trial, 0.6),
                    share_of_work("12_56", "four rotors", rotors_trial, 0.2),
                    share_of_work("12_57", "a sedimenting pair", sedimentation_trial, 0.25),
                    share_of_work("12_58", "viscosity of a dense Couette cell", dense_couette_trial,
                                  0.95)}};
}

Experiment shares_of_steps() {
  return {.key = "methods_steps",
          .title = "Our steps for the error of a published run, over the steps of that run",
          .x = "error of the published run e",
          .error = "steps of ours over those of the published run",
          .lines = {share_of_steps("two disks in extension", extension_trial),
                    share_of_steps("two disks in shear, reversed", disks_trial),
                    share_of_steps("eight lobed bodies in shear", lobed_trial),
                    share_of_steps("injection, reversed", injection_trial),
                    share_of_steps("16 ellipses in vortices", vortices_trial),
                    share_of_steps("viscosity of a Couette cell", couette_trial),
                    share_of_steps("a crowd in extension", crowd_trial),
                    share_of_steps("four rotors", rotors_trial),
                    share_of_steps("a sedimenting pair", sedimentation_trial),
                    share_of_steps("viscosity of a dense Couette cell", dense_couette_trial)}};
}

}  // namespace

std::vector<Experiment> methods_compared() {
  return {figure(extension_trial),
          figure(disks_trial),
          figure(lobed_trial),
          figure(injection_trial),
          figure(vortices_trial),
          figure(all_vortices_trial),
          figure(couette_trial),
          figure(crowd_trial),
          figure(rotors_trial),
          figure(sedimentation_trial),
          figure(dense_couette_trial),
          shares_of_work(),
          shares_of_steps()};
}

}  // namespace stokesbook::verification::suspension
