// Writes the rows of a run's tables as CSV, with numbers that restore the values exactly, and reads
// these tables by columns.
#include "record/csv.hpp"

#include <algorithm>

#include "record/atomic_file.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

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

std::string continued(std::string_view line, std::string_view more) {
  line.remove_suffix(1);  // the end of the line
  return std::string(line) + ',' + std::string(more);
}

std::string trajectory_rows(const Frame& frame) {
  std::string rows;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const auto& [position, orientation, velocity, omega, force, torque] = frame.bodies[k];
    const std::string row =
        table_row(frame.t, k, position, orientation, velocity, omega, force, torque);
    rows += frame.cell ? continued(row, table_row(frame.cell->bodies[k].position)) : row;
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
  const auto& [dissipation, torque_ratio, order_parameter, stresslet, uniform, cell] =
      frame.rheology;
  const std::string row =
      table_row(frame.t, dissipation, torque_ratio, order_parameter, stresslet, uniform);
  if (!cell) return row;
  const Eigen::Matrix2d &stress = cell->stress, &contact = cell->contact_stress;
  return continued(
      row, table_row(stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1), cell->viscosity,
                     cell->normal_stress_difference(), cell->particle_pressure,
                     cell->dissipation_by_traction, contact(0, 0), contact(0, 1), contact(1, 1)));
}

std::string contact_rows(const Frame& frame) {
  std::string rows;
  for (const auto& [a, b, point, normal, force, gap, image, shift] : frame.contacts) {
    const std::string row = table_row(frame.t, a, b, point, normal, force, gap);
    rows += frame.cell ? continued(row, table_row(image.first, image.second)) : row;
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

bool NumberTable::has(std::string_view name) const {
  return std::ranges::find(names, name) != names.end();
}

const std::vector<double>& NumberTable::operator[](std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw RecordError(path, "has no column '" + std::string(name) + "'");
  return columns[static_cast<std::size_t>(found - names.begin())];
}

NumberTable read_table(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  NumberTable table{path, {}, {}};
  for (const std::string_view line : split(text, '\n')) {
    if (line.empty()) continue;  // the end of the file
    const std::vector<std::string_view> cells = split(line, ',');
    if (table.names.empty()) {
      table.names.assign(cells.begin(), cells.end());
      table.columns.resize(cells.size());
      continue;
    }
    if (cells.size() != table.names.size()) throw RecordError(path, "has a row that is not whole");
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto number = parse_number<double>(cells[k]);
      if (!number) {
        throw RecordError(path, "holds '" + std::string(cells[k]) + "' where a number should be");
      }
      table.columns[k].push_back(*number);
    }
  }
  return table;
}

}  // namespace stokesbook
