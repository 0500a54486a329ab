// Checks that elimination in a tree of groups is an approximate inverse, for free and held bodies,
// on one and several levels; and that the approximation improves with the tolerance.
#include "preconditioning/hierarchical_preconditioner.hpp"

#include <cmath>

#include <omp.h>

#include "closure/bordered_system.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "krylov/matrices.hpp"
#include "preconditioning/cluster_preconditioner.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Returns ellipses on a lattice, with random orientations, and with gaps of at least 0.3.
StokesProblem ellipses(int rows, int columns, Index nodes, ComponentKind last) {
  StokesProblem problem;
  for (int k = 0; k < rows * columns; ++k) {
    const Complex centre(2.3 * (k % columns), 2.3 * (k / columns));
    const Curve curve =
        place(sample(Ellipse{1.0, 0.6}, nodes, Side::fluid_outside), centre, 1.7 * k);
    problem.components.push_back({ComponentKind::free_body, curve, centre, {}, 0.0, {}});
  }
  Component& changed = problem.components.back();
  changed.kind = last;
  if (last == ComponentKind::prescribed) changed.velocity = ComplexVector::Zero(nodes);
  problem.gauge_length = held_gauge(problem);
  return problem;
}

// Encloses the ellipses by a wall, whose arcs have 15 nodes or 16.
StokesProblem enclosed(StokesProblem problem) {
  const Curve wall = place(sample(Ellipse{5.6, 5.0}, 236, Side::fluid_inside), {2.3, 2.3}, 0.0);
  problem.components.push_back(
      {ComponentKind::enclosing_wall, wall, {}, {}, 0.0, ComplexVector::Zero(wall.size())});
  problem.gauge_length.reset();
  return problem;
}

HierarchicalPreconditioner hierarchy(const StokesProblem& problem,
                                     const HierarchySettings& settings) {
  std::vector<BlockDiagonalPreconditioner::Member> alone;
  for (const Component& component : problem.components) {
    if (!is_inner(component)) {
      alone.push_back({nullptr, 0.0});  // walls are cut into arcs
      continue;
    }
    alone.push_back({std::make_shared<const MatrixXd>(invert_block(
                         cluster_block(component, ClusterForm::mobility, held_gauge(problem)))),
                     0.0});
  }
  const LayerBlock layer = [&](const ComplexVector& targets, std::size_t source) {
    return StressletSum({problem.components[source].curve}).matrix(targets);
  };
  return {problem, alone, layer, settings};
}

double error_of_inverse(const StokesProblem& problem, const HierarchySettings& settings) {
  return inversion_error(hierarchy(problem, settings),
                         assemble_bounded(problem, ClosureForm::reduced).matrix);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(hierarchical_preconditioner)

BOOST_AUTO_TEST_CASE(a_small_tolerance_gives_nearly_the_inverse) {
  for (const ComponentKind kind : {ComponentKind::free_body, ComponentKind::prescribed}) {
    const StokesProblem problem = ellipses(2, 3, 16, kind);
    BOOST_TEST(error_of_inverse(problem, {0.03, 0.018, 1.2, 12}) < 0.02);
    BOOST_TEST(error_of_inverse(problem, {}) < 0.25);
    BOOST_TEST(error_of_inverse(problem, {}) > 0.02);
  }
}

BOOST_AUTO_TEST_CASE(several_levels_give_nearly_the_inverse) {
  const StokesProblem problem = ellipses(5, 5, 16, ComponentKind::prescribed);
  const HierarchySettings tight{0.05, 0.05, 1.2, 12, 10}, loose{0.4, 0.24, 1.2, 8, 10};
  BOOST_TEST(error_of_inverse(problem, tight) < 0.05);
  BOOST_TEST(hierarchy(problem, loose).bytes() < hierarchy(problem, tight).bytes());
}

BOOST_AUTO_TEST_CASE(walls_are_eliminated_with_the_bodies) {
  const StokesProblem problem = enclosed(ellipses(3, 3, 16, ComponentKind::free_body));
  BOOST_TEST(error_of_inverse(problem, {0.05, 0.05, 1.2, 12, 10}) < 0.05);
}

BOOST_AUTO_TEST_CASE(a_single_body_is_solved_alone) {
  // Numbers of 16 bits have errors of 1.5e-5.
  BOOST_TEST(error_of_inverse(ellipses(1, 1, 24, ComponentKind::free_body), {}) < 2e-4);
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_linear_whatever_the_threads) {
  const StokesProblem problem = ellipses(2, 3, 16, ComponentKind::prescribed);
  omp_set_num_threads(1);
  const HierarchicalPreconditioner one = hierarchy(problem, {});
  omp_set_num_threads(2);
  const HierarchicalPreconditioner two = hierarchy(problem, {});
  const Index size = 2 * node_offsets(problem).back();
  const VectorXd v = normal_matrix(size, 1, 4), w = normal_matrix(size, 1, 5);
  BOOST_TEST((one(v).array() == two(v).array()).all());
  const VectorXd sum = one(2.0 * v - 3.0 * w), terms = 2.0 * one(v) - 3.0 * one(w);
  BOOST_TEST((sum - terms).norm() < 1e-5 * terms.norm());  // single precision
  omp_set_num_threads(1);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
