// Writes the rows of a run's tables as CSV, with numbers that restore the values exactly.
#include "record/csv.hpp"

#include "text/number_text.hpp"

namespace stokesbook {

namespace {

std::string entry(auto number) {
  return exact_number(number + 0);  // -0 becomes 0
}

std::string entry(Complex vector) {
  return entry(vector.real()) + ',' + entry(vector.imag());
}

std::string entry(ContactParty party) {
  return (party.is_wall ? "wall:" : "body:") + exact_number(party.number);
}

/// Returns a line of entries with commas between them.
std::string table_row(const auto&... entries) {
  std::string text = ((entry(entries) + ',') + ...);
  text.back() = '\n';
  return text;
}

}  // namespace

std::string trajectory_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const auto& [position, orientation, velocity, omega, force, torque] = frame.bodies[k];
    rows += table_row(frame.t, k, position, orientation, velocity, omega, force, torque);
  }
  return rows;
}

std::string wall_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.walls.size(); ++k) {
    rows += table_row(frame.t, k, frame.walls[k].force, frame.walls[k].torque);
  }
  return rows;
}

std::string rheology_row(const Frame& frame) {
  const auto& [dissipation, torque_ratio, order_parameter, stresslet, uniform] = frame.rheology;
  return table_row(frame.t, dissipation, torque_ratio, order_parameter, stresslet, uniform);
}

std::string contact_rows(const Frame& frame) {
  std::string rows;
  for (const auto& [a, b, point, normal, force, gap] : frame.contacts) {
    rows += table_row(frame.t, a, b, point, normal, force, gap);
  }
  return rows;
}

std::string tracer_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.tracers.size(); ++k) {
    rows += table_row(frame.t, k, frame.tracers[k]);
  }
  return rows;
}

std::string node_rows(const Frame& frame) {
  std::string rows;
  for (const auto& [component, position, normal, weight, traction, density] : frame.nodes) {
    rows += table_row(frame.t, component.id(), position, normal, weight, traction, density);
  }
  return rows;
}

std::string step_row(const StepInfo& step) {
  return table_row(step.t, step.dt, step.gmres_iterations, step.matvecs, step.ncp_iterations,
                   step.contacts, step.min_gap, step.residual, step.velocity_error, step.step_error,
                   step.seconds, step.kkt_residual, step.force_imbalance, step.torque_imbalance,
                   step.contact_power, step.energy_injected);
}

}  // namespace stokesbook
