#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times velocities at targets next to an ellipse 2:1, by the trapezoid sum and by the schemes of
/// close evaluation, with one thread.
///
/// @param  budget  seconds to spend on each number
Table time_close_evaluation(double budget);

/// Times near corrections with explicit rows and with factored storage, for several numbers of near
/// targets of a curve. Each time is that of the plan and thirty applications, with one thread.
///
/// @param  budget  seconds to spend on each number
Table time_near_storage(double budget);

}  // namespace stokesbook
