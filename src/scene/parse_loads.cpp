// Reads what drives a scene beside its flow and walls: loads on bodies, amplitudes in time, and the
// sections [gravity], [magnetic_field] and [repulsion].
#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "scene/parameters.hpp"
#include "scene/sections.hpp"

namespace stokesbook::scene_text {

namespace {

constexpr Requirement<Complex> acceleration{"two numbers [x, y], not both 0",
                                            [](const Complex& g) { return g != Complex{}; }};

OscillatingAmplitude read_oscillation(const Node& node) {
  const TableReader table(node, {"kind", "mean", "amplitude", "period", "frequency", "phase"});
  OscillatingAmplitude oscillation;
  oscillation.mean = table.get("mean", any_number, oscillation.mean);
  oscillation.swing = table.get("amplitude", any_number, oscillation.swing);
  oscillation.phase = table.get("phase", any_number, oscillation.phase);
  if (const auto frequency = table.get("frequency", positive_number)) {
    table.refuse({"period"}, "give period or frequency, not both");
    oscillation.period = 1.0 / *frequency;
  } else {
    oscillation.period = table.require("period", positive_number);
  }
  return oscillation;
}

Trap read_trap(const Node& node) {
  const TableReader table(node, {"stiffness", "centre"});
  return {table.require("stiffness", positive_number), table.get("centre", any_vector)};
}

}  // namespace

Amplitude read_amplitude(const TableReader& owner) {
  const Node* node = owner.find("amplitude");
  if (node == nullptr) return {};
  const TableReader table(*node);
  const Amplitude kind = table.require("kind", amplitude_kinds);
  if (std::holds_alternative<OscillatingAmplitude>(kind)) return read_oscillation(*node);
  const Amplitude amplitude = read_parameters(kind, *node);
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

LoadLaws read_load_laws(const TableReader& owner, const TableReader& root, bool has_weight) {
  for (const auto& [key, section] :
       {std::pair{"density", "gravity"}, {"magnetic_moment", "magnetic_field"}}) {
    if (root.find(section) != nullptr) continue;
    owner.refuse({key}, "has no effect: write [" + std::string(section) + "], or remove it");
  }
  LoadLaws loads;
  loads.amplitude = read_amplitude(owner);
  if (has_weight && root.find("gravity") != nullptr) {
    loads.density = owner.require("density", nonnegative_number);
  }
  if (const Node* trap = owner.find("trap")) loads.trap = read_trap(*trap);
  loads.magnetic_moment = owner.get("magnetic_moment", any_vector, loads.magnetic_moment);
  return loads;
}

std::optional<Gravity> read_gravity(const TableReader& root) {
  const Node* node = root.find("gravity");
  if (node == nullptr) return {};
  const TableReader table(*node, {"acceleration", "fluid_density", "amplitude"});
  return Gravity{table.require("acceleration", acceleration),
                 table.require("fluid_density", nonnegative_number), read_amplitude(table)};
}

std::optional<MagneticField> read_magnetic_field(const TableReader& root) {
  const Node* node = root.find("magnetic_field");
  if (node == nullptr) return {};
  const TableReader table(*node, {"field", "frequency", "amplitude"});
  return MagneticField{table.require("field", any_vector), table.get("frequency", any_number, 0.0),
                       read_amplitude(table)};
}

std::optional<Repulsion> read_repulsion(const TableReader& root) {
  const Node* node = root.find("repulsion");
  if (node == nullptr) return {};
  const TableReader table(*node, {"strength", "range"});
  return Repulsion{table.require("strength", positive_number),
                   table.require("range", positive_number)};
}

}  // namespace stokesbook::scene_text
