// Tests clusters and trees of groups: iteration counts of nearly touching bodies, solutions equal to
// those without them, and trees that several solves share.

#include <cmath>

#include <omp.h>

#include "double_layer/double_layer.hpp"
#include "support/touching.hpp"
#include "suspension/motion/instant_solver.hpp"
#include "suspension/scenes.hpp"
#include "suspension/system/error_estimate.hpp"
#include "suspension/system/preconditioner.hpp"
#include "suspension/system/preconditioner_choice.hpp"

namespace stokesbook::test {

namespace {

int iterations(const Scene& scene) {
  const LinearSystem discrete = Discretised(scene).discrete;
  const GmresResult result = solve(discrete, discrete.system.right_hand_side(), {1e-8, 300});
  BOOST_TEST(result.converged);
  return result.iterations;
}

int iterations_by(const Scene& scene, PreconditionerKind kind) {
  return iterations(with_preconditioner(scene, kind));
}

int iterations_by_clusters(const Scene& scene) {
  return iterations_by(scene, PreconditionerKind::clusters);
}

// Returns an ellipse, a held disk, a free disk and an inner wall, all nearly touching, with further
// walls.
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

// Returns equal bodies in a square of rows and columns, with narrow gaps, in a round container.
Scene square_in_container(int rows, const Ellipse& shape, double tolerance = 1e-5) {
  const Complex spacing{2.0 * shape.a + 0.03, 2.0 * shape.b + 0.03};
  const double radius = 0.5 * rows * std::abs(spacing) + 1.0;
  Scene result = scene({}, {}, {outer_wall(Circle{radius}, automatic_nodes)});
  result.solver.tolerance = tolerance;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double x = i - 0.5 * (rows - 1), y = j - 0.5 * (rows - 1);
      result.bodies.push_back(
          body(shape, automatic_nodes, {x * spacing.real(), y * spacing.imag()}));
    }
  }
  return result;
}

PreconditionerKind chosen(const Scene& scene) {
  const Discretised start(with_preconditioner(scene, PreconditionerKind::none));
  return chosen_preconditioner(make_plan(scene), start.solver.gaps(start.configuration),
                               start.discretisation, start.solver.separation());
}

}  // namespace

BOOST_AUTO_TEST_CASE(chains_and_hexagons_take_few_iterations) {
  BOOST_TEST(iterations_by_clusters(disk_chain(1e-3)) <= 12);
  BOOST_TEST(iterations_by_clusters(disk_hexagon(1, 1e-2)) <= 12);
  BOOST_TEST(iterations_by_clusters(disk_hexagon(1, 1e-3)) <= 24);
}

BOOST_AUTO_TEST_CASE(two_rings_about_a_disk_take_few_iterations, *boost::unit_test::label("full")) {
  BOOST_TEST(iterations_by_clusters(disk_hexagon(2, 1e-2)) <= 18);
}

BOOST_AUTO_TEST_CASE(slender_ellipses_in_vortices_take_few_iterations) {
  BOOST_TEST(iterations_by_clusters(ellipses_in_vortices(1e-3)) <= 12);
}

BOOST_AUTO_TEST_CASE(without_neighbours_clusters_are_components_alone) {
  const Scene far = scene(
      {body(Circle{1.0}, automatic_nodes, {-4, 0}), body(Circle{1.0}, automatic_nodes, {4, 0})},
      ShearFlow{1.0});
  BOOST_TEST(std::abs(iterations_by_clusters(far) -
                      iterations(with_preconditioner(far, PreconditionerKind::block_diagonal))) <=
             1);
}

