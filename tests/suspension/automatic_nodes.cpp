// Tests automatic numbers of nodes: they meet the tolerance, depend on the configuration alone and
// keep given numbers. If no number suffices, the error message contains the number needed.

#include "scenes.hpp"
#include "support/closed_forms.hpp"
#include "suspension/nodes/node_choice.hpp"

namespace stokesbook::test {
namespace {

Scene automatic_pair(double gap, double tolerance) {
  Scene pair = scene({body(Circle{1}, automatic_nodes, -1 - gap / 2),
                      body(Circle{1}, automatic_nodes, 1 + gap / 2)},
                     ExtensionalFlow{1});
  pair.solver.tolerance = tolerance;
  return pair;
}

// A slender loaded body requires more nodes than its shape alone, since the Stokeslet inside is
// close to the boundary.
Scene slender_beside_circle(int nodes_of_the_slender, int nodes_of_the_circle) {
  Scene both = with_gauge(scene({body(Ellipse{1, 0.25}, nodes_of_the_slender, {}, 0.3, {1.0, 0.2}),
                                 body(Circle{0.5}, nodes_of_the_circle, {0.2, 2.0})}),
                          20.0);
  both.solver.tolerance = 1e-9;
  return both;
}

std::vector<int> nodes_of(const Solution& solution) {
  std::vector<int> nodes;
  for (const auto& reference : solution.discretisation)
    nodes.push_back(reference->resolution.n_nodes);
  return nodes;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(automatic)

BOOST_AUTO_TEST_CASE(pairs_meet_the_tolerance) {
  for (const double gap : {1.0, 0.1, 0.01, 0.001}) {
    for (const double tolerance : {1e-5, 1e-10}) {
      const Solved solved(automatic_pair(gap, tolerance));
      const double exact = CirclePair{1, gap}.speed_in_extension(1);
      // The largest velocity of the data is about 2.
      BOOST_TEST(std::abs(solved.motion(1).velocity - exact) < 2 * tolerance);
      BOOST_TEST(solved.solution.error_estimate <= tolerance);
    }
  }
}

BOOST_AUTO_TEST_CASE(nodes_are_raised_where_the_tail_asks_for_them) {
  const Scene free_choice = slender_beside_circle(automatic_nodes, automatic_nodes);
  const Solved solved(free_choice);
  const Resolutions first = first_resolutions(solved.solver);
  const std::vector<int> nodes = nodes_of(solved.solution);
  BOOST_TEST(nodes[0] > first[0].n_nodes);
  BOOST_TEST(nodes[0] > nodes[1]);
  // The cost includes all attempts.
  BOOST_TEST(solved.solution.cost.gmres_iterations > solved.solution.gmres.iterations);
}

BOOST_AUTO_TEST_CASE(given_counts_stay) {
  const Solved solved(slender_beside_circle(automatic_nodes, 48));
  BOOST_TEST(nodes_of(solved.solution)[1] == 48);
  check_refused(slender_beside_circle(32, automatic_nodes), {"body 0", "32 nodes", "n_nodes"});
}

// The nodes do not depend on earlier solves of the same solver.
BOOST_AUTO_TEST_CASE(nodes_depend_on_the_configuration_alone) {
  const Scene scene = slender_beside_circle(automatic_nodes, automatic_nodes);
  const SuspensionSolver experienced(scene), fresh(scene);
  const Instant start = experienced.start();
  Instant closer = start;
  closer.configuration[1].position = {0.0, 0.8};
  const Solution near = experienced.solve(closer);
  const Solution again = experienced.solve(start), first = fresh.solve(start);
  BOOST_TEST(nodes_of(near)[1] > nodes_of(first)[1]);
  BOOST_TEST(nodes_of(again) == nodes_of(first), boost::test_tools::per_element());
  BOOST_TEST((again.density == first.density));
}

// Inner stages of a step have at least the nodes of the first solve of the step.
BOOST_AUTO_TEST_CASE(nearby_solves_keep_the_nodes) {
  const Solved solved(slender_beside_circle(automatic_nodes, automatic_nodes));
  Instant moved = solved.solver.start();
  moved.configuration[0].position += 1e-3;
  const Solution nearby =
      solved.solver.solve_nearby(moved, resolutions_of(solved.solution.discretisation));
  BOOST_TEST(nodes_of(nearby) == nodes_of(solved.solution), boost::test_tools::per_element());
  BOOST_TEST(std::isnan(nearby.error_estimate));
  const Solution estimated = solved.solver.solve(moved);
  BOOST_TEST(distance(nearby.motions[0], estimated.motions[0]) < 1e-9);
}

BOOST_AUTO_TEST_CASE(says_what_it_would_need) {
  Scene needle = scene({body(Ellipse{2.0, 0.01}, automatic_nodes, {})}, ShearFlow{1.0});
  needle.solver.tolerance = 1e-10;
  check_refused(needle, {"body 0", "would need n_nodes", "2048"});
  check_refused(automatic_pair(1e-3, 1e-14), {"rounding", "solver.tolerance"});
}

BOOST_AUTO_TEST_CASE(few_counts_are_chosen) {
  BOOST_TEST(rounded_nodes(0.0) == 16);
  BOOST_TEST(rounded_nodes(16.5) == 32);
  BOOST_TEST(rounded_nodes(256.0) == 256);
  BOOST_TEST(rounded_nodes(257.0) == 288);
  BOOST_TEST(rounded_nodes(1025.0) == 1152);
}

BOOST_AUTO_TEST_CASE(a_cache_drops_the_shapes_that_were_not_used_lately) {
  DiscretisationCache cache({}, 3);
  const auto kept = cache.get(Circle{1}, {32}, ComponentKind::free_body);
  for (int n = 34; n < 100; n += 2) {
    cache.get(Circle{1}, {n}, ComponentKind::free_body);
    BOOST_TEST(cache.size() <= 3u);
  }
  const auto latest = cache.get(Circle{1}, {98}, ComponentKind::free_body);
  cache.get(Circle{1}, {94}, ComponentKind::free_body);  // 94 is used again, so 96 is dropped first
  cache.get(Circle{1}, {34}, ComponentKind::free_body);
  BOOST_TEST((cache.get(Circle{1}, {98}, ComponentKind::free_body) == latest));
  const auto anew = cache.get(Circle{1}, {32}, ComponentKind::free_body);
  BOOST_TEST((anew != kept));
  BOOST_TEST((anew->curve.x == kept->curve.x));
  BOOST_TEST((cache.get(Circle{1}, {32}, ComponentKind::free_body) == anew));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
