#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "record/run_data.hpp"

namespace stokesbook {

/// @name Headers of the tables of a run, whose numbers restore the values exactly
/// @{

/// Header of `trajectory.csv`.
inline constexpr std::string_view trajectory_header = "t,body,x,y,theta,ux,uy,omega,fx,fy,torque\n";
/// More columns of `trajectory.csv`, in scenes with a periodic cell.
inline constexpr std::string_view cell_trajectory_columns = "wrapped_x,wrapped_y\n";
/// Header of `walls.csv`.
inline constexpr std::string_view walls_header = "t,wall,fx,fy,torque\n";
/// Header of `rheology.csv`.
inline constexpr std::string_view rheology_header =
    "t,dissipation,torque_ratio,order_parameter,s11,s12,uniform_x,uniform_y\n";
/// More columns of `rheology.csv`, in scenes with a periodic cell.
inline constexpr std::string_view cell_rheology_columns =
    "stress_11,stress_12,stress_21,stress_22,viscosity,normal_stress_difference,"
    "particle_pressure,dissipation_by_traction,contact_stress_11,contact_stress_12,"
    "contact_stress_22\n";
/// Header of `contacts.csv`.
inline constexpr std::string_view contacts_header = "t,a,b,x,y,nx,ny,force,gap\n";
/// More columns of `contacts.csv`, in scenes with a periodic cell.
inline constexpr std::string_view cell_contacts_columns = "image_1,image_2\n";
/// Header of `tracers.csv`.
inline constexpr std::string_view tracers_header = "t,tracer,x,y\n";
/// Header of `nodes.csv`.
inline constexpr std::string_view nodes_header =
    "t,component,x,y,nx,ny,weight,traction_x,traction_y,density_x,density_y\n";
/// Header of `steps.csv`.
inline constexpr std::string_view steps_header =
    "t,dt,gmres_iterations,matvecs,ncp_iterations,contacts,min_gap,residual,velocity_error,"
    "step_error,seconds,kkt_residual,force_imbalance,torque_imbalance,contact_power,"
    "energy_injected\n";
/// @}

/// Continues a line, a header or a row, by another one.
std::string continued(std::string_view line, std::string_view more);

/// @name Rows of the tables, with the columns of the headers
/// @{

/// Writes one line for each body.
std::string trajectory_rows(const Frame& frame);
/// Writes one line for each wall.
std::string wall_rows(const Frame& frame);
/// Writes one line; undefined values are `nan`.
std::string rheology_row(const Frame& frame);
/// Writes one line for each contact; a and b are `body:3` or `wall:0`. In a periodic cell, each
/// line ends with the image of b.
std::string contact_rows(const Frame& frame);
/// Writes one line for each tracer.
std::string tracer_rows(const Frame& frame);
/// Writes one line for each node; components are numbered by ContactParty::id().
std::string node_rows(const Frame& frame);
/// Writes one line.
std::string step_row(const StepInfo& step);
/// @}

/// A table of numbers that a run has written: columns with names.
struct NumberTable {
  std::filesystem::path path;                ///< file, for messages
  std::vector<std::string> names;            ///< header
  std::vector<std::vector<double>> columns;  ///< one for each name, all of one length

  /// Returns whether the table has a column with a name.
  bool has(std::string_view name) const;

  /// Returns the column with a name.
  /// @throws RecordError when the table has no such column
  const std::vector<double>& operator[](std::string_view name) const;
};

/// Reads a table of numbers as the functions above write it.
/// @throws RecordError when the file cannot be read, a row is not whole, or a cell is no number
NumberTable read_table(const std::filesystem::path& path);

}  // namespace stokesbook
