// Reads the section [flow] of a scene file; each kind of flow has its own reader.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "scene/sections.hpp"
#include "text/number_text.hpp"

namespace stokesbook::scene_text {

namespace {

using FlowReader = BackgroundFlow (*)(const Node&);

constexpr Requirement<std::vector<double>> ascending_times{
    "a list of ascending times > 0", [](const std::vector<double>& times) {
      const bool ascending = std::ranges::adjacent_find(times, std::greater_equal{}) == times.end();
      return ascending && (times.empty() || times.front() > 0.0);
    }};

/// Checks the keys of [flow]: the keys of every kind of flow, and the keys `own` of one kind.
TableReader flow_table(const Node& node, std::initializer_list<std::string_view> own) {
  std::vector<std::string_view> known{"kind", "gauge_length", "reverse_at"};
  known.insert(known.begin() + 1, own);
  return TableReader(node, known);
}

BackgroundFlow read_quiescent(const Node& node) {
  flow_table(node, {});
  return QuiescentFlow{};
}

BackgroundFlow read_uniform(const Node& node) {
  return UniformFlow{flow_table(node, {"velocity"}).require("velocity", any_vector)};
}

template <class Flow>
BackgroundFlow read_with_rate(const Node& node) {
  return Flow{flow_table(node, {"rate"}).require("rate", any_number)};
}

BackgroundFlow read_linear(const Node& node) {
  constexpr double rounding = 1e-12;
  const TableReader table = flow_table(node, {"gradient"});
  const LinearFlow flow{table.require("gradient", any_gradient)};
  // The flow is incompressible: div(G x) = tr G = 0, up to rounding.
  const double trace = flow.gradient.trace();
  if (std::abs(trace) > rounding * flow.gradient.cwiseAbs().maxCoeff()) {
    fail(*table.find("gradient"),
         "must have trace 0, as the fluid is incompressible; its trace is " +
             short_number(trace, 6));
  }
  return flow;
}

constexpr Words<FlowReader, 6> flow_kinds{{
    {"quiescent", read_quiescent},
    {"uniform", read_uniform},
    {"shear", read_with_rate<ShearFlow>},
    {"extensional", read_with_rate<ExtensionalFlow>},
    {"taylor_green", read_with_rate<TaylorGreenFlow>},
    {"linear", read_linear},
}};

BackgroundFlow read_enclosed(const Node& node) {
  flow_table(node, {"rate", "velocity", "gradient"})
      .refuse({"kind", "rate", "velocity", "gradient", "gauge_length"},
              "not allowed with an outer wall, which drives the flow; only reverse_at is");
  return QuiescentFlow{};
}

}  // namespace

FlowSection read_flow(const TableReader& root, bool enclosed) {
  const Node* node = root.find("flow");
  if (node == nullptr) return {};
  const TableReader table(*node);
  const FlowReader read_kind =
      enclosed ? read_enclosed : table.get("kind", flow_kinds, FlowReader{read_quiescent});
  return {read_kind(*node), table.get("gauge_length", positive_number),
          table.get("reverse_at", ascending_times, std::vector<double>{})};
}

}  // namespace stokesbook::scene_text
