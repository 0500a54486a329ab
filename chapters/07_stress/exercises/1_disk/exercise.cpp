// Exercise 07.1: tractions and stresslets of a disk.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>

#include "double_layer/flow_derivatives.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using exercise::not_done;
using std::numbers::pi;

// Task 1: from phi', phi'' and psi' at z.
FlowDerivatives derivatives(Complex z, Complex dphi, Complex ddphi, Complex dpsi) {
  //@ starter
  not_done(z, dphi, ddphi, dpsi);  // your code instead of this line
  //@ solution
  return {-4.0 * dphi.real(), 4.0 * dphi.imag(), -2.0 * std::conj(dpsi + std::conj(z) * ddphi)};
  //@ wrong not_conjugate: the strain must be conjugate
  return {-4.0 * dphi.real(), 4.0 * dphi.imag(), -2.0 * (dpsi + std::conj(z) * ddphi)};
  //@ wrong pressure_sign: the pressure has the other sign
  return {4.0 * dphi.real(), 4.0 * dphi.imag(), -2.0 * std::conj(dpsi + std::conj(z) * ddphi)};
  //@ end
}

// Task 2: at a point of a disk under a force.
Complex pulled(double radius, Complex force, Complex point) {
  //@ starter
  not_done(radius, force, point);  // your code instead of this line
  //@ solution
  static_cast<void>(point);
  return force / (2.0 * pi * radius);
  //@ wrong pressure_only: this is the pressure's part
  return dot(force, point) * point / (2.0 * pi * radius * radius * radius);
  //@ wrong into_fluid: the normal points into the disk
  static_cast<void>(point);
  return -force / (2.0 * pi * radius);
  //@ end
}

// Task 3: at a point of a disk under a torque.
Complex turned(double radius, double torque, Complex point) {
  //@ starter
  not_done(radius, torque, point);  // your code instead of this line
  //@ solution
  return torque * perp(point) / (2.0 * pi * radius * radius * radius);
  //@ wrong without_arm: the torque is an integral of force times radius
  return torque * perp(point) / (2.0 * pi * radius * radius);
  //@ end
}

// Task 4: at a point of a free disk in a linear flow of strain q.
Complex strained(double radius, Complex strain, double viscosity, Complex point) {
  //@ starter
  not_done(radius, strain, viscosity, point);  // your code instead of this line
  //@ solution
  return -2.0 * viscosity * strain * std::conj(point) / radius;
  //@ wrong undisturbed: this is the stress of the flow without the disk
  return -viscosity * strain * std::conj(point) / radius;
  //@ wrong no_radius: the normal has length 1
  static_cast<void>(radius);
  return -2.0 * viscosity * strain * std::conj(point);
  //@ end
}

// Task 5: S_11 + i S_12 from the density at the nodes.
Complex stresslet(const Curve& curve, const ComplexVector& density, double viscosity) {
  //@ starter
  not_done(curve, density, viscosity);  // your code instead of this line
  //@ solution
  return -viscosity * normals(curve).cwiseProduct(weights(curve)).cwiseProduct(density).sum();
  //@ wrong scalar: n eta is the product of complex numbers
  return -viscosity * normals(curve).cwiseProduct(weights(curve)).dot(density).real();
  //@ wrong conjugate: n eta is the product of complex numbers, without
  return -viscosity *
         normals(curve).cwiseProduct(weights(curve)).cwiseProduct(density.conjugate()).sum();
  //@ wrong half: twice as much
  return -0.5 * viscosity * normals(curve).cwiseProduct(weights(curve)).cwiseProduct(density).sum();
  //@ end
}
