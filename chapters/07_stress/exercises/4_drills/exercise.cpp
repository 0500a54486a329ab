// Exercise 07.4: five drills on stress, dissipation and stresslets.
#include "chapters/exercise.hpp"

#include <cmath>

#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;

// Task 1: the derivative of u_1 in direction 2.
double shear_gradient(Complex strain, double vorticity) {
  //@ starter
  not_done(strain, vorticity);  // your code instead of this line
  //@ solution
  return 0.5 * (strain.imag() - vorticity);
  //@ wrong other_derivative: this is the derivative of u_2 in direction 1
  return 0.5 * (strain.imag() + vorticity);
  //@ wrong without_half: this is twice the derivative
  return strain.imag() - vorticity;
  //@ end
}

// Task 2: the heat per area and time.
double dissipation(Complex strain, double vorticity, double viscosity) {
  //@ starter
  not_done(strain, vorticity, viscosity);  // your code instead of this line
  //@ solution
  static_cast<void>(vorticity);
  return viscosity * std::norm(strain);
  //@ wrong whole_gradient: this takes the whole velocity gradient
  return 0.5 * viscosity * (std::norm(strain) + vorticity * vorticity);
  //@ wrong two_entries: e:e has four entries
  static_cast<void>(vorticity);
  return 0.5 * viscosity * std::norm(strain);
  //@ end
}

// Task 3: the traction along tau on a surface that turns with omega.
double friction(double vorticity, double omega, double viscosity) {
  //@ starter
  not_done(vorticity, omega, viscosity);  // your code instead of this line
  //@ solution
  return viscosity * (vorticity - 2.0 * omega);
  //@ wrong vorticity_of_a_rotation: the vorticity of a rotation is twice omega
  return viscosity * (vorticity - omega);
  //@ wrong reaction: this is the force of the fluid on the surface
  return viscosity * (2.0 * omega - vorticity);
  //@ end
}

// Task 4: the pressure at the side of the fluid, from the mean of both sides.
double pressure_in_the_fluid(double mean, Complex tangent, Complex density_slope,
                             double viscosity) {
  //@ starter
  not_done(mean, tangent, density_slope, viscosity);  // your code instead of this line
  //@ solution
  return mean + viscosity * dot(tangent, density_slope);
  //@ wrong other_side: this is the pressure on the other side
  return mean - viscosity * dot(tangent, density_slope);
  //@ wrong whole_jump: this adds the whole jump
  return mean + 2.0 * viscosity * dot(tangent, density_slope);
  //@ end
}

// Task 5: S_11 + i S_12 of the force F at y/2 and -F at -y/2, both on the fluid.
Complex pair_stresslet(Complex force, Complex y) {
  //@ starter
  not_done(force, y);  // your code instead of this line
  //@ solution
  return -0.5 * force * y;
  //@ wrong on_the_fluid: this is the dipole of the forces on the fluid
  return 0.5 * force * y;
  //@ wrong conjugate: this is the scalar product and the torque
  return -0.5 * force * std::conj(y);
  //@ wrong whole_arms: this is twice the stresslet
  return -force * y;
  //@ end
}
