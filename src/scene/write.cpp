// Writes a scene file as TOML, section by section. Defaults are written like given values, and
// numbers so that reading restores them exactly.
#include "scene/write.hpp"

#include <array>
#include <cstdio>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/parameters.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace scene_text {

std::string toml_value(double number) {
  const std::string text = number_text(number);
  // Digits alone would be an integer in TOML, with 64 bits only. A point, an exponent, inf and nan
  // make the text a float.
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string toml_value(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      quoted += {'\\', letter};
    } else if (code < 0x20 || code == 0x7f) {  // TOML requires control characters to be escaped
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\u%04x", static_cast<unsigned>(code));
      quoted += escape.data();
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

}  // namespace scene_text

namespace {

using namespace scene_text;

// Returns a number, a text, a vector, a matrix or a list in TOML's syntax.
std::string text_of(const auto& value) {
  using T = std::remove_cvref_t<decltype(value)>;
  if constexpr (requires { toml_value(value); }) {
    return toml_value(value);
  } else if constexpr (std::same_as<T, Complex>) {
    return text_of(std::array{value.real(), value.imag()});
  } else if constexpr (std::same_as<T, Eigen::Matrix2d>) {
    return text_of(value.rowwise());
  } else {
    const auto to_text = [](const auto& element) { return text_of(element); };
    return std::string("[").append(joined(value, ", ", to_text)) + "]";
  }
}

std::vector<std::string_view> names_of(const auto& meanings, const auto& words) {
  std::vector<std::string_view> names;
  for (const auto meaning : meanings) names.push_back(name_of(meaning, words));
  return names;
}

struct Entry;
using Entries = std::vector<Entry>;

// An entry of a table, the text `key = value`. The text is empty if an optional value is missing.
struct Entry {
  Entry(std::string_view key, const auto& value)
      : text(std::string(key).append(" = ") + text_of(value)) {}
  template <class T>
  Entry(std::string_view key, const std::optional<T>& value)
      : text(value ? Entry(key, *value).text : "") {}
  Entry(std::string_view key, const Entries& table)
      : text(std::string(key).append(" = ") + inline_table(table)) {}
  Entry(std::string_view key, const std::vector<Entries>& tables)
      : text(std::string(key).append(" = [") + joined(tables, ", ", inline_table) + "]") {}

  static std::string inline_table(const Entries& entries) {
    return "{ " + joined(entries, ", ", &Entry::text) + " }";
  }

  std::string text;
};

Entry node_entry(int n_nodes) {
  return n_nodes == automatic_nodes ? Entry("n_nodes", automatic_word) : Entry("n_nodes", n_nodes);
}

// Returns the entries of a flow, wall motion, slip, shape or amplitude. The words are in the order
// of the types.
template <class... Kinds>
Entries entries_of(std::variant<Kinds...> variant, const auto& words) {
  Entries entries{{"kind", words[variant.index()].name}};
  const auto add_all = [&](auto& kind) {
    visit_parameters(kind, [&](auto key, const auto&, const auto& parameter) {
      // A flow about the origin is written without a centre.
      if (key == centre_key && text_of(parameter) == text_of(Complex{})) return;
      entries.emplace_back(key, parameter);
    });
    if constexpr (requires { kind.points; }) entries.emplace_back("points", kind.points);
    if constexpr (requires { kind.rows; }) entries.emplace_back("rows", kind.rows);
    if constexpr (requires { kind.terms; }) {
      std::vector<Entries> terms;
      for (const auto& term : kind.terms) terms.push_back(entries_of(term, words));
      entries.emplace_back("terms", terms);
    }
  };
  std::visit(add_all, variant);
  return entries;
}

Entry amplitude_entry(const Amplitude& amplitude) {
  std::optional<Entries> entries;
  if (amplitude != Amplitude{}) entries = entries_of(amplitude, amplitude_kinds);
  return {"amplitude", entries};
}

std::string lines(const Entries& entries) {
  std::string text;
  for (const Entry& entry : entries) text += entry.text.empty() ? "" : entry.text + "\n";
  return text;
}

std::optional<Entries> slip_entries(const std::optional<Slip>& slip) {
  return slip ? std::optional(entries_of(*slip, slip_kinds)) : std::nullopt;
}

std::string flow_section(const Scene& scene) {
  return "\n[flow]\n" + (is_enclosed(scene) ? "" : lines(entries_of(scene.flow, flow_kinds))) +
         lines({amplitude_entry(scene.flow_amplitude), {"gauge_length", scene.gauge_length}}) +
         (scene.reverse_at.empty() ? "" : lines({{"reverse_at", scene.reverse_at}}));
}

std::string load_lines(const LoadLaws& loads) {
  std::optional<Entries> trap;
  if (loads.trap) {
    trap = Entries{{"stiffness", loads.trap->stiffness}};
    if (loads.trap->centre) trap->emplace_back("centre", *loads.trap->centre);
  }
  std::optional<Complex> moment;
  if (loads.magnetic_moment != Complex{}) moment = loads.magnetic_moment;
  return lines({amplitude_entry(loads.amplitude),
                {"density", loads.density},
                {"trap", trap},
                {"magnetic_moment", moment}});
}

std::string section(const Wall& wall) {
  return "\n[[walls]]\n" + lines({{"role", name_of(wall.role, wall_roles)},
                                  {"shape", entries_of(wall.shape, shape_kinds)},
                                  {"position", wall.position},
                                  {"orientation", wall.orientation},
                                  node_entry(wall.n_nodes),
                                  {"motion", entries_of(wall.motion, motion_kinds)},
                                  amplitude_entry(wall.amplitude)});
}

std::string section(const Body& body) {
  const std::string driving =
      body.held ? lines({{"held", true}, {"velocity", body.velocity}, {"omega", body.omega}})
                : lines({{"force", body.force}, {"torque", body.torque}});
  return "\n[[bodies]]\n" +
         lines({{"shape", entries_of(body.shape, shape_kinds)},
                {"position", body.position},
                {"orientation", body.orientation}}) +
         driving + load_lines(body.loads) +
         lines({node_entry(body.n_nodes), {"slip", slip_entries(body.slip)}});
}

std::string section(const Fill& fill) {
  std::optional<Entries> region;
  if (fill.box) region = Entries{{"box", *fill.box}};
  return "\n[[fill]]\n" +
         lines({{"shape", entries_of(fill.shape, shape_kinds)},
                {"area_fraction", fill.area_fraction},
                {"count", fill.count},
                {"region", region},
                {"clearance", fill.clearance},
                node_entry(fill.n_nodes),
                {"slip", slip_entries(fill.slip)}}) +
         (fill.force == Complex{} ? "" : lines({{"force", fill.force}})) +
         (fill.torque == 0.0 ? "" : lines({{"torque", fill.torque}})) + load_lines(fill.loads);
}

// Returns the sections [gravity], [magnetic_field] and [repulsion] that a scene has.
std::string load_sections_of(const Scene& scene) {
  std::string text;
  if (const auto& gravity = scene.gravity) {
    text += "\n[gravity]\n" + lines({{"acceleration", gravity->acceleration},
                                     {"fluid_density", gravity->fluid_density},
                                     amplitude_entry(gravity->amplitude)});
  }
  if (const auto& magnetic = scene.magnetic_field) {
    text += "\n[magnetic_field]\n" + lines({{"field", magnetic->field},
                                            {"frequency", magnetic->frequency},
                                            amplitude_entry(magnetic->amplitude)});
  }
  if (const auto& repulsion = scene.repulsion) {
    text +=
        "\n[repulsion]\n" + lines({{"strength", repulsion->strength}, {"range", repulsion->range}});
  }
  return text;
}

std::string section(const SolverSettings& solver) {
  return "\n[solver]\n" +
         lines({{"tolerance", solver.tolerance},
                {"gmres_tol", solver.gmres_tol},
                {"gmres_max_iterations", solver.gmres_max_iterations},
                {"summation", name_of(solver.summation, summations)},
                {"near_singular", name_of(solver.near_singular, near_singular_schemes)},
                {"preconditioner", name_of(solver.preconditioner, preconditioners)},
                {"coupling", name_of(solver.coupling, couplings)}});
}

std::string section(const TimeSettings& time) {
  std::optional<Entries> effort;
  if (time.effort) effort = Entries{{"few", time.effort->few}, {"many", time.effort->many}};
  return "\n[time]\n" + lines({{"t_final", time.t_final},
                               {"method", name_of(time.method, stepping_methods)},
                               {"tolerance", time.tolerance},
                               {"dt", time.dt},
                               {"dt_min", time.dt_min},
                               {"dt_max", time.dt_max},
                               {"effort", effort}});
}

std::string section(const ContactSettings& contact) {
  const double number = contact.minimum_separation;
  const Entry separation = contact.in_spacings
                               ? Entry("minimum_separation", toml_value(number) + "h")
                               : Entry("minimum_separation", number);
  return "\n[contact]\n" + lines({separation, {"allow_close", contact.allow_close}});
}

std::string section(const OutputSettings& output) {
  std::optional<Entries> fields;
  if (output.fields) {
    fields = Entries{{"box", output.fields->box},
                     {"resolution", output.fields->resolution},
                     {"quantities", names_of(output.fields->quantities, field_quantities)}};
  }
  return "\n[output]\n" + lines({{"dt_write", output.dt_write},
                                 {"formats", names_of(output.formats, output_formats)},
                                 {"fields", fields},
                                 {"nodes", output.nodes ? std::optional(true) : std::nullopt}});
}

}  // namespace

std::string to_toml(const SceneFile& file) {
  const auto& [scene, fills] = file;
  std::string text = lines({{"title", scene.title}, {"seed", scene.seed}});
  text += "\n[fluid]\n" + lines({{"viscosity", scene.viscosity}});
  text += flow_section(scene);
  for (const Wall& wall : scene.walls) text += section(wall);
  for (const Body& body : scene.bodies) text += section(body);
  for (const Fill& fill : fills) text += section(fill);
  if (!scene.tracers.empty()) text += "\n[[tracers]]\n" + lines({{"points", scene.tracers}});
  text += load_sections_of(scene) + section(scene.solver);
  if (scene.time) text += section(*scene.time);
  if (scene.contact) text += section(*scene.contact);
  return text + section(scene.output);
}

}  // namespace stokesbook
