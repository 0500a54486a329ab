#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string_view>
#include <variant>
#include <vector>

#include "scene/table_reader.hpp"

/// The parameters of flows, wall motions, slips, shapes and amplitudes: one list for reading and
/// writing.
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

/// Key of the only parameter with a default: the centre of a flow is the origin.
inline constexpr std::string_view centre_key = "centre";

/// Calls `visit(key, rule, parameter)` for each parameter of a flow, wall motion, slip, shape or
/// amplitude, in the order of the file. The terms of a SumFlow are not among them, nor are the
/// points of a NodalCurve and the rows of VelocityData, because a scene may give these or a file.
void visit_parameters(auto& kind, const auto& visit) {
  if constexpr (requires { kind.velocity; }) visit("velocity", any_vector, kind.velocity);
  if constexpr (requires { kind.rate; }) visit("rate", any_number, kind.rate);
  if constexpr (requires { kind.gradient; }) visit("gradient", any_gradient, kind.gradient);
  if constexpr (requires { kind.centre; }) visit(centre_key, any_vector, kind.centre);
  if constexpr (requires { kind.omega; }) visit("omega", any_number, kind.omega);
  if constexpr (requires { kind.speed; }) visit("speed", any_number, kind.speed);
  if constexpr (requires { kind.modes; }) visit("modes", squirmer_modes, kind.modes);
  if constexpr (requires { kind.radius; }) visit("radius", positive_number, kind.radius);
  if constexpr (requires { kind.arms; }) visit("amplitude", star_amplitude, kind.amplitude);
  if constexpr (requires { kind.arms; }) visit("arms", positive_integer, kind.arms);
  if constexpr (requires { kind.a, kind.b; }) {
    Complex axes{kind.a, kind.b};
    visit("semi_axes", semi_axes, axes);
    kind.a = axes.real();
    kind.b = axes.imag();
  }
  if constexpr (requires { kind.power; }) visit("power", even_power, kind.power);
  if constexpr (requires { kind.times, kind.values; }) {
    visit("times", amplitude_times, kind.times);
    visit("values", any_numbers, kind.values);
  }
  if constexpr (requires { kind.mean, kind.swing, kind.period, kind.phase; }) {
    visit("mean", any_number, kind.mean);
    visit("amplitude", any_number, kind.swing);
    visit("period", positive_number, kind.period);
    visit("phase", any_number, kind.phase);
  }
}

/// Reads the parameters of a flow, wall motion, slip, shape or amplitude from its table.
/// @param  others  valid keys of the table besides `kind` and the parameters
template <class... Kinds>
std::variant<Kinds...> read_parameters(std::variant<Kinds...> variant, const Node& node,
                                       const std::vector<std::string_view>& others = {}) {
  const auto read_all = [&](auto& kind) {
    std::vector<std::string_view> known{"kind"};
    visit_parameters(kind, [&](auto key, const auto&, const auto&) { known.push_back(key); });
    known.insert(known.end(), others.begin(), others.end());
    const TableReader table(node, known);
    visit_parameters(kind, [&](auto key, const auto& rule, auto& parameter) {
      parameter = key == centre_key ? table.get(key, rule, parameter) : table.require(key, rule);
    });
  };
  std::visit(read_all, variant);
  return variant;
}

}  // namespace stokesbook::scene_text
