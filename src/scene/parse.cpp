// Reads a scene file: parses its text, sets the values of the command line, and reads all sections:
// the title, [fluid], [flow] and amplitudes here, the others by their keys in parameters.hpp or by
// the functions of sections.hpp.
#include "scene/parse.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/parameters.hpp"
#include "scene/sections.hpp"
#include "text/number_text.hpp"
#include "text/text_file.hpp"

namespace stokesbook {

namespace {

using namespace scene_text;

constexpr Requirement<std::vector<double>> ascending_times{
    "a list of ascending times > 0", [](const std::vector<double>& times) {
      const bool ascending = std::ranges::adjacent_find(times, std::greater_equal{}) == times.end();
      return ascending && (times.empty() || times.front() > 0.0);
    }};

// Reads an oscillation, whose period may be given by its frequency.
OscillatingAmplitude read_oscillation(const Node& node, const Amplitude& kind) {
  auto oscillation = std::get<OscillatingAmplitude>(read_parameters(kind, node, {"frequency"}));
  const TableReader table(node);
  if (const auto frequency = table.get("frequency", positive_number)) {
    table.refuse({"period"}, "give period or frequency, not both");
    oscillation.period = 1.0 / *frequency;
  } else {
    table.require("period", positive_number);
  }
  return oscillation;
}

// Reads [flow] or a term of a sum. A term must have a kind, and none of the other keys of [flow].
BackgroundFlow read_flow(const Node& node, std::vector<std::string_view> others) {
  const TableReader table(node);
  BackgroundFlow flow = others.empty() ? table.require("kind", flow_kinds)
                                       : table.get("kind", flow_kinds, BackgroundFlow{});
  if (std::holds_alternative<SumFlow>(flow)) others.push_back("terms");
  flow = read_parameters(std::move(flow), node, others);
  if (auto* sum = std::get_if<SumFlow>(&flow)) {
    const std::string expected = "a list of flows [{ kind = \"uniform\", ... }, ...]";
    const Node& terms = table.at("terms", expected);
    for (const Node& term : elements_of(terms, expected)) {
      sum->terms.push_back(read_flow(term, {}));
    }
    if (sum->terms.empty()) fail(terms, "must be " + expected);
  }
  // A linear flow is incompressible: div(G x) = tr G = 0, up to rounding.
  if (const auto* linear = std::get_if<LinearFlow>(&flow)) {
    constexpr double rounding = 1e-12;
    const double trace = linear->gradient.trace();
    if (std::abs(trace) > rounding * linear->gradient.cwiseAbs().maxCoeff()) {
      fail(*table.find("gradient"),
           "must have trace 0, as the fluid is incompressible; its trace is " +
               short_number(trace, 6));
    }
  }
  return flow;
}

SceneFile read_root(const Node& node, const std::filesystem::path& directory) {
  const TableReader root(node, {"title", "seed", "fluid", "flow", "cell", "walls", "bodies",
                                "body_lists", "fill", "tracers", "gravity", "magnetic_field",
                                "repulsion", "solver", "time", "contact", "output"});
  SceneFile file;
  auto& [scene, fills] = file;
  scene.title = root.get("title", Requirement<std::string>{"text"}, scene.title);
  scene.seed = static_cast<std::uint64_t>(root.get("seed", any_seed, std::int64_t{0}));
  if (const Node* fluid = root.find("fluid")) {
    const TableReader table(*fluid, {"viscosity"});
    scene.viscosity = table.get("viscosity", positive_number, scene.viscosity);
  }
  scene.walls = read_walls(root, directory);
  const bool enclosed = is_enclosed(scene);
  if (const Node* flow = root.find("flow")) {
    const TableReader table(*flow);
    if (enclosed) {
      table.refuse(
          {"kind", "rate", "velocity", "gradient", "centre", "terms", "amplitude", "gauge_length"},
          "not allowed with an outer wall, which drives the flow; only reverse_at is");
    }
    scene.flow = read_flow(*flow, {"amplitude", "gauge_length", "reverse_at"});
    if (std::holds_alternative<QuiescentFlow>(scene.flow) && root.find("cell") == nullptr) {
      table.refuse({"amplitude"}, "has no effect: give kind, or remove it");
    }
    scene.flow_amplitude = table.get("amplitude", any_amplitude, scene.flow_amplitude);
    scene.gauge_length = table.get("gauge_length", positive_number);
    scene.reverse_at = table.get("reverse_at", ascending_times, scene.reverse_at);
  }
  scene.bodies = read_bodies(root, directory);
  fills = read_fills(root, directory, enclosed);
  scene.tracers = read_tracers(root);
  scene.gravity = root.get("gravity", TableOf<Gravity>{});
  scene.magnetic_field = root.get("magnetic_field", TableOf<MagneticField>{});
  scene.repulsion = root.get("repulsion", TableOf<Repulsion>{});
  scene.solver = root.get("solver", TableOf<SolverSettings>{}, scene.solver);
  scene.time = read_time(root);
  scene = with_matched_tolerances(root, std::move(scene));
  scene.contact = read_contact(root, file);
  scene.output = read_output(root);
  scene.cell = read_cell(root, file);
  if (scene.walls.empty() && scene.bodies.empty() && fills.empty()) {
    fail(node, "a scene must have a wall, a body or a fill: write [[walls]], [[bodies]], ...");
  }
  return file;
}

}  // namespace

Amplitude scene_text::read(const Node& node, const TableOf<Amplitude>&) {
  const TableReader table(node);
  const Amplitude kind = table.require("kind", amplitude_kinds);
  if (std::holds_alternative<OscillatingAmplitude>(kind)) return read_oscillation(node, kind);
  const Amplitude amplitude = read_parameters(kind, node);
  const auto check = [&](const auto& values) {
    if constexpr (requires { values.times; }) {
      if (values.values.size() != values.times.size()) {
        fail(*table.find("values"), "must hold as many numbers as times");
      }
    }
  };
  std::visit(check, amplitude);
  const auto* steps = std::get_if<SteppedAmplitude>(&amplitude);
  if (steps != nullptr && steps->times.front() != 0.0) {
    fail(*table.find("times"), "must begin with 0, at which the first value begins");
  }
  return amplitude;
}

SceneFile read_scene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  const std::optional<std::string> text = read_text_file(path);
  if (!text) throw SceneError(path.string() + ": the file does not exist or cannot be read");
  return parse_scene(*text, path.string(), path.parent_path(), overrides);
}

SceneFile parse_scene(std::string_view text, std::string_view file_name,
                      const std::filesystem::path& directory,
                      std::span<const std::string> overrides) {
  Node document = parse_document(text, file_name);
  for (const std::string& setting : overrides) {
    document = with_override(std::move(document), setting);
  }
  return read_root(document, directory);
}

}  // namespace stokesbook
