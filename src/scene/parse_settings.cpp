// Reads the sections [time], [contact], [cell] and [output] of a scene file. [contact] is checked
// against the bodies and time steps, which must allow contact, and [cell] against all sections.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

#include "scene/parameters.hpp"
#include "scene/sections.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<double> step_tolerance{
    "a number from 1e-13 to 0.1", [](const double& x) { return x >= 1e-13 && x <= 0.1; }};

std::string adaptive_methods() {
  std::vector<std::string_view> names;
  for (const auto& [name, method] : stepping_methods) {
    if (is_embedded(method)) names.push_back(name);
  }
  return joined(names);
}

EffortBounds read_effort(const Node& node) {
  const EffortBounds effort = read(node, TableOf<EffortBounds>{});
  if (effort.few >= effort.many) fail(*TableReader(node).find("many"), "must be more than few");
  return effort;
}

// Refuses a length below 1e-12 t_final: t plus the length must differ from t in floating point, and
// the number of steps or frames must not be too large.
void refuse_endless(const TableReader& table, std::string_view key, const Node& t_final) {
  constexpr double shortest = 1e-12;
  const std::optional<double> length = table.get(key, positive_number);
  if (!length || *length >= shortest * read(t_final, positive_number)) return;
  fail(*table.find(key), "must be at least 1e-12 time.t_final, which is " + t_final.text);
}

// Checks dt_min <= dt <= dt_max for the lengths that are given; a missing one is less than others.
void check_order(const TableReader& table, const TimeSettings& time) {
  const std::optional<double> dt = time.dt, dt_min = time.dt_min, dt_max = time.dt_max;
  if (dt && dt_min > dt) fail(*table.find("dt_min"), "must be at most time.dt");
  if (dt_max && dt_min > dt_max) fail(*table.find("dt_min"), "must be at most time.dt_max");
  if (dt_max && dt > dt_max) fail(*table.find("dt_max"), "must be at least time.dt");
}

const std::string separation = "a number > 0: a length, or node spacings as in \"0.05h\"";

// Returns the number of node spacings in a text such as "0.05h"; not a number for other texts.
double spacings_in(std::string_view text) {
  if (!text.ends_with('h')) return std::nan("");
  return parse_number<double>(text.substr(0, text.size() - 1)).value_or(std::nan(""));
}

ContactSettings read_separation(const Node& node) {
  ContactSettings contact;
  const auto* text = std::get_if<std::string>(&node.value);
  contact.in_spacings = text != nullptr;
  contact.minimum_separation = text ? spacings_in(*text) : value_as<double>(node, separation);
  if (!std::isfinite(contact.minimum_separation) || contact.minimum_separation <= 0.0) {
    fail(node, "must be " + separation);
  }
  return contact;
}

}  // namespace

std::optional<TimeSettings> read_time(const TableReader& root) {
  const Node* node = root.find("time");
  if (node == nullptr) return std::nullopt;
  const TableReader table(*node,
                          {"t_final", "dt", "method", "tolerance", "dt_min", "dt_max", "effort"});
  const bool contact = root.find("contact") != nullptr;
  TimeSettings time;
  time.t_final = table.require("t_final", positive_number);
  time.method = table.get("method", stepping_methods, contact ? SteppingMethod::heun : time.method);
  if (is_embedded(time.method)) {
    table.refuse({"effort"},
                 "requires a method with fixed steps, such as \"euler\"; this method adapts steps "
                 "to the error");
    time.dt = table.get("dt", positive_number);
    time.tolerance = table.get("tolerance", step_tolerance, default_step_tolerance);
  } else {
    if (time.method == SteppingMethod::heun && contact) {
      time.tolerance = table.get("tolerance", step_tolerance);
      // Contact with neither method, tolerance nor effort given: Heun's method adapts its steps.
      const bool by_default = table.find("method") == nullptr && table.find("effort") == nullptr;
      if (by_default && !time.tolerance) time.tolerance = default_contact_step_tolerance;
    } else {
      table.refuse({"tolerance"}, "requires one of " + adaptive_methods() +
                                      ", or heun with [contact]; this method has fixed steps");
    }
    time.dt = table.require("dt", positive_number);
    if (time.tolerance) {
      table.refuse({"effort"},
                   "cannot be combined with time.tolerance, which adapts steps to the error");
    }
    if (const Node* effort = table.find("effort")) time.effort = read_effort(*effort);
    if (!adapts_steps(time) && !time.effort) {
      table.refuse({"dt_max"}, "requires one of " + adaptive_methods() + ", or time.effort");
    }
  }
  time.dt_min = table.get("dt_min", positive_number);
  time.dt_max = table.get("dt_max", positive_number);
  check_order(table, time);
  for (const std::string_view key : {"dt", "dt_min", "dt_max"}) {
    refuse_endless(table, key, *table.find("t_final"));
  }
  return time;
}

