// Packs the state of a run for its checkpoint, and unpacks it (chapter 12).
#include "suspension/motion/run_state.hpp"

#include <algorithm>

#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// Begins the names of the errors of fields.
constexpr std::string_view field_error = "field_error_";

// Stores any number of vectors in a checkpoint.
void keep(History& history, const std::string& name, const std::vector<VectorXd>& vectors) {
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    history[name + "_" + std::to_string(k)] = vectors[k];
  }
}

std::vector<VectorXd> kept(const History& history, const std::string& name) {
  std::vector<VectorXd> vectors;
  while (true) {
    const auto found = history.find(name + "_" + std::to_string(vectors.size()));
    if (found == history.end()) return vectors;
    vectors.push_back(found->second);
  }
}

VectorXd to_numbers(const std::vector<int>& counts) {
  return VectorXd::NullaryExpr(std::ssize(counts), [&](Eigen::Index k) {
    return static_cast<double>(counts[static_cast<std::size_t>(k)]);
  });
}

std::vector<int> to_counts(const VectorXd& numbers) {
  std::vector<int> counts;
  for (const double number : numbers) counts.push_back(static_cast<int>(number));
  return counts;
}

}  // namespace

std::pair<RunState, RunStatistics> from_checkpoint(const Checkpoint& checkpoint, RunState state,
                                                   RunStatistics statistics) {
  const History& history = checkpoint.history;
  state.now = {checkpoint.t, checkpoint.state, {}};
  state.steps = to_memory(history);
  if (state.closer) state.closer = to_pairs(history.at("closer"));
  state.written = history.at("written")[0];

  auto& [totals, resolution, errors, bound] = statistics;
  totals.steps = checkpoint.step;
  const VectorXd& contact = history.at("contact_totals");
  totals.largest_force_imbalance = contact[0];
  totals.largest_torque_imbalance = contact[1];
  totals.energy_injected = contact[2];
  resolution = {to_counts(history.at("first_nodes")), to_counts(history.at("most_nodes")),
                history.at("largest_estimate")[0]};
  for (const auto& [name, error] : history) {
    if (name.starts_with(field_error)) {
      resolution.field_errors[name.substr(field_error.size())] = error[0];
    }
  }
  errors = history.at("errors");
  resolution.configuration_error = bound.in_units_of_scale(errors);

  SolveMemory& solves = state.solves;
  const std::size_t components = to_configuration(state.now.state).size();
  solves.densities.unpack(kept(history, "density"), components);
  solves.columns.densities.unpack(kept(history, "contact_density"), components);
  solves.columns.loads =
      history.at("contact_loads").reshaped(state.now.state.size(), Eigen::AutoSize);
  solves.columns.flows = history.at("contact_flows");
  std::ranges::copy(kept(history, "contact_velocity"), solves.added.begin());
  for (const double nodes : history.at("nodes_in_contact")) {
    solves.contact_resolutions.push_back({static_cast<int>(nodes), {}});
  }
  solves.steps_kept = static_cast<int>(history.at("steps_in_contact")[0]);
  const VectorXd& tolerances = history.at("contact_tolerances");
  solves.gmres_tolerance = tolerances[0];
  solves.columns.tolerance = tolerances[1];
  solves.error_estimate = history.at("estimate")[0];
  solves.solves_since_estimate = static_cast<int>(history.at("estimate")[1]);
  return {std::move(state), std::move(statistics)};
}

Checkpoint to_checkpoint(const RunState& state, const RunStatistics& statistics) {
  const auto& [totals, resolution, errors, bound] = statistics;
  Checkpoint checkpoint{state.now.t, totals.steps, state.now.state, to_history(state.steps)};
  History& history = checkpoint.history;
  if (state.closer) history["closer"] = to_numbers(*state.closer);
  history["written"] = VectorXd::Constant(1, state.written);

  history["contact_totals"] = VectorXd{
      {totals.largest_force_imbalance, totals.largest_torque_imbalance, totals.energy_injected}};
  history["first_nodes"] = to_numbers(resolution.first_nodes);
  history["most_nodes"] = to_numbers(resolution.most_nodes);
  history["largest_estimate"] = VectorXd::Constant(1, resolution.velocity_error);
  history["errors"] = errors;
  for (const auto& [quantity, error] : resolution.field_errors) {
    history[std::string(field_error) + quantity] = VectorXd::Constant(1, error);
  }

  const SolveMemory& solves = state.solves;
  keep(history, "density", solves.densities.packed());
  keep(history, "contact_density", solves.columns.densities.packed());
  history["contact_loads"] = solves.columns.loads.reshaped();
  history["contact_flows"] = solves.columns.flows;
  keep(history, "contact_velocity", {solves.added.begin(), solves.added.end()});
  VectorXd nodes(static_cast<Eigen::Index>(solves.contact_resolutions.size()));
  std::ranges::transform(solves.contact_resolutions, nodes.begin(), &Resolution::n_nodes);
  history["nodes_in_contact"] = nodes;
  history["steps_in_contact"] = VectorXd::Constant(1, solves.steps_kept);
  history["contact_tolerances"] = VectorXd{{solves.gmres_tolerance, solves.columns.tolerance}};
  history["estimate"] =
      VectorXd{{solves.error_estimate, static_cast<double>(solves.solves_since_estimate)}};
  return checkpoint;
}

}  // namespace stokesbook
