// Writes a scene file as TOML, section by section. Defaults are written like given values, and
// numbers so that reading restores them exactly.
#include "scene/write.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdio>
#include <iterator>
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

struct Entry;
using Entries = std::vector<Entry>;

std::string text_of(const Entries& table);
Entries entries_of(const auto& variant, const auto& words);
Entries entries_of(auto section);

// Returns the text of a value that a rule reads; empty for a missing value.
template <class Rule>
std::string text_of(const auto& value, const Rule& rule) {
  using T = std::remove_cvref_t<decltype(value)>;
  if constexpr (requires { rule.is_default_shown; }) {
    const std::string text = text_of(value, rule.rule);
    return rule.is_default_shown || text != text_of(T{}, rule.rule) ? text : "";
  } else if constexpr (requires { value.has_value(); }) {
    return value ? text_of(*value, rule) : "";
  } else if constexpr (std::is_enum_v<T>) {
    return text_of(name_of(value, rule));
  } else if constexpr (requires { rule.words; }) {
    const auto to_text = [&](auto meaning) { return text_of(meaning, rule.words); };
    return std::string("[").append(joined(value, ", ", to_text)) + "]";
  } else if constexpr (std::same_as<Rule, TableOf<Amplitude>>) {
    return text_of(entries_of(value, amplitude_kinds));
  } else if constexpr (std::same_as<Rule, TableOf<T>>) {
    return text_of(entries_of(value));
  } else if constexpr (requires { value.index(); }) {  // a flow, wall motion, slip or shape
    return text_of(entries_of(value, rule));
  } else {
    return text_of(value);
  }
}

// An entry of a table, the text `key = value`. The text is empty if an optional value is missing.
struct Entry {
  Entry(std::string_view key, const auto& value, const auto& rule) : text(text_of(value, rule)) {
    if (!text.empty()) text.insert(0, std::string(key) + " = ");
  }
  Entry(std::string_view key, const auto& value) : Entry(key, value, nullptr) {}

  std::string text;
};

std::string text_of(const Entries& table) {
  return "{ " + joined(table, ", ", &Entry::text) + " }";
}

Entry node_entry(int n_nodes) {
  return n_nodes == automatic_nodes ? Entry("n_nodes", automatic_word) : Entry("n_nodes", n_nodes);
}

// Returns the entries of a section, or the parameters of a flow and the like, without missing ones.
Entries entries_of(auto section) {
  Entries entries;
  visit_keys(section, [&](auto key, const auto& rule, const auto& value) {
    const Entry entry(key, value, rule);
    if (!entry.text.empty()) entries.push_back(entry);
  });
  return entries;
}

// Returns the entries of a flow, wall motion, slip, shape or amplitude. The words are in the order
// of the types.
Entries entries_of(const auto& variant, const auto& words) {
  Entries entries{{"kind", words[variant.index()].name}};
  const auto add_all = [&](const auto& kind) {
    std::ranges::move(entries_of(kind), std::back_inserter(entries));
    if constexpr (requires { kind.points; }) entries.emplace_back("points", kind.points);
    if constexpr (requires { kind.rows; }) entries.emplace_back("rows", kind.rows);
    if constexpr (requires { kind.terms; }) {
      entries.emplace_back("terms", kind.terms, ListOf{words});
    }
  };
  std::visit(add_all, variant);
  return entries;
}

std::string lines(const Entries& entries) {
  std::string text;
  for (const Entry& entry : entries) text += entry.text.empty() ? "" : entry.text + "\n";
  return text;
}

template <class Section>
std::string section(const std::string& name, const std::optional<Section>& section) {
  return section ? "\n[" + name + "]\n" + lines(entries_of(*section)) : "";
}

std::string flow_section(const Scene& scene) {
  return "\n[flow]\n" + (is_enclosed(scene) ? "" : lines(entries_of(scene.flow, flow_kinds))) +
         lines({{"amplitude", scene.flow_amplitude, unless_default(any_amplitude)},
                {"gauge_length", scene.gauge_length},
                {"reverse_at", scene.reverse_at, unless_default(any_numbers)}});
}

std::string section(const Wall& wall) {
  return "\n[[walls]]\n" + lines({{"role", wall.role, wall_roles},
                                  {"shape", wall.shape, shape_kinds},
                                  {"position", wall.position},
                                  {"orientation", wall.orientation},
                                  node_entry(wall.n_nodes),
                                  {"motion", wall.motion, motion_kinds},
                                  {"amplitude", wall.amplitude, unless_default(any_amplitude)}});
}

std::string section(const Body& body) {
  const std::string driving =
      body.held ? lines({{"held", true}, {"velocity", body.velocity}, {"omega", body.omega}})
                : lines({{"force", body.force}, {"torque", body.torque}});
  return "\n[[bodies]]\n" +
         lines({{"shape", body.shape, shape_kinds},
                {"position", body.position},
                {"orientation", body.orientation}}) +
         driving + lines(entries_of(body.loads)) +
         lines({node_entry(body.n_nodes), {"slip", body.slip, slip_kinds}});
}

std::string section(const Fill& fill) {
  std::optional<Entries> region;
  if (fill.box) region = Entries{{"box", *fill.box}};
  return "\n[[fill]]\n" +
         lines({{"shape", fill.body.shape, shape_kinds},
                {"area_fraction", fill.area_fraction},
                {"count", fill.count},
                {"region", region},
                {"clearance", fill.clearance},
                node_entry(fill.body.n_nodes),
                {"slip", fill.body.slip, slip_kinds},
                {"force", fill.body.force, unless_default(any_vector)},
                {"torque", fill.body.torque, unless_default(any_number)}}) +
         lines(entries_of(fill.body.loads));
}

std::string section(const TimeSettings& time) {
  return "\n[time]\n" + lines({{"t_final", time.t_final},
                               {"method", time.method, stepping_methods},
                               {"tolerance", time.tolerance},
                               {"dt", time.dt},
                               {"dt_min", time.dt_min},
                               {"dt_max", time.dt_max},
                               {"effort", time.effort, TableOf<EffortBounds>{}}});
}

std::string section(const ContactSettings& contact) {
  const double number = contact.minimum_separation;
  const Entry separation = contact.in_spacings
                               ? Entry("minimum_separation", toml_value(number) + "h")
                               : Entry("minimum_separation", number);
  return "\n[contact]\n" + lines({separation, {"allow_close", contact.allow_close}});
}

}  // namespace

std::string to_toml(const SceneFile& file) {
  const auto& [scene, fills] = file;
  std::string text = lines({{"title", scene.title}, {"seed", scene.seed}});
  text += "\n[fluid]\n" + lines({{"viscosity", scene.viscosity}});
  text += flow_section(scene) + section("cell", scene.cell);
  for (const Wall& wall : scene.walls) text += section(wall);
  for (const Body& body : scene.bodies) text += section(body);
  for (const Fill& fill : fills) text += section(fill);
  if (!scene.tracers.empty()) text += "\n[[tracers]]\n" + lines({{"points", scene.tracers}});
  text += section("gravity", scene.gravity) + section("magnetic_field", scene.magnetic_field) +
          section("repulsion", scene.repulsion) + section("solver", std::optional(scene.solver));
  if (scene.time) text += section(*scene.time);
  if (scene.contact) text += section(*scene.contact);
  return text + section("output", std::optional(scene.output));
}

}  // namespace stokesbook