BOOST_AUTO_TEST_CASE(solutions_are_those_without_a_preconditioner) {
  const Wall container = outer_wall(Circle{6.0}, automatic_nodes, RotatingWall{-0.4});
  for (const Scene& scene :
       {disk_chain(3e-2), mixed({}), with_gauge(mixed({}), 50.0), mixed({container})}) {
    const Solved without(with_preconditioner(scene, PreconditionerKind::none));
    for (const auto kind : {PreconditionerKind::clusters, PreconditionerKind::hierarchical}) {
      const Solved with(with_preconditioner(scene, kind));
      BOOST_TEST(2 * with.solution.gmres.iterations < without.solution.gmres.iterations);
      for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        BOOST_TEST(std::abs(with.motion(k).velocity - without.motion(k).velocity) < 1e-6);
        BOOST_TEST(std::abs(with.motion(k).omega - without.motion(k).omega) < 1e-6);
        BOOST_TEST(std::abs(with.load(k).force - without.load(k).force) < 1e-4);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_preconditioner_is_linear_and_exact_for_rigid_motions) {
  const LinearSystem discrete =
      Discretised(with_preconditioner(disk_hexagon(1, 1e-2), PreconditionerKind::clusters))
          .discrete;
  const Eigen::Index n = 2 * discrete.system.offsets().back();
  const Eigen::VectorXd v = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0).array().sin(),
                        w = Eigen::VectorXd::LinSpaced(n, 3.0, -50.0).array().cos();
  const Eigen::VectorXd sum = discrete.precondition(2.0 * v - 3.0 * w),
                        terms = 2.0 * discrete.precondition(v) - 3.0 * discrete.precondition(w);
  BOOST_TEST((sum - terms).norm() < 1e-8 * terms.norm());
  // The operator maps a rigid motion of one body to the negative motion on this body, and to zero
  // on the other bodies.
  ComplexVector motion = ComplexVector::Zero(n / 2);
  const Component& component = discrete.problem().components[2];
  motion.segment(discrete.system.offsets()[2], component.curve.size()) =
      (Complex(0.3, -0.7) + 0.4 * imaginary * (component.curve.x.array() - component.centre))
          .matrix();
  const Eigen::VectorXd rigid = interleaved(motion);
  BOOST_TEST((discrete.precondition(rigid) + rigid).norm() < 1e-8 * rigid.norm());
}

// A solve takes no product for its residual where rounding errors are negligible. They are not for
// a disk that moves among held ones that nearly touch it: its density is far larger than its
// velocity.
BOOST_AUTO_TEST_CASE(the_residual_of_a_solve_is_that_of_its_density) {
  const auto takes_a_product = [](const Scene& scene, double tolerance) {
    const LinearSystem discrete = Discretised(scene).discrete;
    const ComplexVector rhs = discrete.system.right_hand_side();
    const GmresResult result = solve(discrete, rhs, {tolerance, 500});
    BOOST_TEST(result.converged);
    const ComplexVector residual = rhs - discrete.system(deinterleaved(result.solution));
    BOOST_TEST(std::abs(residual.norm() / rhs.norm() - result.residual) < 0.01 * tolerance);
    return result.applications > result.iterations;
  };
  for (const double gap : {1e-2, 1e-6}) {
    const Scene free = with_preconditioner(disk_hexagon(1, gap, 1e-4), PreconditionerKind::direct);
    Scene held = free;
    for (Body& body : held.bodies) body.held = true;
    held.bodies.front().velocity = {0.0, 1.0};
    for (const double tolerance : {1e-2, 1e-6}) {
      BOOST_TEST(!takes_a_product(free, tolerance));
      BOOST_TEST(takes_a_product(held, tolerance) == (tolerance < 1e-3 || gap < 1e-3));
    }
  }
}

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  for (const ClusterForm form : {ClusterForm::resistance, ClusterForm::mobility}) {
    const auto applied = [&](int threads) {
      omp_set_num_threads(threads);
      const LinearSystem discrete = Discretised(disk_hexagon(1, 1e-2), form).discrete;
      const ComplexVector rhs = discrete.system.right_hand_side();
      return discrete.precondition(interleaved(rhs));
    };
    const Eigen::VectorXd one = applied(1), two = applied(2);
    BOOST_TEST((one.array() == two.array()).all());
  }
}

BOOST_AUTO_TEST_CASE(a_block_that_is_singular_is_told_of_whatever_the_threads) {
  const Discretised start(disk_hexagon(1, 1e-2));
  Discretisation discretisation = start.discretisation;
  DiscretisedShape broken = *discretisation[2];
  broken.curve.dx.setZero();
  discretisation[2] = std::make_shared<const DiscretisedShape>(broken);
  for (const ClusterForm form : {ClusterForm::resistance, ClusterForm::mobility}) {
    for (const int threads : {1, 2}) {
      omp_set_num_threads(threads);
      BOOST_CHECK_THROW(cluster_preconditioner(start.discrete.problem(), start.configuration,
                                               discretisation, {}, form),
                        std::domain_error);
    }
  }
  omp_set_num_threads(1);
}

