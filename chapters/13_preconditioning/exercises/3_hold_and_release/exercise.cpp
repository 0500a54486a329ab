// Exercise 13.3: held bodies, their resistances, and their release.
#include "chapters/exercise.hpp"

#include <Eigen/Core>

using Eigen::MatrixXd;
using Eigen::VectorXd;
using stokesbook::exercise::not_done;

// The matrices of m free bodies with n nodes in all.
struct Bodies {
  MatrixXd free;        // A, 2n x 2n
  MatrixXd flows;       // S, 2n x 3m: the flows of forces and torques
  MatrixXd modes;       // K, 2n x 3m: rigid motions to velocities at the nodes
  MatrixXd projection;  // Pi, 3m x 2n: densities to rigid motions
};

// Given: the inverse of a matrix, and the solution of matrix x = rhs.
MatrixXd inverse(const MatrixXd& matrix);
VectorXd solve(const MatrixXd& matrix, const VectorXd& rhs);

// Task 1: A_h^{-1}, the inverse of the matrix of the held bodies.
MatrixXd held_inverse(const Bodies& bodies) {
  //@ starter
  not_done(bodies);  // your code instead of this line
  //@ solution
  return inverse(bodies.free + (bodies.flows + bodies.modes) * bodies.projection);
  //@ wrong still_free: the motions -K Pi of free bodies are still in it
  return inverse(bodies.free + bodies.flows * bodies.projection);
  //@ wrong other_sign: both terms have the other sign
  return inverse(bodies.free - (bodies.flows + bodies.modes) * bodies.projection);
  //@ wrong without_loads: A + K Pi is singular
  return inverse(bodies.free + bodies.modes * bodies.projection);
  //@ wrong not_inverted: this is A_h, not its inverse
  return bodies.free + (bodies.flows + bodies.modes) * bodies.projection;
  //@ end
}

// Task 2: R, from A_h^{-1}.
MatrixXd resistance(const MatrixXd& inverse_of_held, const Bodies& bodies) {
  //@ starter
  not_done(inverse_of_held, bodies);  // your code instead of this line
  //@ solution
  return bodies.projection * inverse_of_held * bodies.modes;
  //@ wrong of_free_bodies: this is the matrix of free bodies
  static_cast<void>(inverse_of_held);
  return bodies.projection * inverse(bodies.free) * bodies.modes;
  //@ wrong data_from_loads: the data of bodies that move are K, not S
  return bodies.projection * inverse_of_held * bodies.flows;
  //@ wrong mobility: this is the inverse of R
  return inverse(bodies.projection * inverse_of_held * bodies.modes);
  //@ end
}

// Task 3: A^{-1} r, from A_h^{-1} and R.
VectorXd release(const MatrixXd& inverse_of_held, const MatrixXd& resistances, const Bodies& bodies,
                 const VectorXd& r) {
  //@ starter
  not_done(inverse_of_held, resistances, bodies, r);  // your code instead of this line
  //@ solution
  const VectorXd motions = solve(resistances, bodies.projection * (inverse_of_held * r));
  const VectorXd velocities = bodies.modes * motions;
  return inverse_of_held * (r - velocities) - velocities;
  //@ wrong sign_of_motions: the sign of V
  const VectorXd motions = solve(resistances, bodies.projection * (inverse_of_held * r));
  const VectorXd velocities = bodies.modes * motions;
  return inverse_of_held * (r + velocities) + velocities;
  //@ wrong solved_once: solve once more with held bodies
  const VectorXd held = inverse_of_held * r;
  const VectorXd motions = solve(resistances, bodies.projection * held);
  return held - bodies.modes * motions;
  //@ wrong without_rigid_part: the rigid part -K V is missing
  const VectorXd motions = solve(resistances, bodies.projection * (inverse_of_held * r));
  return inverse_of_held * (r - bodies.modes * motions);
  //@ wrong loads_of_loads: V is the solution of R V = loads
  const VectorXd motions = resistances * (bodies.projection * (inverse_of_held * r));
  const VectorXd velocities = bodies.modes * motions;
  return inverse_of_held * (r - velocities) - velocities;
  //@ end
}

// Task 4: the preconditioner of a matrix that is nearly A_h^{-1}, applied to r.
VectorXd preconditioned(const MatrixXd& nearly_inverse, const Bodies& bodies, const VectorXd& r) {
  //@ starter
  not_done(nearly_inverse, bodies, r);  // your code instead of this line
  //@ solution
  return release(nearly_inverse, resistance(nearly_inverse, bodies), bodies, r);
  //@ wrong true_resistances: this R belongs to another inverse
  return release(nearly_inverse, resistance(held_inverse(bodies), bodies), bodies, r);
  //@ wrong not_released: these bodies are still held
  static_cast<void>(bodies);
  return nearly_inverse * r;
  //@ wrong exact: the matrix that was given is not used
  static_cast<void>(nearly_inverse);
  const MatrixXd held = held_inverse(bodies);
  return release(held, resistance(held, bodies), bodies, r);
  //@ end
}

// Task 5 is an experiment with these functions. You find it in the book's check.cpp.
