// Exercise 10.1: conservative advancement.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>

using Complex = std::complex<double>;
using stokesbook::exercise::not_done;

// In one step, tau from 0 to 1: c_A - c_B at the start and its change; changes of the orientations.
struct Motion {
  Complex offset, drift;
  double turn_a, turn_b;
};

struct Search {
  std::function<Complex(double)> path;      // z(tau)
  std::function<double(Complex)> distance;  // from the obstacle
  double speed_bound, separation, tolerance;
};

// Task 1: L with |dz/dtau| <= L for all points of A with |X| <= radius and all tau.
double speed_bound(const Motion& motion, double radius) {
  //@ starter
  not_done(motion, radius);  // your code instead of this line
  //@ solution
  const auto centre = [&](Complex offset) {
    return std::abs(motion.drift - motion.turn_b * Complex{0.0, 1.0} * offset);
  };
  return std::max(centre(motion.offset), centre(motion.offset + motion.drift)) +
         std::abs(motion.turn_a - motion.turn_b) * radius;
  //@ wrong start_only: the speed at the start is no bound
  return std::abs(motion.drift - motion.turn_b * Complex{0.0, 1.0} * motion.offset) +
         std::abs(motion.turn_a - motion.turn_b) * radius;
  //@ wrong observer_at_rest: B turns, and with it all that it sees
  return std::abs(motion.drift) + std::abs(motion.turn_a) * radius;
  //@ end
}

// Task 2: the time of first contact, infinity without any.
double first_contact(const Search& search) {
  //@ starter
  not_done(search);  // your code instead of this line
  //@ solution
  for (double tau = 0.0; tau <= 1.0;) {
    const double above = search.distance(search.path(tau)) - search.separation;
    if (above <= search.tolerance) return tau;
    tau += above / search.speed_bound;
  }
  return std::numeric_limits<double>::infinity();
  //@ wrong to_the_surface: steps lead to the separation, not to the obstacle
  for (double tau = 0.0; tau <= 1.0;) {
    const double d = search.distance(search.path(tau));
    if (d <= search.separation + search.tolerance) return tau;
    tau += d / search.speed_bound;
  }
  return std::numeric_limits<double>::infinity();
  //@ wrong equal_steps: equal steps skip what is thinner than they are long
  for (int k = 0; k <= 1000; ++k) {
    if (search.distance(search.path(0.001 * k)) <= search.separation + search.tolerance) {
      return 0.001 * k;
    }
  }
  return std::numeric_limits<double>::infinity();
  //@ end
}

// Task 3: the gap at the end of a point that came to `touched` at a distance with a normal.
double gap(double distance, Complex touched, Complex normal, Complex end, double separation) {
  //@ starter
  not_done(distance, touched, normal, end, separation);  // your code instead of this line
  //@ solution
  return distance - separation + std::real(std::conj(normal) * (end - touched));
  //@ wrong length: the way along the line is no gap
  static_cast<void>(normal);
  return distance - separation - std::abs(end - touched);
  //@ end
}