BOOST_AUTO_TEST_CASE(free_clusters_solve_crowds_and_held_ones_networks,
                     *boost::unit_test::label("full")) {
  const auto count = [](const Scene& scene, ClusterForm form) {
    const LinearSystem discrete = Discretised(scene, form).discrete;
    return solve(discrete, discrete.system.right_hand_side(), {1e-8, 300}).iterations;
  };
  const Scene crowd = disk_packing(200), network = disk_hexagon(2, 1e-2, 1e-3);
  BOOST_TEST(count(crowd, ClusterForm::mobility) < count(crowd, ClusterForm::resistance));
  BOOST_TEST(2 * count(network, ClusterForm::resistance) < count(network, ClusterForm::mobility));
}

BOOST_AUTO_TEST_CASE(random_packings_take_few_iterations_in_a_tree) {
  BOOST_TEST(iterations_by(disk_packing(150), PreconditionerKind::hierarchical) <= 26);
}

// With the tolerances of other scenes, this chain takes more.
BOOST_AUTO_TEST_CASE(tight_chains_take_few_iterations_in_a_tree) {
  BOOST_TEST(iterations_by(loaded_line(30, 1e-3), PreconditionerKind::hierarchical) <= 22);
}

BOOST_AUTO_TEST_CASE(dense_packings_take_few_iterations_in_a_tree,
                     *boost::unit_test::label("full")) {
  BOOST_TEST(iterations_by(disk_packing(1000), PreconditionerKind::hierarchical) <= 40);
  const Scene network = disk_hexagon(2, 1e-2, 1e-3);
  BOOST_TEST(iterations_by(network, PreconditionerKind::hierarchical) <= 40);
}

BOOST_AUTO_TEST_CASE(crystals_are_told_from_crowds) {
  const auto is_one = [](const Scene& scene) {
    const Discretised start(with_preconditioner(scene, PreconditionerKind::none));
    return is_crystal(start.solver.gaps(start.configuration), start.discretisation);
  };
  BOOST_TEST(!is_one(disk_packing(200)));
  BOOST_TEST(!is_one(disk_hexagon(2, 1e-3, 1e-1)));  // few disks
  Scene crystal = disk_hexagon(3, 1e-3, 1e-1);       // 90 contacts of 37 disks
  BOOST_TEST(is_one(crystal));
  crystal.bodies[0].held = true;
  BOOST_TEST(!is_one(crystal));
  BOOST_TEST(!is_one(disk_hexagon(3, 1e-2, 1e-1)));  // wider gaps
}

BOOST_AUTO_TEST_CASE(trees_last_until_bodies_have_moved_past_each_other) {
  const Discretised start(disk_hexagon(1, 0.01));
  const Configuration& earlier = start.configuration;
  const std::vector<Gap> gaps = start.solver.gaps(earlier);
  const double radius = start.discretisation[0]->gyration_radius;
  const double length = 2.0 * std::sqrt(0.01 * radius);  // for the narrowest gaps
  const auto lasts = [&](const Configuration& later) {
    return tree_lasts(earlier, later, gaps, start.discretisation);
  };
  const auto with_one_moved = [&](Complex path, double angle) {
    Configuration later = earlier;
    later[2].position += path;
    later[2].orientation += angle;
    return later;
  };
  BOOST_TEST(lasts(earlier));
  for (const double sign : {1.0, -1.0}) {
    BOOST_TEST(lasts(with_one_moved({0.0, sign * 0.99 * length}, 0.0)));
    BOOST_TEST(!lasts(with_one_moved({0.0, sign * 1.01 * length}, 0.0)));
    BOOST_TEST(lasts(with_one_moved({}, sign * 0.99 * length / radius)));
    BOOST_TEST(!lasts(with_one_moved({}, sign * 1.01 * length / radius)));
    BOOST_TEST(!lasts(with_one_moved({0.0, 0.6 * length}, sign * 0.6 * length / radius)));
  }
  Configuration carried = earlier;
  for (Pose& pose : carried) pose.position += Complex{100.0, -30.0};
  BOOST_TEST(lasts(carried));
}

