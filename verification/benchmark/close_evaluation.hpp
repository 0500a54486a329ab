#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times velocities at targets next to an ellipse 2:1 by the trapezoid sum and by the schemes of
/// close evaluation, one thread.
///
/// @param  budget  seconds to spend on each number
Table time_close_evaluation(double budget);

/// Times near corrections by explicit rows beside factored ones, by the number of near targets that
/// a curve has: thirty applications and what they need once, one thread.
///
/// @param  budget  seconds to spend on each number
Table time_near_storage(double budget);

}  // namespace stokesbook