Scene with_matched_tolerances(const TableReader& root, Scene scene) {
  if (!scene.time || !scene.time->tolerance) return scene;
  double& solver = scene.solver.tolerance;
  double& step = *scene.time->tolerance;
  constexpr double rounding = 1e-12;
  if (solver <= (1.0 + rounding) * most_solver_over_step * step) return scene;
  const auto find = [&](std::string_view section) {
    const Node* node = root.find(section);
    return node == nullptr ? nullptr : TableReader(*node).find("tolerance");
  };
  const Node* given_solver = find("solver");
  const Node* given_step = find("time");
  if (given_solver != nullptr && given_step != nullptr) {
    fail(*given_solver, "must be at most " + short_number(most_solver_over_step) +
                            " time.tolerance, which is " + given_step->text +
                            ": larger errors of velocities shorten the steps until a run takes a "
                            "hundred times the work");
  }
  if (given_solver != nullptr) {
    step = solver / most_solver_over_step;
  } else {
    solver = most_solver_over_step * step;
  }
  return scene;
}

std::optional<ContactSettings> read_contact(const TableReader& root, const SceneFile& file) {
  const auto& [scene, fills] = file;
  const Node* node = root.find("contact");
  if (node == nullptr) return std::nullopt;
  const TableReader table(*node, {"minimum_separation", "allow_close"});
  const Node& given = table.at("minimum_separation", separation);
  ContactSettings contact = read_separation(given);
  contact.allow_close = table.get("allow_close", any_flag, contact.allow_close);
  if (scene.bodies.empty() && fills.empty()) {
    fail_at_key(*node, "there are no bodies; add [[bodies]] or remove [contact]");
  }
  const auto automatic = std::ranges::count(scene.bodies, automatic_nodes, &Body::n_nodes) +
                         std::ranges::count(fills, automatic_nodes,
                                            [](const Fill& fill) { return fill.body.n_nodes; });
  if (contact.in_spacings && automatic > 0) {
    fail(given,
         "requires numbers for all n_nodes, since h is the node spacing; a body has \"auto\"");
  }
  if (scene.time && scene.time->method != SteppingMethod::euler &&
      scene.time->method != SteppingMethod::heun) {
    fail(*TableReader(*root.find("time")).find("method"),
         "contact is resolved with \"euler\" and \"heun\"");
  }
  return contact;
}

std::optional<CellSettings> read_cell(const TableReader& root, const SceneFile& file) {
  const Scene& scene = file.scene;
  const Node* node = root.find("cell");
  if (node == nullptr) return std::nullopt;
  const CellSettings cell = read(*node, TableOf<CellSettings>{});
  root.refuse({"walls"},
              "not allowed with [cell]: walls do not move with the lattice; a body with "
              "held = true is an obstacle that repeats");
  const auto refuse = [&](std::string_view section, std::initializer_list<std::string_view> keys,
                          const std::string& reason) {
    if (const Node* table = root.find(section)) TableReader(*table).refuse(keys, reason);
  };
  refuse("flow", {"gauge_length"},
         "not allowed with [cell], whose Stokeslets have the mean zero and no gauge");
  if (scene.solver.summation == Summation::direct) {
    refuse("solver", {"summation"}, "not allowed with [cell], whose images the direct sum lacks");
  }
  if (scene.solver.preconditioner == PreconditionerKind::clusters ||
      scene.solver.preconditioner == PreconditionerKind::hierarchical ||
      scene.solver.preconditioner == PreconditionerKind::direct) {
    refuse("solver", {"preconditioner"}, "not supported in a periodic cell yet");
  }
  if (scene.solver.coupling == Coupling::local) {
    refuse("solver", {"coupling"}, "not supported in a periodic cell yet");
  }
  const bool is_linear = std::holds_alternative<QuiescentFlow>(scene.flow) ||
                         std::holds_alternative<ShearFlow>(scene.flow) ||
                         std::holds_alternative<LinearFlow>(scene.flow);
  if (!is_linear) {
    refuse("flow", {"kind"},
           "must be one of quiescent, shear, linear with [cell]: other flows do "
           "not repeat; cell.mean_velocity is a uniform flow");
  }
  if (std::holds_alternative<QuiescentFlow>(scene.flow) && cell.mean_velocity == Complex{} &&
      !cell.pressure_gradient) {
    refuse("flow", {"amplitude"}, "has no effect: give kind, or remove it");
  }
  // The eigenvalues +-sqrt(-det G) of a traceless gradient are real if flow.gradient draws lengths
  // out exponentially.
  const auto* linear = std::get_if<LinearFlow>(&scene.flow);
  const Eigen::Matrix2d g = linear == nullptr ? Eigen::Matrix2d::Zero() : linear->gradient;
  constexpr double rounding = 1e-12;
  if (scene.time && g(0, 1) * g(1, 0) - g(0, 0) * g(1, 1) > rounding * g.squaredNorm()) {
    refuse("flow", {"gradient"},
           "draws the lattice of [cell] out until bodies meet their images: remove [time], or give "
           "a determinant >= 0");
  }
  const TableReader table(*node);
  if (cell.pressure_gradient) {
    table.refuse({"mean_velocity"}, "give mean_velocity or pressure_gradient, not both");
    if (std::ranges::none_of(scene.bodies, &Body::held)) {
      table.refuse({"pressure_gradient"},
                   "requires a body with held = true: without one, the forces on free bodies "
                   "determine the gradient");
    }
  }
  return cell;
}

OutputSettings read_output(const TableReader& root) {
  const Node* node = root.find("output");
  if (node == nullptr) return {};
  const OutputSettings output = read(*node, TableOf<OutputSettings>{});
  if (const Node* time = root.find("time")) {
    refuse_endless(TableReader(*node), "dt_write", *TableReader(*time).find("t_final"));
  }
  return output;
}

}  // namespace stokesbook::scene_text
