#pragma once

#include <string>
#include <string_view>

#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// @name The tables of a run: a header line, then rows of numbers that restore the values exactly
/// @{
inline constexpr std::string_view trajectory_header = "t,body,x,y,theta,ux,uy,omega,fx,fy,torque\n";
inline constexpr std::string_view walls_header = "t,wall,fx,fy,torque\n";
inline constexpr std::string_view steps_header =
    "t,dt,gmres_iterations,matvecs,ncp_iterations,contacts,min_gap,residual,error_estimate,"
    "seconds\n";
/// @}

/// Returns one line a body.
std::string trajectory_rows(const Frame& frame);

/// Returns one line a wall.
std::string wall_rows(const Frame& frame);

/// Returns one line.
std::string step_row(const StepInfo& step);

/// @}

}  // namespace stokesbook
