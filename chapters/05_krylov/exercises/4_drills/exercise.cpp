// Exercise 05.4: five drills on GMRES and on the blocks of bodies.
#include "chapters/exercise.hpp"

#include <cmath>
#include <complex>
#include <functional>
#include <set>
#include <vector>

using Complex = std::complex<double>;
using stokesbook::exercise::not_done;

// Task 1: the residual after an iteration.
double next_residual(double residual, double diagonal, double subdiagonal) {
  //@ starter
  not_done(residual, diagonal, subdiagonal);  // your code instead of this line
  //@ solution
  return residual * std::abs(subdiagonal) / std::hypot(diagonal, subdiagonal);
  //@ wrong cosine: this is the part that stays in the row
  return residual * std::abs(diagonal) / std::hypot(diagonal, subdiagonal);
  //@ wrong tangent: this is the residual of Galerkin's condition
  return residual * std::abs(subdiagonal / diagonal);
  //@ end
}

// Task 2: the least number of iterations for the bound of a disk.
int iterations_in_disk(Complex centre, double radius, double tolerance) {
  //@ starter
  not_done(centre, radius, tolerance);  // your code instead of this line
  //@ solution
  return static_cast<int>(std::ceil(std::log(tolerance) / std::log(radius / std::abs(centre))));
  //@ wrong radius_alone: the radius counts relative to the distance of the centre from zero
  static_cast<void>(centre);
  return static_cast<int>(std::ceil(std::log(tolerance) / std::log(radius)));
  //@ wrong rounded_down: the bound is still above the tolerance
  return static_cast<int>(std::log(tolerance) / std::log(radius / std::abs(centre)));
  //@ end
}

// Task 3: the number of iterations after which a diagonal system is solved.
int most_iterations(const std::vector<double>& diagonal, const std::vector<double>& right) {
  //@ starter
  not_done(diagonal, right);  // your code instead of this line
  //@ solution
  std::set<double> distinct;
  for (std::size_t j = 0; j < diagonal.size(); ++j) {
    if (right[j] != 0.0) distinct.insert(diagonal[j]);
  }
  return static_cast<int>(distinct.size());
  //@ wrong unknowns: equal eigenvalues need one factor only
  static_cast<void>(right);
  return static_cast<int>(diagonal.size());
  //@ wrong absent_ones: some eigenvalues do not occur in the right-hand side
  static_cast<void>(right);
  return static_cast<int>(std::set<double>(diagonal.begin(), diagonal.end()).size());
  //@ end
}

// Task 4: the largest modulus of the factor of an outlier on a disk.
double outlier_factor(Complex centre, double radius, Complex outlier) {
  //@ starter
  not_done(centre, radius, outlier);  // your code instead of this line
  //@ solution
  return (std::abs(outlier - centre) + radius) / std::abs(outlier);
  //@ wrong at_the_centre: this is the factor at the centre of the disk
  static_cast<void>(radius);
  return std::abs(outlier - centre) / std::abs(outlier);
  //@ wrong value_at_zero: the factor has the value 1 at zero
  return std::abs(outlier - centre) + radius;
  //@ end
}

// Task 5: the block of a body at the angle theta, applied to v.
Complex turned_block(const std::function<Complex(Complex)>& block, double theta, Complex v) {
  //@ starter
  not_done(block, theta, v);  // your code instead of this line
  //@ solution
  return std::polar(1.0, theta) * block(std::polar(1.0, -theta) * v);
  //@ wrong other_way: this body is turned the other way
  return std::polar(1.0, -theta) * block(std::polar(1.0, theta) * v);
  //@ wrong in_the_frame: this result is a vector in the frame of the body
  return block(std::polar(1.0, -theta) * v);
  //@ wrong not_turned: this block is not turned with the body
  static_cast<void>(theta);
  return block(v);
  //@ end
}
