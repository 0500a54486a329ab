// Exercise 11.4: five drills on complementarity.
#include "chapters/exercise.hpp"

#include <cmath>

#include <Eigen/Core>

using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// Task 1: the derivative of Fischer's function with respect to z.
double fischer_slope(double z, double w) {
  //@ starter
  not_done(z, w);  // your code instead of this line
  //@ solution
  return z / std::hypot(z, w) - 1.0;
  //@ wrong misprint: the root of z + w
  return 0.5 / std::sqrt(z + w) - 1.0;
  //@ wrong root_alone: derivative of -z is missing
  return z / std::hypot(z, w);
  //@ wrong by_w: derivative with respect to w
  return w / std::hypot(z, w) - 1.0;
  //@ end
}

// Task 2: the least value of z . M z/2 + q . z over z >= 0, from the solution.
double minimum(const VectorXd& q, const VectorXd& z) {
  //@ starter
  not_done(q, z);  // your code instead of this line
  //@ solution
  return 0.5 * q.dot(z);
  //@ wrong linear_part: the quadratic part is missing
  return q.dot(z);
  //@ wrong quadratic_part: the linear part is missing
  return -0.5 * q.dot(z);
  //@ end
}

// Task 3: the linearised gap without contact forces.
double offset_of_problem(double gap, double dt, const VectorXd& gradient, const VectorXd& u,
                         const VectorXd& u_free) {
  //@ starter
  not_done(gap, dt, gradient, u, u_free);  // your code instead of this line
  //@ solution
  return gap + dt * gradient.dot(u_free - u);
  //@ wrong increment: this is the problem of an increment
  (void)dt, (void)gradient, (void)u, (void)u_free;
  return gap;
  //@ wrong backward: the way goes from u to u_free
  return gap + dt * gradient.dot(u - u_free);
  //@ wrong no_time: a velocity is not a displacement
  (void)dt;
  return gap + gradient.dot(u_free - u);
  //@ end
}

// Task 4: the first length of Barzilai and Borwein.
double step_length(const VectorXd& dz, const VectorXd& dw) {
  //@ starter
  not_done(dz, dw);  // your code instead of this line
  //@ solution
  return dz.dot(dz) / dz.dot(dw);
  //@ wrong second_length: this is the second length
  return dz.dot(dw) / dw.dot(dw);
  //@ wrong curvature: this is the mean curvature
  return dz.dot(dw) / dz.dot(dz);
  //@ end
}

// Task 5: the force, from the result of a solver without units.
double force_with_unit(double scaled, double a, double diagonal) {
  //@ starter
  not_done(scaled, a, diagonal);  // your code instead of this line
  //@ solution
  return a * scaled / std::sqrt(diagonal);
  //@ wrong divided: this divides by s_i
  return a * scaled * std::sqrt(diagonal);
  //@ wrong forgotten_unit: the factor a is missing
  (void)a;
  return scaled / std::sqrt(diagonal);
  //@ wrong twice: s_i occurs once
  return a * scaled / diagonal;
  //@ end
}
