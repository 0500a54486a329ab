#include <algorithm>
#include <string>
#include <variant>

#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<double> accuracy{"a number from 1e-14 to 0.1",
                                       [](const double& x) { return x >= 1e-14 && x <= 0.1; }};
constexpr Requirement<double> residual{"a number > 0 and < 1",
                                       [](const double& x) { return x > 0.0 && x < 1.0; }};
constexpr Words<std::monostate, 2> couplings{{
    {"global", std::monostate{}},
    {"local", not_yet},
}};

std::vector<OutputFormat> read_formats(const Node& node) {
  const std::string expected = "a list of one or more of " + list_of(output_formats);
  std::vector<OutputFormat> formats;
  for (const Node& element : elements_of(node, expected)) {
    const OutputFormat format = read(element, output_formats);
    if (std::ranges::find(formats, format) != formats.end()) fail(element, "is there already");
    formats.push_back(format);
  }
  if (formats.empty()) fail(node, "must be " + expected);
  return formats;
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
  table.get("coupling", couplings);
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
  table.refuse({"fields"}, "not available yet");
  output.dt_write = table.get("dt_write", positive_number);
  if (const Node* formats = table.find("formats")) output.formats = read_formats(*formats);
  return output;
}

}  // namespace stokesbook::scene_text
