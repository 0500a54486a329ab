// Clusters of held bodies: the counts of nearly touching bodies, and the same solutions as without.

#include "suspension/clusters.hpp"

#include <omp.h>

#include "double_layer/double_layer.hpp"
#include "suspension/scenes.hpp"

namespace stokesbook::test {

namespace {

Scene with_preconditioner(Scene scene, PreconditionerKind preconditioner) {
  scene.solver.preconditioner = preconditioner;
  return scene;
}

Scene disks(const std::vector<Complex>& positions) {
  std::vector<Body> bodies;
  for (const Complex position : positions) {
    bodies.push_back(body(Circle{1.0}, automatic_nodes, position));
  }
  Scene result = scene(bodies, ShearFlow{1.0});
  result.solver.tolerance = 1e-6;
  return result;
}

Scene chain(double gap) {
  std::vector<Complex> positions;
  for (int k = -2; k <= 2; ++k) positions.push_back(std::polar(k * (2.0 + gap), 0.3));
  return disks(positions);
}

// A disk among rings of six, twelve, ... disks that touch their neighbours but for a gap.
Scene hexagon(int rings, double gap) {
  std::vector<Complex> positions;
  for (int i = -rings; i <= rings; ++i) {
    for (int j = -rings; j <= rings; ++j) {
      if (std::abs(i + j) > rings) continue;
      positions.push_back(std::polar(2.0 + gap, 0.2) *
                          Complex(i + 0.5 * j, 0.5 * std::numbers::sqrt3 * j));
    }
  }
  return disks(positions);
}

Scene taylor_green() {
  std::vector<Body> ellipses;
  for (const double x : {-1.492, -0.4973, 0.4973, 1.492}) {
    for (int k = 0; k < 12; ++k) {
      ellipses.push_back(body(Ellipse{0.475, 0.1}, automatic_nodes, {x, 0.13567 * (2 * k - 11)}));
    }
  }
  Scene result = scene(ellipses, TaylorGreenFlow{1.0});
  result.solver.tolerance = 1e-3;
  return result;
}

// The system at its first resolution, as solve() begins.
struct Discretised {
  SuspensionSolver solver;
  Configuration configuration;
  References references;
  DiscreteProblem discrete;

