// Exercise 07.3: tractions that are almost right.
#include "chapters/exercise.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "stress/solved_flow.hpp"
#include "stress/stress.hpp"
#include "stress/traction.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::not_done;
using std::numbers::pi;

// Task 1: -p n + mu du/dn.
Complex pseudo(const FlowDerivatives& flow, Complex n, double viscosity) {
  //@ starter
  not_done(flow, n, viscosity);  // your code instead of this line
  //@ solution
  const Complex slope = 0.5 * (flow.strain * std::conj(n) + imaginary * flow.vorticity * n);
  return viscosity * (slope - flow.pressure * n);
  //@ wrong symmetric: this is the traction
  return traction(flow, n, viscosity);
  //@ wrong no_rotation: the vorticity turns the velocity along n
  return viscosity * (0.5 * flow.strain * std::conj(n) - flow.pressure * n);
  //@ end
}

// Task 2: torque by pseudo-traction minus torque by traction, of a body.
double torque_difference(double omega, double area, double viscosity) {
  //@ starter
  not_done(omega, area, viscosity);  // your code instead of this line
  //@ solution
  return -2.0 * viscosity * omega * area;
  //@ wrong sign: n points into the body
  return 2.0 * viscosity * omega * area;
  //@ wrong half: the moment of x is twice the area
  return -viscosity * omega * area;
  //@ end
}

// Task 3: an angular velocity of the outer circle that hides the defect.
double unnoticed(double inner_radius, double outer_radius, double omega) {
  //@ starter
  not_done(inner_radius, outer_radius, omega);  // your code instead of this line
  //@ solution
  return -omega * inner_radius / outer_radius;
  //@ wrong areas: the angular velocity enters as its square
  return omega * inner_radius * inner_radius / (outer_radius * outer_radius);
  //@ wrong at_rest: not zero
  static_cast<void>(inner_radius);
  static_cast<void>(outer_radius);
  static_cast<void>(omega);
  return 0.0;
  //@ end
}

// Task 4: "right", "pseudo", "pressureless", "reversed" or "tilted".
std::string diagnose(const SolvedFlow& flow, const ComplexVector& traction) {
  //@ starter
  not_done(flow, traction);  // your code instead of this line
  //@ solution
  const Load& exact = flow.completion().loads[0];
  const Load found = integrated_loads(flow.problem(), traction)[0];
  const double force = std::abs(exact.force), error = std::abs(found.force - exact.force);
  if (error < 1e-6 * force) {
    const double scale = std::abs(exact.torque) + force;
    return std::abs(found.torque - exact.torque) < 1e-6 * scale ? "right" : "pseudo";
  }
  if (std::abs(found.force + exact.force) < 1e-6 * force) return "reversed";
  // The pressure acts along n: without it the part across n is right.
  const ComplexVector n = normals(flow.problem().components[0].curve);
  const ComplexVector right =
      boundary_traction(flow.problem(), flow.derivatives(flow.nodes())).head(n.size());
  double across = 0.0;
  for (Index j = 0; j < n.size(); ++j) {
    across = std::max(across, std::abs(cross(n[j], right[j] - traction[j])));
  }
  return across < 1e-6 * right.cwiseAbs().maxCoeff() ? "pressureless" : "tilted";
  //@ wrong force_only: found right, but it was pseudo
  const Load& exact = flow.completion().loads[0];
  const Load found = integrated_loads(flow.problem(), traction)[0];
  const double force = std::abs(exact.force);
  if (std::abs(found.force - exact.force) < 1e-6 * force) return "right";
  return std::abs(found.force + exact.force) < 1e-6 * force ? "reversed" : "pressureless";
  //@ wrong no_tilt: found pressureless, but it was tilted
  const Load& exact = flow.completion().loads[0];
  const Load found = integrated_loads(flow.problem(), traction)[0];
  const double force = std::abs(exact.force), error = std::abs(found.force - exact.force);
  if (error < 1e-6 * force) {
    const double scale = std::abs(exact.torque) + force;
    return std::abs(found.torque - exact.torque) < 1e-6 * scale ? "right" : "pseudo";
  }
  return std::abs(found.force + exact.force) < 1e-6 * force ? "reversed" : "pressureless";
  //@ end
}
