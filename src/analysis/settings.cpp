// Changes the settings of a scene on which its accuracy and cost depend.
#include "analysis/settings.hpp"

#include <algorithm>
#include <utility>

#include "scene/words.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

/// Sets the numbers of nodes of all bodies, then of all walls; an empty list makes them automatic.
void set_nodes(Scene& scene, const std::vector<int>& nodes) {
  std::size_t k = 0;
  for (Body& body : scene.bodies) body.n_nodes = nodes.empty() ? automatic_nodes : nodes.at(k++);
  for (Wall& wall : scene.walls) wall.n_nodes = nodes.empty() ? automatic_nodes : nodes.at(k++);
}

/// Sets solver.tolerance, from which all other tolerances of the solver follow.
void set_solver_tolerance(Scene& scene, double tolerance) {
  scene.solver.coupling = Coupling::global;
  scene.solver.tolerance = tolerance;
  scene.solver.gmres_tol.reset();
}

}  // namespace

std::string to_text(const Settings& settings) {
  std::string nodes = "auto";
  if (!settings.nodes.empty()) {
    const auto [least, most] = std::ranges::minmax(settings.nodes);
    nodes = std::to_string(least);
    if (least < most) nodes += " to " + std::to_string(most);
  }
  return std::string(scene_text::name_of(settings.method, scene_text::stepping_methods)) +
         (settings.adaptive ? ", time.tolerance " : ", time.dt ") + short_number(settings.step) +
         ", solver.tolerance " + short_number(settings.solver) + ", n_nodes " + nodes;
}

Scene with_settings(Scene scene, const Settings& settings) {
  TimeSettings time{.t_final = scene.time->t_final, .method = settings.method};
  if (settings.adaptive) {
    time.tolerance = settings.step;
    if (scene.contact) time.dt = scene.time->dt;
  } else {
    time.dt = settings.step;
  }
  scene.time = time;
  set_solver_tolerance(scene, settings.solver);
  set_nodes(scene, settings.nodes);
  return scene;
}

Scene with_tables_only(Scene scene) {
  if (scene.contact && scene.contact->in_spacings) {
    throw SceneError(
        "contact.minimum_separation: must be a length here, since runs with other numbers of nodes "
        "are compared, which change the node spacing");
  }
  scene.output.formats = {OutputFormat::csv};
  scene.output.fields.reset();
  return scene;
}

Scene tightened(Scene scene) {
  const bool writes_tables = std::ranges::count(scene.output.formats, OutputFormat::csv) > 0;
  scene = with_tables_only(std::move(scene));
  if (!writes_tables) {
    throw SceneError("output.formats: must contain \"csv\", since tables of runs are compared");
  }
  TimeSettings& time = *scene.time;
  if (time.effort) {
    throw SceneError(
        "time.effort: the error of steps that are adapted by effort cannot be "
        "estimated; use fixed steps or time.tolerance");
  }
  constexpr double least_step_tolerance = 1e-13, least_solver_tolerance = 1e-12;
  if (adapts_steps(time)) {
    const double tolerance = time.tolerance.value_or(default_step_tolerance);
    time.tolerance = std::max(least_step_tolerance, 0.1 * tolerance);
  } else {
    time.dt = 0.5 * *time.dt;
  }
  if (time.dt_min) time.dt_min = 0.1 * *time.dt_min;
  const double solver = scene.solver.tolerance;
  set_solver_tolerance(scene, std::max(std::min(solver, least_solver_tolerance), 0.01 * solver));
  set_nodes(scene, {});
  return scene;
}

}  // namespace stokesbook
