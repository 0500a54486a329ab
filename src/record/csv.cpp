// Writes the rows of a run's tables as CSV, with numbers that restore the values exactly.
#include "record/csv.hpp"

#include "text/number_text.hpp"

namespace stokesbook {

namespace {

void append_entry(std::string& text, auto number) {
  append_number(text, number + 0);  // -0 becomes 0
}

void append_entry(std::string& text, ContactParty party) {
  text += party.is_wall ? "wall:" : "body:";
  append_number(text, party.number);
}

/// Appends entries with commas between them and ends the line.
void append_row(std::string& text, auto... entries) {
  ((append_entry(text, entries), text += ','), ...);
  text.back() = '\n';
}

}  // namespace

std::string trajectory_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    append_row(rows, frame.t, k, body.position.real(), body.position.imag(), body.orientation,
               body.velocity.real(), body.velocity.imag(), body.omega, body.force.real(),
               body.force.imag(), body.torque);
  }
  return rows;
}

std::string wall_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.walls.size(); ++k) {
    const WallLoad& wall = frame.walls[k];
    append_row(rows, frame.t, k, wall.force.real(), wall.force.imag(), wall.torque);
  }
  return rows;
}

std::string rheology_row(const Frame& frame) {
  const auto& [dissipation, torque_ratio, order_parameter, stresslet, uniform] = frame.rheology;
  std::string row;
  append_row(row, frame.t, dissipation, torque_ratio, order_parameter, stresslet.real(),
             stresslet.imag(), uniform.real(), uniform.imag());
  return row;
}

std::string contact_rows(const Frame& frame) {
  std::string rows;
  for (const ContactForce& contact : frame.contacts) {
    append_row(rows, frame.t, contact.a, contact.b, contact.point.real(), contact.point.imag(),
               contact.normal.real(), contact.normal.imag(), contact.force, contact.gap);
  }
  return rows;
}

std::string step_row(const StepInfo& step) {
  std::string row;
  append_row(row, step.t, step.dt, step.gmres_iterations, step.matvecs, step.ncp_iterations,
             step.contacts, step.min_gap, step.residual, step.velocity_error, step.step_error,
             step.seconds, step.kkt_residual, step.force_imbalance, step.torque_imbalance,
             step.contact_power, step.energy_injected);
  return row;
}

}  // namespace stokesbook
