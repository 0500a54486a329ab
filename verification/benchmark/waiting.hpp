#pragma once

#include <string>

#include "table.hpp"

namespace stokesbook {

/// How a program used the machine.
struct WorkTime {
  double wall = 0.0;  ///< seconds from the beginning to the end
  double cpu = 0.0;   ///< seconds of all processors together
};

/// Solves the Taylor-Green start again and again, with all threads: work with many short parallel
/// loops, at whose ends threads wait.
///
/// @param  solves  how often
WorkTime solve_often(int solves);

/// Times the same work alone and beside two busy processes, once with the program's own choice for
/// waiting threads and once with threads that spin.
///
/// The policy holds for a whole process, so that each time comes from a process of its own.
/// @param  program  path of this program, whose option --solves calls solve_often()
Table time_waiting(const std::string& program);

}  // namespace stokesbook