BOOST_AUTO_TEST_CASE(solves_nearby_share_a_tree) {
  Scene scene = with_preconditioner(disk_hexagon(1, 0.1, 1e-5), PreconditionerKind::hierarchical);
  const SuspensionSolver solver(scene);
  const Solution first = solver.solve(solver.start());
  const Resolutions nodes = resolutions_of(first.discretisation);
  const auto solve_after = [&](double t, const Resolutions& least, const SharedTree& tree) {
    Configuration moved = first.instant.configuration;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k].position += t * first.motions[k].velocity;
      moved[k].orientation += t * first.motions[k].omega;
    }
    return solver.solve_nearby(solver.instant(moved), least, {}, tree);
  };
  const Solution shared = solve_after(0.02, nodes, first.tree), own = solve_after(0.02, nodes, {});
  BOOST_TEST(shared.tree == first.tree);
  BOOST_TEST(own.tree != first.tree);
  BOOST_TEST(own.tree != nullptr);
  BOOST_TEST(shared.gmres.iterations <= own.gmres.iterations + 5);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    BOOST_TEST(std::abs(shared.motions[k].velocity - own.motions[k].velocity) < 1e-6);
    BOOST_TEST(std::abs(shared.motions[k].omega - own.motions[k].omega) < 1e-6);
  }
  // The tree of other nodes, or of bodies elsewhere, does not fit.
  BOOST_TEST(solve_after(0.02, refine(nodes), first.tree).tree != first.tree);
  BOOST_TEST(solve_after(1.0, nodes, first.tree).tree != first.tree);
  // Other preconditioners are built for each solve.
  const SuspensionSolver blocks(with_preconditioner(scene, PreconditionerKind::block_diagonal));
  BOOST_TEST(blocks.solve_nearby(blocks.start(), nodes, {}, first.tree).tree == nullptr);
}

BOOST_AUTO_TEST_CASE(stages_share_the_tree_of_a_step) {
  Scene scene = with_preconditioner(disk_hexagon(1, 0.1, 1e-4), PreconditionerKind::hierarchical);
  scene.time = TimeSettings{0.1, 0.02, SteppingMethod::heun};
  const SuspensionSolver solver(scene);
  const OutputSchedule schedule(scene);
  RunStatistics statistics;
  InstantSolver instants(solver, schedule, statistics, {});
  const Configuration here = solver.start().configuration;
  const SharedTree tree = instants.solve({0.0, 0.0}, here).solution.tree;
  BOOST_TEST(tree != nullptr);
  BOOST_TEST(instants.solve_stage({0.02, 0.0}, here, tree).solution.tree == tree);
  BOOST_TEST(instants.solve({0.02, 0.0}, here).solution.tree != tree);
}

