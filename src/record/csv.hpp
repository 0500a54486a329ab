#pragma once

#include <string>
#include <string_view>

#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// @name Headers of the tables of a run, whose numbers restore the values exactly
/// @{

/// Header of `trajectory.csv`.
inline constexpr std::string_view trajectory_header = "t,body,x,y,theta,ux,uy,omega,fx,fy,torque\n";
/// Header of `walls.csv`.
inline constexpr std::string_view walls_header = "t,wall,fx,fy,torque\n";
/// Header of `rheology.csv`.
inline constexpr std::string_view rheology_header =
    "t,dissipation,torque_ratio,order_parameter,s11,s12,uniform_x,uniform_y\n";
/// Header of `contacts.csv`.
inline constexpr std::string_view contacts_header = "t,a,b,x,y,nx,ny,force,gap\n";
/// Header of `steps.csv`.
inline constexpr std::string_view steps_header =
    "t,dt,gmres_iterations,matvecs,ncp_iterations,contacts,min_gap,residual,velocity_error,"
    "step_error,seconds,kkt_residual,force_imbalance,torque_imbalance,contact_power,energy_"
    "injected\n";
/// @}

/// Writes the bodies of a frame.
///
/// @param  frame  configuration at a written time
/// @return        one line for each body, with the columns of trajectory_header
std::string trajectory_rows(const Frame& frame);

/// Writes the walls of a frame.
///
/// @param  frame  configuration at a written time
/// @return        one line for each wall, with the columns of walls_header
std::string wall_rows(const Frame& frame);

/// Writes the rheology of a frame.
///
/// @param  frame  configuration with its rheology
/// @return        one line with the columns of rheology_header; undefined values are `nan`
std::string rheology_row(const Frame& frame);

/// Writes the contacts of a frame.
///
/// @param  frame  configuration at a written time
/// @return        one line for each contact, with the columns of contacts_header; a and b are
///                `body:3` or `wall:0`
std::string contact_rows(const Frame& frame);

/// Writes a step.
///
/// @param  step  results of the step
/// @return       one line with the columns of steps_header
std::string step_row(const StepInfo& step);

/// @}

}  // namespace stokesbook
