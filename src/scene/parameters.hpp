#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <functional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scene/scene.hpp"
#include "scene/table_reader.hpp"
#include "scene/words.hpp"

/// The keys of sections, and the parameters of flows, wall motions, slips, shapes and amplitudes:
/// one list for reading and writing.
namespace stokesbook::scene_text {

/// Lengths of the semi-axes of an ellipse or superellipse.
inline constexpr Requirement<Complex> semi_axes{
    "two numbers > 0", [](const Complex& a) { return a.real() > 0.0 && a.imag() > 0.0; }};

/// Amplitude of a star.
inline constexpr Requirement<double> star_amplitude{
    "a number > -1 and < 1, so that the curve does not meet itself",
    [](const double& amplitude) { return std::abs(amplitude) < 1.0; }};

/// Times of an amplitude.
inline constexpr Requirement<std::vector<double>> amplitude_times{
    "a list of one or more ascending times >= 0", [](const std::vector<double>& times) {
      const bool ascending = std::ranges::adjacent_find(times, std::greater_equal{}) == times.end();
      return ascending && !times.empty() && times.front() >= 0.0;
    }};

/// Power of a superellipse. At the largest power, the rounding of a corner takes about a thousandth
/// of a side. No number of nodes that the solver accepts resolves sharper corners.
inline constexpr Requirement<int> even_power{
    "an even integer from 2 to 1000, for which the curve is analytic",
    [](const int& p) { return p >= 2 && p <= 1000 && p % 2 == 0; }};

/// Amplitudes of a squirmer's modes.
inline constexpr Requirement<std::vector<double>> squirmer_modes{
    "a list of one or more numbers [B_1, B_2, ...]",
    [](const std::vector<double>& modes) { return !modes.empty(); }};

/// Acceleration of gravity.
inline constexpr Requirement<Complex> acceleration{"two numbers [x, y], not both 0",
                                                   [](const Complex& g) { return g != Complex{}; }};

/// Vectors of a periodic cell.
inline constexpr Requirement<Eigen::Matrix2d> cell_vectors{
    "two vectors [[a, b], [c, d]] that are neither zero nor parallel",
    [](const Eigen::Matrix2d& a) {
      constexpr double rounding = 1e-9;
      const double area = a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
      return std::abs(area) > rounding * a.row(0).norm() * a.row(1).norm();
    }};

/// Tolerance of the solver.
inline constexpr Requirement<double> accuracy{
    "a number from 1e-14 to 0.1", [](const double& x) { return x >= 1e-14 && x <= 0.1; }};

/// Resolution of fields.
inline constexpr Requirement<int> resolution{
    "an integer from 2 to 2000: points along the box's longer side",
    [](const int& k) { return k >= 2 && k <= 2000; }};

/// Rule for a table whose keys are those of a section.
template <class Section>
struct TableOf {};

/// Rule for the table of an amplitude.
inline constexpr TableOf<Amplitude> any_amplitude{};

/// Rule for a key that may be missing: then the section keeps its default.
template <class Rule>
struct Optional {
  Rule rule;                     ///< for a value that is given
  bool is_default_shown = true;  ///< whether the default is written to files, too
};

/// Deduces the type of `Optional{rule}`, which Clang 14 does not do by itself.
template <class Rule>
Optional(Rule) -> Optional<Rule>;

/// Makes the rule of a key that is not written to files if it has the default.
template <class Rule>
constexpr Optional<Rule> unless_default(const Rule& rule) {
  return {rule, false};
}

/// Calls `visit(key, rule, value)` for each key of a section, or for each parameter of a flow, wall
/// motion, slip, shape or amplitude, in the order of the file. The terms of a SumFlow are not among
/// them, nor are the points of a NodalCurve and the rows of VelocityData, because a scene may give
/// these or a file.
template <class Section>
void visit_keys(Section& section, const auto& visit) {
  if constexpr (requires { section.velocity; }) visit("velocity", any_vector, section.velocity);
  if constexpr (requires { section.rate; }) visit("rate", any_number, section.rate);
  if constexpr (requires { section.gradient; }) visit("gradient", any_gradient, section.gradient);
  if constexpr (requires { section.centre.real(); }) {
    visit("centre", unless_default(any_vector), section.centre);
  }
  if constexpr (requires { section.omega; }) visit("omega", any_number, section.omega);
  if constexpr (requires { section.speed; }) visit("speed", any_number, section.speed);
  if constexpr (requires { section.modes; }) visit("modes", squirmer_modes, section.modes);
  if constexpr (requires { section.radius; }) visit("radius", positive_number, section.radius);
  if constexpr (requires { section.arms; }) visit("amplitude", star_amplitude, section.amplitude);
  if constexpr (requires { section.arms; }) visit("arms", positive_integer, section.arms);
  if constexpr (requires { section.a, section.b; }) {
    Complex axes{section.a, section.b};
    visit("semi_axes", semi_axes, axes);
    section.a = axes.real();
    section.b = axes.imag();
  }
  if constexpr (requires { section.power; }) visit("power", even_power, section.power);
  if constexpr (requires { section.times, section.values; }) {
    visit("times", amplitude_times, section.times);
    visit("values", any_numbers, section.values);
  }
  if constexpr (requires { section.mean, section.swing, section.period, section.phase; }) {
    visit("mean", Optional{any_number}, section.mean);
    visit("amplitude", Optional{any_number}, section.swing);
    visit("period", Optional{positive_number}, section.period);
    visit("phase", Optional{any_number}, section.phase);
  }
  if constexpr (std::same_as<Section, Trap>) {
    visit("stiffness", positive_number, section.stiffness);
    visit("centre", Optional{any_vector}, section.centre);
  }
  if constexpr (std::same_as<Section, LoadLaws>) {
    visit("amplitude", unless_default(any_amplitude), section.amplitude);
    visit("density", Optional{nonnegative_number}, section.density);
    visit("trap", Optional{TableOf<Trap>{}}, section.trap);
    visit("magnetic_moment", unless_default(any_vector), section.magnetic_moment);
  }
  if constexpr (std::same_as<Section, Gravity>) {
    visit("acceleration", acceleration, section.acceleration);
    visit("fluid_density", nonnegative_number, section.fluid_density);
    visit("amplitude", unless_default(any_amplitude), section.amplitude);
  }
  if constexpr (std::same_as<Section, MagneticField>) {
    visit("field", any_vector, section.field);
    visit("frequency", Optional{any_number}, section.frequency);
    visit("amplitude", unless_default(any_amplitude), section.amplitude);
  }
  if constexpr (std::same_as<Section, Repulsion>) {
    visit("strength", positive_number, section.strength);
    visit("range", positive_number, section.range);
  }
  if constexpr (std::same_as<Section, CellSettings>) {
    visit("vectors", cell_vectors, section.vectors);
    visit("mean_velocity", unless_default(any_vector), section.mean_velocity);
    visit("pressure_gradient", Optional{any_vector}, section.pressure_gradient);
  }
  if constexpr (std::same_as<Section, SolverSettings>) {
    visit("tolerance", Optional{accuracy}, section.tolerance);
    visit("gmres_tol", Optional{proper_fraction}, section.gmres_tol);
    visit("gmres_max_iterations", Optional{positive_integer}, section.gmres_max_iterations);
    visit("summation", Optional{summations}, section.summation);
    visit("near_singular", Optional{near_singular_schemes}, section.near_singular);
    visit("preconditioner", Optional{preconditioners}, section.preconditioner);
    visit("coupling", Optional{couplings}, section.coupling);
  }
  if constexpr (std::same_as<Section, EffortBounds>) {
    visit("few", positive_integer, section.few);
    visit("many", positive_integer, section.many);
  }
  if constexpr (std::same_as<Section, FieldSettings>) {
    visit("box", any_box, section.box);
    visit("resolution", Optional{resolution}, section.resolution);
    visit("quantities", Optional{ListOf{field_quantities}}, section.quantities);
  }
  if constexpr (std::same_as<Section, OutputSettings>) {
    visit("dt_write", Optional{positive_number}, section.dt_write);
    visit("formats", Optional{ListOf{output_formats}}, section.formats);
    visit("fields", Optional{TableOf<FieldSettings>{}}, section.fields);
    visit("nodes", unless_default(any_flag), section.nodes);
  }
}

/// Reads the keys of a section from a table.
template <class Section>
Section read_keys(Section section, const TableReader& table) {
  const auto read_key = [&](auto key, const auto& rule, auto& value) {
    if constexpr (requires { rule.is_default_shown; }) {
      if (const auto given = table.get(key, rule.rule)) value = *given;
    } else {
      value = table.require(key, rule);
    }
  };
  visit_keys(section, read_key);
  return section;
}

/// Reads a section from its table, which must have no other keys.
/// @param  known   further keys of the table, which messages list before those that are visited
/// @param  others  further keys of the table, which messages list after them
template <class Section>
Section read_section(const Node& node, Section section, std::vector<std::string_view> known = {},
                     const std::vector<std::string_view>& others = {}) {
  visit_keys(section, [&](auto key, const auto&, const auto&) { known.push_back(key); });
  known.insert(known.end(), others.begin(), others.end());
  return read_keys(std::move(section), TableReader(node, known));
}

/// Reads the table of a section.
template <class Section>
Section read(const Node& node, const TableOf<Section>&) {
  return read_section(node, Section{});
}

/// Reads the table of an amplitude.
Amplitude read(const Node& node, const TableOf<Amplitude>& rule);

/// Reads the parameters of a flow, wall motion, slip, shape or amplitude from its table.
/// @param  others  valid keys of the table besides `kind` and the parameters
template <class... Kinds>
std::variant<Kinds...> read_parameters(std::variant<Kinds...> variant, const Node& node,
                                       const std::vector<std::string_view>& others = {}) {
  std::visit([&](auto& kind) { kind = read_section(node, kind, {"kind"}, others); }, variant);
  return variant;
}

}  // namespace stokesbook::scene_text
