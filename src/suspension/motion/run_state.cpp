// Packs the state of a run for its checkpoint, and unpacks it (chapter 12).
#include "suspension/motion/run_state.hpp"

#include <algorithm>
#include <map>
#include <string_view>

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// Begins the names of the errors of fields.
constexpr std::string_view field_error = "field_error_";

using History = std::map<std::string, VectorXd>;

VectorXd one(double number) {
  return VectorXd::Constant(1, number);
}

// Stores any number of vectors in a checkpoint.
void add_vectors(History& history, const std::string& name, const std::vector<VectorXd>& vectors) {
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    history[name + "_" + std::to_string(k)] = vectors[k];
  }
}

std::vector<VectorXd> find_vectors(const History& history, const std::string& name) {
  std::vector<VectorXd> vectors;
  while (true) {
    const auto found = history.find(name + "_" + std::to_string(vectors.size()));
    if (found == history.end()) return vectors;
    vectors.push_back(found->second);
  }
}

VectorXd to_numbers(const std::vector<int>& counts) {
  return Eigen::Map<const Eigen::VectorXi>(counts.data(), std::ssize(counts)).cast<double>();
}

std::vector<int> to_counts(const VectorXd& numbers) {
  const Eigen::VectorXi counts = numbers.cast<int>();
  return {counts.begin(), counts.end()};
}

// Packs five numbers for each pair: both components, the image of the second one, and the gap.
VectorXd to_numbers(const CloserGaps& closer) {
  VectorXd numbers(static_cast<Eigen::Index>(5 * closer.size()));
  Eigen::Index i = 0;
  for (const auto& [pair, gap] : closer) {
    numbers.segment<5>(i) << static_cast<double>(pair.a), static_cast<double>(pair.b),
        static_cast<double>(pair.image.first), static_cast<double>(pair.image.second), gap;
    i += 5;
  }
  return numbers;
}

CloserGaps to_closer(const VectorXd& numbers) {
  CloserGaps closer;
  for (Eigen::Index i = 0; i < numbers.size(); i += 5) {
    const auto component = [&](Eigen::Index j) { return static_cast<std::size_t>(numbers[i + j]); };
    const auto index = [&](Eigen::Index j) { return static_cast<std::int64_t>(numbers[i + j]); };
    closer[{component(0), component(1), {index(2), index(3)}}] = numbers[i + 4];
  }
  return closer;
}

void add_steps(History& history, const StepMemory& memory) {
  history["error"] = one(memory.error);
  if (memory.dt) history["dt"] = one(*memory.dt);
  if (memory.previous) {
    history["previous_dt"] = one(memory.previous->dt);
    history["previous_rate"] = memory.previous->rate;
  }
  if (memory.reduced) {
    history["detour_end"] = one(memory.reduced->until);
    history["detour_dt"] = one(memory.reduced->dt_after);
  }
}

StepMemory find_steps(const History& history) {
  const auto number = [&](const char* name) { return history.at(name)[0]; };
  StepMemory memory{.error = number("error")};
  if (history.contains("dt")) memory.dt = number("dt");
  if (history.contains("previous_dt")) {
    memory.previous = PreviousStep{number("previous_dt"), history.at("previous_rate")};
  }
  if (history.contains("detour_end")) {
    memory.reduced = ReducedSteps{number("detour_end"), number("detour_dt")};
  }
  return memory;
}

