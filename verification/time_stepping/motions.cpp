// Defines the motions of the study: Jeffery's equation, and scenes whose rates come from full
// solves, with exact or very accurate reference solutions.
#include "motions.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "support/known_motions.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/stepping.hpp"
#include "suspension/solver/solver.hpp"
#include "time_stepping/stepper.hpp"

namespace stokesbook::verification::time_stepping {

using Eigen::VectorXd;

namespace {

constexpr double aspect = 3.0;
constexpr double shape_factor = (aspect * aspect - 1.0) / (aspect * aspect + 1.0);

VectorXd one(double number) {
  return VectorXd::Constant(1, number);
}

VectorXd itself(const VectorXd& state) {
  return state;
}

Scene circles(const BackgroundFlow& flow, Complex first, int n_nodes) {
  Scene scene;
  scene.flow = flow;
  for (const Complex position : {first, -first}) {
    scene.bodies.push_back({.shape = Circle{1.0}, .position = position, .n_nodes = n_nodes});
  }
  scene.solver.tolerance = 1e-11;
  return scene;
}

// Returns reference values of the compared quantities. The values are computed by the pair 8(7).
std::map<double, VectorXd> reference(const Motion& motion, double tolerance) {
  const SteppingSettings settings{.method = SteppingMethod::prince_dormand87,
                                  .bound = {tolerance, VectorXd::Ones(motion.start.size())}};
  const Stepper stepper(settings, {motion.rate, motion.rate});
  TimePoint now{0.0, motion.start, motion.rate(0.0, motion.start)};
  StepMemory memory;
  std::map<double, VectorXd> states;
  for (const double t : motion.known_at) {
    while (now.t < t) {
      StepResult taken = stepper.advance(now, std::move(memory), t);
      now = std::move(taken.step.end);
      memory = std::move(taken.memory);
    }
    states[t] = motion.compared(now.state);
  }
  return states;
}

// Returns the motion of all positions and angles of a scene. The reference is known at the end.
Motion solved_motion(const Scene& scene, double t_final) {
  Motion motion{solved_rate(scene), start_of(scene), t_final, {}, itself, {t_final}};
  motion.exact = [end = reference(motion, 1e-9).at(t_final)](double) { return end; };
  return motion;
}

}  // namespace

Motion jeffery_in_shear(double t_final, double t_start) {
  const Rate rate = [](double, const VectorXd& q) {
    return one(-0.5 + 0.5 * shape_factor * std::cos(2.0 * q[0]));
  };
  const auto exact = [=](double t) { return one(test::jeffery_angle(aspect, t_start + t)); };
  return {rate, exact(0.0), t_final, exact, itself};
}

Motion jeffery_in_extension(double t_final) {
  const Rate rate = [](double, const VectorXd& q) {
    return one(-shape_factor * std::sin(2.0 * q[0]));
  };
  const double start = 1.2;
  const auto exact = [=](double t) {
    return one(std::atan(std::tan(start) * std::exp(-2.0 * shape_factor * t)));
  };
  return {rate, one(start), t_final, exact, itself};
}

Motion approaching_circles(double t_final) {
  const Scene scene = circles(ExtensionalFlow{-1.0}, -2.0, 96);
  return {solved_rate(scene), start_of(scene), t_final,
          [](double t) { return one(test::circle_distance(4.0, t)); },
          [](const VectorXd& q) { return one(q[3] - q[0]); }};
}

Scene passing_circles() {
  return circles(ShearFlow{1.0}, {-4.0, 0.75}, 48);
}

Motion passing() {
  const Scene scene = passing_circles();
  Motion motion{solved_rate(scene), start_of(scene), 12.0, {}, [](const VectorXd& q) -> VectorXd {
                  return q.head(3);
                }};
  for (double t = 0.5; t <= 12.0; t += 0.5) motion.known_at.push_back(t);
  static const std::map<double, VectorXd> states = [&] {
    auto known = reference(motion, 1e-12);
    known[12.0] << 5.05560884029, 0.73856191218, -5.92487175825;
    return known;
  }();
  motion.exact = [](double t) { return states.at(t); };
  return motion;
}

Motion nine_circles() {
  Scene scene;
  scene.flow = ShearFlow{1.0};
  for (int k = 0; k < 9; ++k) {
    scene.bodies.push_back({.shape = Circle{0.5},
                            .position = {1.5 * (k % 3 - 1) + 0.1 * k, 1.4 * (k / 3 - 1)},
                            .n_nodes = 24});
  }
  scene.solver.tolerance = 1e-6;  // looser near corrections would make the rates jump
  scene.solver.gmres_tol = 1e-10;
  return solved_motion(scene, 2.0);
}

Motion couette_cell() {
  Scene scene;
  scene.walls.push_back({WallRole::outer, Circle{2.5}, {}, 0.0, 80, RotatingWall{1.0}});
  scene.walls.push_back({WallRole::inner, Circle{1.0}, {}, 0.0, 64, {}});
  for (int k = 0; k < 6; ++k) {
    scene.bodies.push_back({.shape = Ellipse{0.3, 0.15},
                            .position = std::polar(1.6 + 0.1 * (k % 3), 1.05 * k),
                            .orientation = 0.7 * k,
                            .n_nodes = 32});
  }
  scene.solver.tolerance = 1e-6;
  scene.solver.gmres_tol = 1e-10;
  return solved_motion(scene, 1.0);
}

Rate solved_rate(const Scene& scene) {
  const auto solver = std::make_shared<SuspensionSolver>(scene);
  const Resolutions first = resolutions_of(solver->solve(solver->start()).discretisation);
  return [=](double, const VectorXd& state) {
    try {
      return to_rate(solver->solve_nearby(solver->instant(to_configuration(state)), first));
    } catch (const SolverError& refusal) {  // bodies overlap, or are too close for their nodes
      throw InadmissibleState(refusal.what());
    }
  };
}

VectorXd start_of(const Scene& scene) {
  return to_state(SuspensionSolver(scene).start().configuration);
}

}  // namespace stokesbook::verification::time_stepping
