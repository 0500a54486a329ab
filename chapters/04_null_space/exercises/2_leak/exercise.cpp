// Exercise 04.2: a leak, with N_0 and without.
#include "chapters/exercise.hpp"

#include <cmath>

#include "closure/bordered_system.hpp"
#include "null_space/null_space.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::not_done;

// Given: the relative error of the shaft's load, solved by with_n0(), for a leak.
double load_error(double leak);

// Task 1: the matrix of the reduced form, with N_0.
Eigen::MatrixXd with_n0(const StokesProblem& problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  const std::vector<Index> offsets = node_offsets(problem);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    if (component.kind != ComponentKind::enclosing_wall) continue;
    const Index size = 2 * component.curve.size();
    matrix.block(2 * offsets[k], 2 * offsets[k], size, size) += null_space_matrix(component.curve);
  }
  return matrix;
  //@ wrong last_block: here the wall is not the last component
  Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  for (const Component& component : problem.components) {
    if (component.kind != ComponentKind::enclosing_wall) continue;
    const Index size = 2 * component.curve.size();
    matrix.bottomRightCorner(size, size) += null_space_matrix(component.curve);
  }
  return matrix;
  //@ wrong everywhere: N_0 acts on the enclosing wall only
  Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  const std::vector<Index> offsets = node_offsets(problem);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Curve& curve = problem.components[k].curve;
    const Index size = 2 * curve.size();
    matrix.block(2 * offsets[k], 2 * offsets[k], size, size) += null_space_matrix(curve);
  }
  return matrix;
  //@ wrong other_sign: the sign is the other one
  Eigen::MatrixXd matrix = assemble(problem, ClosureForm::reduced).matrix;
  const std::vector<Index> offsets = node_offsets(problem);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    if (component.kind != ComponentKind::enclosing_wall) continue;
    const Index size = 2 * component.curve.size();
    matrix.block(2 * offsets[k], 2 * offsets[k], size, size) -= null_space_matrix(component.curve);
  }
  return matrix;
  //@ wrong as_it_comes: N_0 is missing
  return assemble(problem, ClosureForm::reduced).matrix;
  //@ end
}

// Task 2: the net flux of the prescribed velocities out of the fluid.
double flux_of_data(const StokesProblem& problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  double flux = 0.0;
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) continue;
    const ComplexVector n = normals(component.curve);
    flux += n.conjugate().cwiseProduct(component.velocity).real().dot(weights(component.curve));
  }
  return flux;
  //@ wrong wall_only: the shaft is porous too
  double flux = 0.0;
  for (const Component& component : problem.components) {
    if (component.kind != ComponentKind::enclosing_wall) continue;
    const ComplexVector n = normals(component.curve);
    flux += n.conjugate().cwiseProduct(component.velocity).real().dot(weights(component.curve));
  }
  return flux;
  //@ wrong no_weights: the weights of the nodes are missing
  double flux = 0.0;
  for (const Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) continue;
    flux += normals(component.curve).dot(component.velocity).real();
  }
  return flux;
  //@ end
}

// Task 3: the problem without its net flux.
StokesProblem mended(StokesProblem problem) {
  //@ starter
  not_done(problem);  // your code instead of this line
  //@ solution
  const double flux = flux_of_data(problem);
  for (Component& component : problem.components) {
    if (component.kind != ComponentKind::enclosing_wall) continue;
    component.velocity -= flux / perimeter(component.curve) * normals(component.curve);
  }
  return problem;
  //@ wrong each: every curve keeps its own flux but the enclosing wall
  for (Component& component : problem.components) {
    if (component.kind == ComponentKind::free_body) continue;
    const ComplexVector n = normals(component.curve);
    const double flux =
        n.conjugate().cwiseProduct(component.velocity).real().dot(weights(component.curve));
    component.velocity -= flux / perimeter(component.curve) * n;
  }
  return problem;
  //@ wrong doubled: this doubles the leak
  const double flux = flux_of_data(problem);
  for (Component& component : problem.components) {
    if (component.kind != ComponentKind::enclosing_wall) continue;
    component.velocity += flux / perimeter(component.curve) * normals(component.curve);
  }
  return problem;
  //@ wrong tight: this takes off all that passes through the wall
  for (Component& component : problem.components) {
    if (component.kind != ComponentKind::enclosing_wall) continue;
    const ComplexVector n = normals(component.curve);
    component.velocity.array() -=
        n.array() * (n.conjugate().array() * component.velocity.array()).real();
  }
  return problem;
  //@ end
}

// Task 4 is an experiment with these functions. You find it in the book's check.cpp.

// Task 5: the leak at which the load's relative error is the tolerance.
double tolerable_leak(double tolerance) {
  //@ starter
  not_done(tolerance);  // your code instead of this line
  //@ solution
  constexpr double known = 1e-3;
  return known * tolerance / load_error(known);
  //@ wrong same_number: an error is not as large as its leak
  return tolerance;
  //@ wrong square_root: the error is proportional to the leak
  constexpr double known = 1e-3;
  return known * std::sqrt(tolerance / load_error(known));
  //@ end
}
