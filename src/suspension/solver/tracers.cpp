// Advects passive points with the fluid: extends the state of a run and its rate (chapter 12).
#include "suspension/solver/tracers.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>

#include "double_layer/double_layer.hpp"
#include "near_singular/barycentric.hpp"
#include "suspension/bodies/components.hpp"

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

// Finds the components that cover points, by the divisor of the barycentric formula (06.15).
class Cover {
 public:
  Cover(const SuspensionSolver& solver, const Configuration& configuration)
      : configuration_(configuration) {
    for (const auto& discretised : solver.discretisation()) {
      const Curve& curve = discretised->curve;
      const bool encloses = curve.side == Side::fluid_inside;
      radii_.push_back(encloses ? infinite : outer_radius(curve, 0.0));
      signs_.push_back(curve.sign());
      sides_.emplace_back(curve);
    }
  }

  // Returns the component that covers a point; none if the point lies in the fluid. The point is
  // first moved towards the fluid, by a part of its distance from the component's position.
  std::optional<std::size_t> component_at(Complex point, double part = 0.0) const {
    for (std::size_t k = 0; k < configuration_.size(); ++k) {
      const auto [position, orientation] = configuration_[k];
      const Complex arm = (1.0 - signs_[k] * part) * (point - position);
      if (std::abs(arm) > radii_[k]) continue;
      if (!(sides_[k].side(arm * std::polar(1.0, -orientation)) > 0.5)) return k;
    }
    return {};
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  const Configuration& configuration_;
  std::vector<double> radii_, signs_;
  std::vector<Barycentric> sides_;
};

}  // namespace

VectorXd initial_state(const SuspensionSolver& solver) {
  const Configuration start = solver.start().configuration;
  const std::vector<Complex>& given = solver.scene().tracers;
  if (given.empty()) return to_state(start);
  const Cover cover(solver, start);
  std::vector<Complex> kept;
  std::ranges::copy_if(given, std::back_inserter(kept),
                       [&](Complex point) { return !cover.component_at(point); });
  return appended(to_state(start), Eigen::Map<const ComplexVector>(kept.data(), std::ssize(kept)));
}

Configuration configuration_of(const SuspensionSolver& solver, const VectorXd& state) {
  return to_configuration(state.head(component_entries(solver)));
}

ComplexVector tracers_of(const SuspensionSolver& solver, const VectorXd& state) {
  return deinterleaved(state.tail(state.size() - component_entries(solver)));
}

VectorXd to_rate(const Solution& solution) {
  Configuration rate;
  for (const auto& [velocity, omega] : solution.motions) rate.push_back({velocity, omega});
  return to_state(rate);
}

VectorXd with_tracers(const SuspensionSolver& solver, const VectorXd& velocities,
                      const Solution& solution, const VectorXd& state) {
  if (state.size() == velocities.size()) return velocities;
  const Configuration& configuration = solution.instant.configuration;
  const Cover cover(solver, configuration);
  const ComplexVector tracers = tracers_of(solver, state);
  ComplexVector velocity(tracers.size());
  std::vector<Index> fluid;
  for (Index i = 0; i < tracers.size(); ++i) {
    if (const auto k = cover.component_at(tracers[i])) {
      // Errors have taken the tracer a little way in: the velocity is continuous there.
      const auto& [u, omega] = solution.motions[*k];
      velocity[i] = u + imaginary * omega * (tracers[i] - configuration[*k].position);
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
  const Cover cover(solver, configuration);
  for (Index i = 0; i < tracers.size(); ++i) {
    const auto k = cover.component_at(tracers[i], accepted_part);
    if (!k || component_of(solver.scene(), *k).body == nullptr) continue;
    throw ConfigurationError(at_time(t) + "tracer " + std::to_string(i) + " enters " +
                             component_of(solver.scene(), *k).name() + ": take smaller steps");
  }
  return configuration;
}

}  // namespace stokesbook
