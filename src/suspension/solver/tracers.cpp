// Advects passive points with the fluid: extends the state of a run and its rate (chapter 12).
#include "suspension/solver/tracers.hpp"

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/solver/fields.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

// Returns the number of a state's entries that belong to components.
Index component_entries(const SuspensionSolver& solver) {
  return 3 * std::ssize(solver.discretisation());
}

VectorXd appended(const VectorXd& components, const ComplexVector& tracers) {
  VectorXd state(components.size() + 2 * tracers.size());
  state << components, interleaved(tracers);
  return state;
}

}  // namespace

VectorXd initial_state(const SuspensionSolver& solver) {
  const Instant instant = solver.start();
  Configuration start = instant.configuration;
  for (std::size_t k = 0; k < start.size(); ++k) start[k].position = instant.path_position(k);
  const std::vector<Complex>& tracers = solver.scene().tracers;
  if (tracers.empty()) return to_state(start);
  const Eigen::Map<const ComplexVector> given(tracers.data(), std::ssize(tracers));
  const auto covering =
      covering_components(start, solver.discretisation(), given, 0.0, instant.cell);
  std::vector<Index> kept;
  for (Index i = 0; i < given.size(); ++i) {
    if (!covering[static_cast<std::size_t>(i)]) kept.push_back(i);
  }
  return appended(to_state(start), given(kept));
}

Configuration configuration_of(const SuspensionSolver& solver, const VectorXd& state) {
  return to_configuration(state.head(component_entries(solver)));
}

ComplexVector tracers_of(const SuspensionSolver& solver, const VectorXd& state) {
  return deinterleaved(state.tail(state.size() - component_entries(solver)));
}

VectorXd to_rate(const Solution& solution) {
  Configuration rate;
  for (const auto& [velocity, omega] : path_motions(solution)) rate.push_back({velocity, omega});
  return to_state(rate);
}

VectorXd with_tracers(const SuspensionSolver& solver, const VectorXd& velocities,
                      const Solution& solution, const VectorXd& state) {
  if (state.size() == velocities.size()) return velocities;
  const auto& [configuration, forcing, cell, shifts] = solution.instant;
  const ComplexVector tracers = tracers_of(solver, state);
  const auto covering =
      covering_components(configuration, solver.discretisation(), tracers, 0.0, cell);
  ComplexVector velocity(tracers.size());
  std::vector<Index> fluid;
  for (Index i = 0; i < tracers.size(); ++i) {
    if (const auto& body = covering[static_cast<std::size_t>(i)]) {
      // Errors have taken the tracer a little way in: the velocity is continuous there.
      const auto& [k, shift] = *body;
      const auto& [u, omega] = solution.motions[k];
      velocity[i] = u + imaginary * omega * (tracers[i] - shift - configuration[k].position);
      if (cell) velocity[i] += forcing.flow * image_velocity(solver.scene(), shift);
    } else {
      fluid.push_back(i);
    }
  }
  velocity(fluid) = solver.velocity(solution, tracers(fluid));
  return appended(velocities, velocity);
}

VectorXd state_rate(const SuspensionSolver& solver, const Solution& solution,
                    const VectorXd& state) {
  return with_tracers(solver, to_rate(solution), solution, state);
}

Configuration admitted_configuration(const SuspensionSolver& solver, double t,
                                     const VectorXd& state) {
  constexpr double accepted_part = 1e-3;
  Configuration configuration = configuration_of(solver, state);
  const ComplexVector tracers = tracers_of(solver, state);
  if (tracers.size() == 0) return configuration;
  const auto covering = covering_components(configuration, solver.discretisation(), tracers,
                                            accepted_part, cell_at(solver.scene(), t));
  for (std::size_t i = 0; i < covering.size(); ++i) {
    if (!covering[i]) continue;
    const ComponentView component = component_of(solver.scene(), covering[i]->component);
    if (component.body == nullptr) continue;
    throw ConfigurationError(at_time(t) + "tracer " + std::to_string(i) + " enters " +
                             component.name() + ": take smaller steps");
  }
  return configuration;
}

}  // namespace stokesbook
