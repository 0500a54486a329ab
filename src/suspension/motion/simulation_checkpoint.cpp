// What a simulation goes on from after an interruption.
#include <algorithm>

#include "suspension/bodies/state.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/motion/stepping.hpp"

namespace stokesbook {

using Eigen::VectorXd;

namespace {

// Names of errors of fields begin with this.
constexpr std::string_view field_error = "field_error_";

// Vectors of any number in a checkpoint.
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

void Simulation::resume(const Checkpoint& checkpoint) {
  now_ = {checkpoint.t, checkpoint.state, {}};
  totals_.steps = checkpoint.step;
  const VectorXd& contact = checkpoint.history.at("contact_totals");
  totals_.largest_force_imbalance = contact[0];
  totals_.largest_torque_imbalance = contact[1];
  totals_.energy_injected = contact[2];
  resolution_ = {to_counts(checkpoint.history.at("first_nodes")),
                 to_counts(checkpoint.history.at("most_nodes")),
                 checkpoint.history.at("largest_estimate")[0]};
  for (const auto& [name, error] : checkpoint.history) {
    if (name.starts_with(field_error)) {
      resolution_.field_errors[name.substr(field_error.size())] = error[0];
    }
  }
  errors_ = checkpoint.history.at("errors");
  resolution_.configuration_error = stepping_.bound.in_units_of_scale(errors_);
  memory_ = to_memory(checkpoint.history);
  written_ = checkpoint.history.at("written")[0];
  const std::size_t components = to_configuration(now_.state).size();
  latest_.densities.unpack(kept(checkpoint.history, "density"), components);
  latest_.contacts.densities.unpack(kept(checkpoint.history, "contact_density"), components);
  latest_.contacts.loads =
      checkpoint.history.at("contact_loads").reshaped(now_.state.size(), Eigen::AutoSize);
  latest_.contacts.flows = checkpoint.history.at("contact_flows");
  std::ranges::copy(kept(checkpoint.history, "contact_velocity"), latest_.added.begin());
  for (const double nodes : checkpoint.history.at("nodes_in_contact")) {
    latest_.in_contact.push_back({static_cast<int>(nodes), {}});
  }
  latest_.kept = static_cast<int>(checkpoint.history.at("steps_in_contact")[0]);
  const VectorXd& tolerances = checkpoint.history.at("contact_tolerances");
  latest_.gmres_tolerance = tolerances[0];
  latest_.contacts.tolerance = tolerances[1];
  latest_.error_estimate = checkpoint.history.at("estimate")[0];
  latest_.since = static_cast<int>(checkpoint.history.at("estimate")[1]);
  if (contact_) closer_ = to_pairs(checkpoint.history.at("closer"));
}

// The step under way is taken again after a resume: what it computes is the same to the last bit.
// Counts of work are left out, since that of this step would count twice.
Checkpoint Simulation::checkpoint() const {
  Checkpoint checkpoint{now_.t, totals_.steps, now_.state, to_history(memory_)};
  checkpoint.history["contact_totals"] = VectorXd{
      {totals_.largest_force_imbalance, totals_.largest_torque_imbalance, totals_.energy_injected}};
  checkpoint.history["first_nodes"] = to_numbers(resolution_.first_nodes);
  checkpoint.history["most_nodes"] = to_numbers(resolution_.most_nodes);
  checkpoint.history["largest_estimate"] = VectorXd::Constant(1, resolution_.velocity_error);
  checkpoint.history["errors"] = errors_;
  for (const auto& [quantity, error] : resolution_.field_errors) {
    checkpoint.history[std::string(field_error) + quantity] = VectorXd::Constant(1, error);
  }
  checkpoint.history["written"] = VectorXd::Constant(1, written_);
  checkpoint.history["estimate"] =
      VectorXd{{begun_.error_estimate, static_cast<double>(begun_.since)}};
  keep(checkpoint.history, "density", begun_.densities.packed());
  keep(checkpoint.history, "contact_density", begun_.contacts.densities.packed());
  checkpoint.history["contact_loads"] = begun_.contacts.loads.reshaped();
  checkpoint.history["contact_flows"] = begun_.contacts.flows;
  keep(checkpoint.history, "contact_velocity", {begun_.added.begin(), begun_.added.end()});
  VectorXd nodes(static_cast<Eigen::Index>(begun_.in_contact.size()));
  std::ranges::transform(begun_.in_contact, nodes.begin(), &Resolution::n_nodes);
  checkpoint.history["nodes_in_contact"] = nodes;
  checkpoint.history["steps_in_contact"] = VectorXd::Constant(1, begun_.kept);
  checkpoint.history["contact_tolerances"] =
      VectorXd{{begun_.gmres_tolerance, begun_.contacts.tolerance}};
  if (contact_) checkpoint.history["closer"] = to_numbers(closer_);
  return checkpoint;
}

}  // namespace stokesbook