BOOST_AUTO_TEST_CASE(neighbours_are_mutual_and_leave_enclosing_walls_out) {
  const Wall container = outer_wall(Circle{6.0}, automatic_nodes);
  const Discretised start(mixed({container}));
  const auto neighbours = cluster_neighbours(start.configuration, start.discretisation);
  BOOST_TEST(neighbours[3].empty());
  for (std::size_t a = 0; a < neighbours.size(); ++a) {
    for (const Neighbour& b : neighbours[a]) {
      BOOST_TEST(std::ranges::count(neighbours[b.component], a, &Neighbour::component) == 1);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_plan_decides_by_gaps_and_size) {
  using enum PreconditionerKind;
  BOOST_TEST((chosen(disk_chain(1e-3)) == direct));
  BOOST_TEST((chosen(disk_hexagon(1, 1e-3)) == hierarchical));  // more nodes
  BOOST_TEST((chosen(disk_hexagon(1, 1e-2)) == hierarchical));  // wider gaps
  BOOST_TEST((chosen(disk_hexagon(1, 1e-1)) == none));
  BOOST_TEST((chosen(disk_hexagon(2, 1e-2)) == hierarchical));
  BOOST_TEST((chosen(disk_hexagon(2, 1e-3)) == hierarchical));
  BOOST_TEST((chosen(disk_hexagon(2, 1e-2, 1e-3)) == none));          // fewer digits
  BOOST_TEST((chosen(disk_hexagon(2, 1e-3, 1e-3)) == hierarchical));  // but tight gaps
  BOOST_TEST((chosen(with_contact(disk_hexagon(1, 1e-1), 0.1)) == direct));
  BOOST_TEST((chosen(with_contact(disk_hexagon(1, 1e-1), 0.05)) == none));
  // Small systems are factorised for few pairs in contact, larger ones are not.
  const auto nodes = [](const Scene& scene) {
    return node_offsets(Discretised(scene).discrete.problem()).back();
  };
  const auto line = [](int count) {
    return with_contact(with_gauge(loaded_line(count, 0.1), 100.0), 0.1);
  };
  BOOST_TEST(nodes(line(8)) == 256);
  BOOST_TEST((chosen(line(8)) == direct));
  BOOST_TEST(nodes(line(9)) == 288);
  BOOST_TEST((chosen(line(9)) != direct));
  BOOST_TEST((chosen(disk_hexagon(3, 1e-1)) == none));
  BOOST_TEST((chosen(disk_hexagon(3, 1e-1, 1e-8)) == hierarchical));  // more digits
  BOOST_TEST((chosen(disk_hexagon(4, 1e-1)) == hierarchical));        // many gaps, though wide
  BOOST_TEST((chosen(with_contact(disk_hexagon(3, 1e-1), 0.1)) == hierarchical));  // too many nodes
  Scene two_of_many = disk_hexagon(2, 1.0);
  two_of_many.bodies.push_back(two_of_many.bodies.back());
  two_of_many.bodies.back().position *= 10.0;
  two_of_many.bodies.push_back(two_of_many.bodies.back());
  two_of_many.bodies.back().position += 2.05;
  BOOST_TEST((chosen(with_contact(two_of_many, 0.05)) == none));  // too few pairs
  Scene three_of_many = disk_hexagon(3, 1e-1, 1e-5);
  for (const double place : {20.0, 30.0, 40.0}) {
    for (const double aside : {0.0, 2.05}) {
      three_of_many.bodies.push_back(three_of_many.bodies.back());
      three_of_many.bodies.back().position = {place, aside};
    }
  }
  BOOST_TEST((chosen(with_contact(three_of_many, 0.05)) == none));  // few pairs, and no wall
  BOOST_TEST((chosen(disk_packing(150)) == hierarchical));
  BOOST_TEST((chosen(loaded_packing(1000, 0.1)) == hierarchical));
  BOOST_TEST((chosen(loaded_packing(1000, 0.05)) == none));  // most disks are far from all others
  BOOST_TEST((chosen(disk_hexagon(7, 1e-3, 1e-1)) == clusters));  // 169 disks, a crystal
  BOOST_TEST((chosen(mixed({outer_wall(Circle{6.0}, automatic_nodes)})) == direct));
  BOOST_TEST((chosen(scene({body(Circle{1.0}, automatic_nodes, {})}, ShearFlow{1.0})) == none));
}

BOOST_AUTO_TEST_CASE(many_round_bodies_within_a_wall_have_no_tree) {
  using enum PreconditionerKind;
  const Ellipse round{1.0, 0.9}, elongated{3.0, 1.0};
  BOOST_TEST((chosen(square_in_container(12, round)) == hierarchical));
  BOOST_TEST((chosen(square_in_container(13, round)) == block_diagonal));
  BOOST_TEST((chosen(square_in_container(13, elongated)) == hierarchical));
  Scene unbounded = square_in_container(13, round);
  unbounded.walls.clear();
  BOOST_TEST((chosen(unbounded) == hierarchical));
  BOOST_TEST((chosen(square_in_container(9, round)) == hierarchical));
  BOOST_TEST((chosen(square_in_container(9, round, 1e-3)) == block_diagonal));  // fewer digits
}

BOOST_AUTO_TEST_CASE(solves_for_contact_forces_share_a_tree) {
  using enum PreconditionerKind;
  const Scene many = square_in_container(13, {1.0, 0.9});
  BOOST_TEST((chosen(with_contact(many, 1e-3)) == block_diagonal));
  BOOST_TEST((chosen(with_contact(many, 1.0)) == hierarchical));
  const Scene coarse = square_in_container(8, {1.0, 0.9}, 1e-3);
  BOOST_TEST((chosen(with_contact(coarse, 1e-3)) == block_diagonal));
  BOOST_TEST((chosen(with_contact(coarse, 1.0)) == hierarchical));
}

BOOST_AUTO_TEST_CASE(few_digits_need_a_tree_between_elongated_bodies_alone) {
  using enum PreconditionerKind;
  BOOST_TEST((chosen(square_in_container(4, {1.0, 0.9}, 1e-3)) == block_diagonal));
  BOOST_TEST((chosen(square_in_container(4, {3.0, 1.0}, 1e-3)) == hierarchical));
}

BOOST_AUTO_TEST_CASE(a_factorised_system_leaves_nothing_to_iterate) {
  const Wall container = outer_wall(Circle{6.0}, automatic_nodes);
  for (const Scene& scene : {disk_hexagon(1, 1e-2), disk_hexagon(1, 1e-4), mixed({container})}) {
    BOOST_TEST(iterations(with_preconditioner(scene, PreconditionerKind::direct)) <= 2);
  }
}

}  // namespace stokesbook::test
