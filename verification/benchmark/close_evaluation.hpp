#pragma once

#include "table.hpp"

namespace stokesbook {

/// Times velocities at targets next to an ellipse 2:1 by the trapezoid sum and by the schemes of
/// close evaluation, one thread.
///
/// @param  budget  seconds to spend on each number
Table time_close_evaluation(double budget);

/// Finds how many near targets a curve may have for explicit rows to be the cheaper near
/// correction: thirty applications and what they need once, one thread.
///
/// @param  budget  seconds to spend on each number
Table time_near_storage(double budget);

}  // namespace stokesbook
