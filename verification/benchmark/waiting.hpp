#pragma once

#include <string>

#include "table.hpp"

namespace stokesbook {

/// Times of a program.
struct WorkTime {
  double wall = 0.0;  ///< seconds from the beginning to the end
  double cpu = 0.0;   ///< seconds of all threads together
};

/// Solves the Taylor-Green start repeatedly with all threads. This work has many short parallel
/// loops, and threads wait at the end of each loop.
///
/// @param  solves  number of solves
WorkTime solve_often(int solves);

/// Times the same work alone and beside two busy processes, once with the program's own policy for
/// waiting threads and once with threads that spin.
///
/// The policy holds for a whole process. Each time is therefore measured in a separate process.
/// @param  program  path of this program, whose option --solves calls solve_often()
Table time_waiting(const std::string& program);

}  // namespace stokesbook
