// Reads the sections [solver], [time] and [output] of a scene file.
#include <string>

#include "scene/sections.hpp"
#include "text/word_list.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<double> accuracy{"a number from 1e-14 to 0.1",
                                       [](const double& x) { return x >= 1e-14 && x <= 0.1; }};
constexpr Requirement<double> residual{"a number > 0 and < 1",
                                       [](const double& x) { return x > 0.0 && x < 1.0; }};
constexpr Requirement<int> resolution{
    "an integer from 2 to 2000: points along the box's longer side",
    [](const int& k) { return k >= 2 && k <= 2000; }};
constexpr Requirement<double> step_tolerance{
    "a number from 1e-13 to 0.1", [](const double& x) { return x >= 1e-13 && x <= 0.1; }};

FieldSettings read_fields(const Node& node) {
  const TableReader table(node, {"box", "resolution", "quantities"});
  FieldSettings fields;
  fields.box = table.require("box", any_box);
  fields.resolution = table.get("resolution", resolution).value_or(fields.resolution);
  if (const Node* quantities = table.find("quantities")) {
    fields.quantities = read_distinct(*quantities, field_quantities);
  }
  return fields;
}

std::string adaptive_methods() {
  std::vector<std::string_view> names;
  for (const auto& [name, method] : stepping_methods) {
    if (is_embedded(method)) names.push_back(name);
  }
  return joined(names);
}

std::optional<EffortBounds> read_effort(const TableReader& time) {
  const Node* node = time.find("effort");
  if (node == nullptr) return std::nullopt;
  const TableReader table(*node, {"few", "many"});
  const EffortBounds effort{table.require("few", positive_integer),
                            table.require("many", positive_integer)};
  if (effort.few >= effort.many) fail(*table.find("many"), "must be more than few");
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

// Checks dt_min <= dt <= dt_max for the keys that are given.
void check_limits(const TableReader& table, const TimeSettings& time) {
  const auto ordered = [&](std::optional<double> low, std::optional<double> high,
                           std::string_view key, const std::string& problem) {
    if (low && high && *low > *high) fail(*table.find(key), problem);
  };
  ordered(time.dt_min, time.dt, "dt_min", "must be at most time.dt");
  ordered(time.dt_min, time.dt_max, "dt_min", "must be at most time.dt_max");
  ordered(time.dt, time.dt_max, "dt_max", "must be at least time.dt");
}

}  // namespace

SolverSettings read_solver(const TableReader& root) {
  SolverSettings solver;
  const Node* node = root.find("solver");
  if (node == nullptr) return solver;
  const TableReader table(*node, {"tolerance", "gmres_tol", "gmres_max_iterations", "summation",
                                  "near_singular", "preconditioner", "coupling"});
  solver.tolerance = table.get("tolerance", accuracy).value_or(solver.tolerance);
  solver.gmres_tol = table.get("gmres_tol", residual);
  solver.gmres_max_iterations =
      table.get("gmres_max_iterations", positive_integer).value_or(solver.gmres_max_iterations);
  solver.summation = table.get("summation", summations).value_or(solver.summation);
  solver.near_singular =
      table.get("near_singular", near_singular_schemes).value_or(solver.near_singular);
  solver.preconditioner =
      table.get("preconditioner", preconditioners).value_or(solver.preconditioner);
  solver.coupling = table.get("coupling", couplings).value_or(solver.coupling);
  return solver;
}

std::optional<TimeSettings> read_time(const TableReader& root) {
  const Node* node = root.find("time");
  if (node == nullptr) return std::nullopt;
  const TableReader table(*node,
                          {"t_final", "dt", "method", "tolerance", "dt_min", "dt_max", "effort"});
  const bool contact = root.find("contact") != nullptr;
  TimeSettings time;
  time.t_final = table.require("t_final", positive_number);
  const std::optional<SteppingMethod> method = table.get("method", stepping_methods);
  if (contact) time.method = SteppingMethod::heun;
  time.method = method.value_or(time.method);
  if (is_embedded(time.method)) {
    table.refuse({"effort"},
                 "requires a method with fixed steps, such as \"euler\"; this method adapts steps "
                 "to the error");
    time.dt = table.get("dt", positive_number);
    time.tolerance = table.get("tolerance", step_tolerance).value_or(default_step_tolerance);
  } else {
    if (time.method == SteppingMethod::heun && contact) {
      time.tolerance = table.get("tolerance", step_tolerance);
      // Contact with neither method, tolerance nor effort given: Heun's method adapts its steps.
      const bool by_default = !method && table.find("effort") == nullptr;
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
    time.effort = read_effort(table);
    if (!adapts_steps(time) && !time.effort) {
      table.refuse({"dt_max"}, "requires one of " + adaptive_methods() + ", or time.effort");
    }
  }
  time.dt_min = table.get("dt_min", positive_number);
  time.dt_max = table.get("dt_max", positive_number);
  check_limits(table, time);
  for (const std::string_view key : {"dt", "dt_min", "dt_max"}) {
    refuse_endless(table, key, *table.find("t_final"));
  }
  return time;
}

OutputSettings read_output(const TableReader& root) {
  OutputSettings output;
  const Node* node = root.find("output");
  if (node == nullptr) return output;
  const TableReader table(*node, {"dt_write", "formats", "fields"});
  output.dt_write = table.get("dt_write", positive_number);
  if (const Node* time = root.find("time")) {
    refuse_endless(table, "dt_write", *TableReader(*time).find("t_final"));
  }
  if (const Node* formats = table.find("formats")) {
    output.formats = read_distinct(*formats, output_formats);
  }
  if (const Node* fields = table.find("fields")) output.fields = read_fields(*fields);
  return output;
}

}  // namespace stokesbook::scene_text
