#include <string>

#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<double> accuracy{"a number from 1e-14 to 0.1",
                                       [](const double& x) { return x >= 1e-14 && x <= 0.1; }};
constexpr Requirement<double> residual{"a number > 0 and < 1",
                                       [](const double& x) { return x > 0.0 && x < 1.0; }};
constexpr Requirement<int> resolution{
    "an integer from 2 to 2000: points along the box's longer side",
    [](const int& k) { return k >= 2 && k <= 2000; }};

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
  const TableReader table(*node, {"t_final", "dt", "method", "tolerance", "dt_min", "dt_max"});
  table.refuse({"tolerance", "dt_min", "dt_max"},
               "not available yet: it belongs to the embedded methods");
  TimeSettings time;
  time.t_final = table.require("t_final", positive_number);
  time.dt = table.require("dt", positive_number);
  time.method = table.get("method", stepping_methods).value_or(time.method);
  return time;
}

OutputSettings read_output(const TableReader& root) {
  OutputSettings output;
  const Node* node = root.find("output");
  if (node == nullptr) return output;
  const TableReader table(*node, {"dt_write", "formats", "fields"});
  output.dt_write = table.get("dt_write", positive_number);
  if (const Node* formats = table.find("formats")) {
    output.formats = read_distinct(*formats, output_formats);
  }
  if (const Node* fields = table.find("fields")) output.fields = read_fields(*fields);
  return output;
}

}  // namespace stokesbook::scene_text
