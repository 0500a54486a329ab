// Checks that a cluster that contains all bodies is the inverse, in both forms, for free and held
// bodies, and that clusters of held bodies have forces of the right sign and a moderate size.
#include "preconditioning/cluster_preconditioner.hpp"

#include <cmath>
#include <numbers>

#include "closure/bordered_system.hpp"
#include "double_layer/double_layer.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "krylov/matrices.hpp"
#include "support/dense.hpp"

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Member = BlockDiagonalPreconditioner::Member;

namespace {

Component ellipse(ComponentKind kind, Complex centre, double orientation) {
  const Curve curve =
      place(sample(Ellipse{1.0, 0.6}, 48, Side::fluid_outside), centre, orientation);
  ComplexVector velocity = ComplexVector::Zero(curve.size());
  return {kind, curve, centre, {0.3, -0.2}, 0.1, velocity};
}

// Two ellipses have a gap of 0.4.
StokesProblem pair(ComponentKind second) {
  return {{ellipse(ComponentKind::free_body, {-0.8, 0.0}, 1.2), ellipse(second, {1.0, 0.3}, 0.7)},
          1.0,
          {},
          20.0};
}

// Makes both bodies neighbours; `gap` sets how far the clusters are compressed.
ClusterPreconditioner clusters(const StokesProblem& problem, ClusterForm form, double gap = 0.2) {
  const double gauge = held_gauge(problem);
  std::vector<Member> alone;
  const std::vector<std::vector<Neighbour>> neighbours{{{1, gap}}, {{0, gap}}};
  for (const Component& component : problem.components) {
    alone.push_back(
        {std::make_shared<const MatrixXd>(invert_block(cluster_block(component, form, gauge))),
         0.0});
  }
  const LayerBlock layer = [&](const ComplexVector& targets, std::size_t source) {
    return StressletSum({problem.components[source].curve}).matrix(targets);
  };
  return {problem, form, alone, neighbours, layer};
}

double error_of_inverse(const StokesProblem& problem, ClusterForm form, double gap) {
  return inversion_error(clusters(problem, form, gap),
                         assemble(problem, ClosureForm::reduced).matrix);
}

int iterations(const StokesProblem& problem, ClusterForm form) {
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const GmresResult result = gmres(map_of(system.matrix), clusters(problem, form),
                                   normal_matrix(system.matrix.rows(), 1, 5), {1e-10, 100});
  BOOST_TEST(result.converged);
  return result.iterations;
}

// Places disks of radius 1 at the origin and, unless there is one disk only, at six places around
// it, at gaps of 0.5. All disks have the velocity (1, 0).
StokesProblem moving_disks(std::size_t count) {
  StokesProblem problem;
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = std::numbers::pi / 3.0 * static_cast<double>(k);
    const Complex centre = k == 0 ? Complex{} : std::polar(2.5, angle);
    const Curve curve = place(sample(Circle{1.0}, 32, Side::fluid_outside), centre, 0.0);
    const ComplexVector velocity = ComplexVector::Constant(32, 1.0);
    problem.components.push_back({ComponentKind::prescribed, curve, centre, {}, 0.0, velocity});
  }
  return problem;
}

// Returns the sum of the disks' forces over 4 pi mu, for Stokeslets with a given gauge length.
double force_of_disks(std::size_t count, double gauge) {
  StokesProblem problem = moving_disks(count);
  problem.gauge_length = gauge;
  const DenseSystem system = assemble(problem, ClosureForm::reduced);
  const VectorXd density = solve(system.matrix, system.rhs);
  Complex force;
  for (const Load& load : complete_dense(problem, ClosureForm::reduced, density).loads) {
    force += load.force;
  }
  return force.real() / (4.0 * std::numbers::pi);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cluster_preconditioner)

BOOST_AUTO_TEST_CASE(uncompressed_clusters_of_all_free_bodies_are_the_inverse) {
  // The Gram matrices resolve all directions except those with singular values below the square
  // root of rounding.
  const double tight = 1e-24;
  for (const ClusterForm form : {ClusterForm::mobility, ClusterForm::resistance}) {
    BOOST_TEST(error_of_inverse(pair(ComponentKind::free_body), form, tight) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(compression_leaves_little) {
  for (const ClusterForm form : {ClusterForm::mobility, ClusterForm::resistance}) {
    const StokesProblem problem = pair(ComponentKind::free_body);
    BOOST_TEST(clusters(problem, form).mean_rank() < 30);
    BOOST_TEST(error_of_inverse(problem, form, 0.2) < 0.2);
    BOOST_TEST(iterations(problem, form) <= 10);
  }
}

BOOST_AUTO_TEST_CASE(held_bodies_are_held_in_both_forms) {
  for (const ClusterForm form : {ClusterForm::mobility, ClusterForm::resistance}) {
    BOOST_TEST(iterations(pair(ComponentKind::prescribed), form) <= 12);
  }
}

BOOST_AUTO_TEST_CASE(clusters_need_a_gauge_longer_than_those_of_single_bodies) {
  const double own = std::sqrt(std::numbers::e), held = held_gauge(moving_disks(7));
  BOOST_TEST(std::abs(held - 100.0) < 1e-11);
  // 1 / (log(ell / R) + 1/2) for one disk, R = 1.
  BOOST_TEST(std::abs(force_of_disks(1, own) - 1.0) < 1e-12);
  BOOST_TEST(std::abs(force_of_disks(1, held) - 1.0 / (std::log(held) + 0.5)) < 1e-12);
  // Seven disks are larger than the degenerate scale R = e of the disks' own gauges.
  const double with_own = force_of_disks(7, own), with_held = force_of_disks(7, held);
  BOOST_TEST(with_own < -1.0);
  BOOST_TEST(with_held > 0.2);
  BOOST_TEST(with_held < 0.3);
  BOOST_TEST(std::abs(1.0 / with_held - 1.0 / with_own - std::log(held / own)) < 1e-9);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