  explicit Discretised(const Scene& scene)
      : solver(scene),
        configuration(solver.initial_configuration()),
        references(solver.references(solver.first_resolutions(configuration))),
        discrete(solver.discretise(configuration, references)) {}
};

int iterations(const Scene& scene) {
  const DiscreteProblem discrete = Discretised(scene).discrete;
  const GmresResult result = solve(discrete, discrete.system.right_hand_side(), {1e-8, 300});
  BOOST_TEST(result.converged);
  return result.iterations;
}

int iterations_by_clusters(const Scene& scene) {
  return iterations(with_preconditioner(scene, PreconditionerKind::clusters));
}

// A free disk, a held one and an inner wall, all nearly touching, perhaps in a container.
Scene mixed(const std::vector<Wall>& walls) {
  std::vector<Wall> all = walls;
  all.push_back(inner_wall(Circle{1.0}, automatic_nodes, RotatingWall{0.5}, {-1.0, 1.83}));
  Scene result = scene({body(Ellipse{1.2, 0.8}, automatic_nodes, {-1.21, 0}),
                        held_body(Circle{1.0}, automatic_nodes, {1.0, 0}, 0.0, {{0.1, 0.2}, 0.3}),
                        body(Circle{0.5}, automatic_nodes, {0.6, 1.45}, 0.0, {{0.3, -0.2}, 0.1})},
                       {}, all);
  result.solver.tolerance = 1e-6;
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_and_hexagons_take_few_iterations) {
  BOOST_TEST(iterations_by_clusters(chain(1e-3)) <= 12);
  BOOST_TEST(iterations_by_clusters(hexagon(1, 1e-2)) <= 12);
  BOOST_TEST(iterations_by_clusters(hexagon(1, 1e-3)) <= 24);
}

BOOST_AUTO_TEST_CASE(two_rings_about_a_disk_take_few_iterations) {
  BOOST_TEST(iterations_by_clusters(hexagon(2, 1e-2)) <= 18);
}

BOOST_AUTO_TEST_CASE(slender_ellipses_in_vortices_take_few_iterations) {
  BOOST_TEST(iterations_by_clusters(taylor_green()) <= 12);
}

BOOST_AUTO_TEST_CASE(without_neighbours_clusters_are_components_alone) {
  const Scene far = disks({{-4, 0}, {4, 0}});
  BOOST_TEST(std::abs(iterations_by_clusters(far) -
                      iterations(with_preconditioner(far, PreconditionerKind::block_diagonal))) <=
             1);
}

BOOST_AUTO_TEST_CASE(solutions_are_those_without_a_preconditioner) {
  const Wall container = outer_wall(Circle{6.0}, automatic_nodes, RotatingWall{-0.4});
  for (const Scene& scene :
       {chain(3e-2), mixed({}), with_gauge(mixed({}), 50.0), mixed({container})}) {
    const Solved with(with_preconditioner(scene, PreconditionerKind::clusters));
    const Solved without(with_preconditioner(scene, PreconditionerKind::none));
    BOOST_TEST(2 * with.solution.gmres.iterations < without.solution.gmres.iterations);
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      BOOST_TEST(std::abs(with.motion(k).velocity - without.motion(k).velocity) < 1e-6);
      BOOST_TEST(std::abs(with.motion(k).omega - without.motion(k).omega) < 1e-6);
      BOOST_TEST(std::abs(with.load(k).force - without.load(k).force) < 1e-4);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_linear_and_exact_for_rigid_motions) {
  const DiscreteProblem discrete =
      Discretised(with_preconditioner(hexagon(1, 1e-2), PreconditionerKind::clusters)).discrete;
  const Eigen::Index n = 2 * discrete.system.offsets().back();
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0).array().sin(),
                        w = Eigen::VectorXd::LinSpaced(n, 3.0, -50.0).array().cos();
  const Eigen::VectorXd sum = discrete.precondition(2.0 * v - 3.0 * w),
                        terms = 2.0 * discrete.precondition(v) - 3.0 * discrete.precondition(w);
  BOOST_TEST((sum - terms).norm() < 1e-8 * terms.norm());
  // The operator takes a rigid motion of one body to its negative, and nothing to the others.
  ComplexVector motion = ComplexVector::Zero(n / 2);
  const Component& component = discrete.problem.components[2];
  motion.segment(discrete.system.offsets()[2], component.curve.size()) =
      (Complex(0.3, -0.7) + 0.4 * imaginary * (component.curve.x.array() - component.centre))
          .matrix();
  const Eigen::VectorXd rigid = interleaved(motion);
  BOOST_TEST((discrete.precondition(rigid) + rigid).norm() < 1e-8 * rigid.norm());
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  const Scene scene = with_preconditioner(hexagon(1, 1e-2), PreconditionerKind::clusters);
  const auto applied = [&](int threads) {
    omp_set_num_threads(threads);
    const DiscreteProblem discrete = Discretised(scene).discrete;
    const ComplexVector rhs = discrete.system.right_hand_side();
    return discrete.precondition(interleaved(rhs));
  };
  const Eigen::VectorXd one = applied(1), two = applied(2);
  BOOST_TEST((one.array() == two.array()).all());
}

BOOST_AUTO_TEST_CASE(neighbours_are_mutual_and_leave_enclosing_walls_out) {
  const Wall container = outer_wall(Circle{6.0}, automatic_nodes);
  const Discretised start(mixed({container}));
  const auto neighbours = cluster_neighbours(start.configuration, start.references);
  BOOST_TEST(neighbours[3].empty());
  for (std::size_t a = 0; a < neighbours.size(); ++a) {
    for (const Neighbour& b : neighbours[a]) {
      BOOST_TEST(std::ranges::count(neighbours[b.component], a, &Neighbour::component) == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_plan_takes_clusters_where_many_gaps_are_tight) {
  const auto pays = [](const Scene& scene) {
    const Discretised start(scene);
    return clusters_pay(start.configuration, start.references);
  };
  BOOST_TEST(pays(chain(1e-3)));
  BOOST_TEST(pays(hexagon(1, 1e-3)));
  BOOST_TEST(!pays(hexagon(1, 1e-2)));
  BOOST_TEST(!pays(disks({{0, 0}})));
  BOOST_TEST(iterations(chain(1e-3)) == iterations_by_clusters(chain(1e-3)));
}

}  // namespace stokesbook::test
