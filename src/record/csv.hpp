#pragma once

#include <string>
#include <string_view>

#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// A table of a run, whose numbers restore the values exactly.
struct RunTable {
  const char* name;         ///< name of the file
  std::string_view header;  ///< first line
};

/// @name Tables
/// @{

/// The bodies at the written times.
inline constexpr RunTable trajectory_table{"trajectory.csv",
                                           "t,body,x,y,theta,ux,uy,omega,fx,fy,torque\n"};
/// The walls at the written times.
inline constexpr RunTable walls_table{"walls.csv", "t,wall,fx,fy,torque\n"};
/// The whole suspension at the written times.
inline constexpr RunTable rheology_table{
    "rheology.csv", "t,dissipation,torque_ratio,order_parameter,s11,s12,uniform_x,uniform_y\n"};
/// The contact forces at the written times.
inline constexpr RunTable contacts_table{"contacts.csv", "t,a,b,x,y,nx,ny,force,gap\n"};
/// The steps.
inline constexpr RunTable steps_table{
    "steps.csv",
    "t,dt,gmres_iterations,matvecs,ncp_iterations,contacts,min_gap,residual,velocity_error,"
    "step_error,seconds,kkt_residual,force_imbalance,torque_imbalance,contact_power,"
    "energy_injected\n"};
/// @}

/// @name Rows of the tables, with the columns of the headers
/// @{

/// Writes one line for each body.
std::string trajectory_rows(const Frame& frame);
/// Writes one line for each wall.
std::string wall_rows(const Frame& frame);
/// Writes one line; undefined values are `nan`.
std::string rheology_row(const Frame& frame);
/// Writes one line for each contact; a and b are `body:3` or `wall:0`.
std::string contact_rows(const Frame& frame);
/// Writes one line.
std::string step_row(const StepInfo& step);
/// @}

/// @}

}  // namespace stokesbook