void add_solves(History& history, const SolveMemory& solves) {
  add_vectors(history, "density", solves.densities.packed());
  add_vectors(history, "stage_deviation", solves.stage_deviations.packed());
  history["stage_dt"] = one(solves.stage_dt);
  if (!solves.motions.empty()) {
    Configuration rate;
    for (const auto& [velocity, omega] : solves.motions) rate.push_back({velocity, omega});
    history["motions"] = to_state(rate);
  }
  add_vectors(history, "contact_density", solves.columns.densities.packed());
  history["contact_loads"] = solves.columns.loads.reshaped();
  history["contact_flows"] = solves.columns.rhs_norms;
  history["contact_time"] = one(solves.columns.t);
  history["drift_load"] = solves.columns.drift.load;
  add_vectors(history, "drift_density", solves.columns.drift.density.packed());
  add_vectors(history, "contact_velocity",
              {solves.contact_velocities.begin(), solves.contact_velocities.end()});
  VectorXd nodes(static_cast<Eigen::Index>(solves.contact_resolutions.size()));
  std::ranges::transform(solves.contact_resolutions, nodes.begin(), &Resolution::n_nodes);
  history["nodes_in_contact"] = nodes;
  history["steps_in_contact"] = one(solves.steps_kept);
  history["contact_tolerances"] = VectorXd{{solves.gmres_tolerance, solves.columns.tolerance}};
  history["estimate"] =
      VectorXd{{solves.error_estimate, static_cast<double>(solves.solves_since_estimate)}};
}

SolveMemory find_solves(const History& history, SolveMemory solves, std::size_t components) {
  solves.densities.unpack(find_vectors(history, "density"), components);
  solves.stage_deviations.unpack(find_vectors(history, "stage_deviation"), components);
  solves.stage_dt = history.at("stage_dt")[0];
  if (const auto motions = history.find("motions"); motions != history.end()) {
    for (const auto& [velocity, omega] : to_configuration(motions->second)) {
      solves.motions.push_back({velocity, omega});
    }
  }
  solves.columns.densities.unpack(find_vectors(history, "contact_density"), components);
  solves.columns.loads = history.at("contact_loads")
                             .reshaped(static_cast<Eigen::Index>(3 * components), Eigen::AutoSize);
  solves.columns.rhs_norms = history.at("contact_flows");
  solves.columns.t = history.at("contact_time")[0];
  solves.columns.drift.load = history.at("drift_load");
  solves.columns.drift.density.unpack(find_vectors(history, "drift_density"), components);
  std::ranges::copy(find_vectors(history, "contact_velocity"), solves.contact_velocities.begin());
  for (const double nodes : history.at("nodes_in_contact")) {
    solves.contact_resolutions.push_back({static_cast<int>(nodes), {}});
  }
  solves.steps_kept = static_cast<int>(history.at("steps_in_contact")[0]);
  const VectorXd& tolerances = history.at("contact_tolerances");
  solves.gmres_tolerance = tolerances[0];
  solves.columns.tolerance = tolerances[1];
  solves.error_estimate = history.at("estimate")[0];
  solves.solves_since_estimate = static_cast<int>(history.at("estimate")[1]);
  return solves;
}

}  // namespace

std::pair<RunState, RunStatistics> from_checkpoint(const Checkpoint& checkpoint, RunState state,
                                                   RunStatistics statistics) {
  const History& history = checkpoint.history;
  state.now = {checkpoint.t, checkpoint.state, {}};
  state.steps = find_steps(history);
  if (state.closer) state.closer = to_closer(history.at("closer"));
  state.last_written = history.at("written")[0];

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

  state.solves = find_solves(history, std::move(state.solves), resolution.first_nodes.size());
  return {std::move(state), std::move(statistics)};
}

Checkpoint to_checkpoint(const RunState& state, const RunStatistics& statistics) {
  const auto& [totals, resolution, errors, bound] = statistics;
  Checkpoint checkpoint{state.now.t, totals.steps, state.now.state, {}};
  History& history = checkpoint.history;
  add_steps(history, state.steps);
  if (state.closer) history["closer"] = to_numbers(*state.closer);
  history["written"] = one(state.last_written);

  history["contact_totals"] = VectorXd{
      {totals.largest_force_imbalance, totals.largest_torque_imbalance, totals.energy_injected}};
  history["first_nodes"] = to_numbers(resolution.first_nodes);
  history["most_nodes"] = to_numbers(resolution.most_nodes);
  history["largest_estimate"] = one(resolution.velocity_error);
  history["errors"] = errors;
  for (const auto& [quantity, error] : resolution.field_errors) {
    history[std::string(field_error) + quantity] = one(error);
  }

  add_solves(history, state.solves);
  return checkpoint;
}

}  // namespace stokesbook
