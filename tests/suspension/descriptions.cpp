// Tests that the text of the dry run agrees with the scene: the reason for each choice, who chose
// the nodes, and errors that no number of nodes resolves.

#include <algorithm>

#include "suspension/motion/describe.hpp"
#include "suspension/scenes.hpp"

namespace stokesbook::test {

namespace {

// Returns all lines of one topic.
std::vector<std::string> told(const Scene& scene, const std::string& topic) {
  std::vector<std::string> lines = describe(SuspensionSolver(scene));
  std::erase_if(lines, [&](const std::string& line) { return !line.starts_with(topic); });
  return lines;
}

bool mentions(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

Scene disk(double tolerance) {
  Scene result = scene({body(Circle{1.0}, 32, 0.0)}, ShearFlow{1.0});
  result.solver.tolerance = tolerance;
  return result;
}

Scene two_disks() {
  Scene result = disk(1e-6);
  result.bodies.push_back(body(Circle{1.0}, 32, {4.0, 0.0}));
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(descriptions)

BOOST_AUTO_TEST_CASE(the_residual_follows_the_tolerance_until_rounding_limits_it) {
  const std::string above = told(disk(1e-11), "GMRES").at(0), at = told(disk(1e-12), "GMRES").at(0),
                    below = told(disk(1e-13), "GMRES").at(0);
  BOOST_TEST(mentions(above, "to 1e-13"));
  BOOST_TEST(mentions(at, "to 1e-14"));
  BOOST_TEST(mentions(below, "to 1e-14"));
  BOOST_TEST(!mentions(above, "rounding"));
  BOOST_TEST(!mentions(at, "rounding"));
  BOOST_TEST(mentions(below, "rounding"));
}

BOOST_AUTO_TEST_CASE(a_fast_sum_that_the_scene_asks_for_is_said_to_be_asked_for) {
  Scene asked = disk(1e-6);
  asked.solver.summation = Summation::fmm;
  const std::string line = told(asked, "summation").at(0);
  BOOST_TEST(mentions(line, "fast multipole method"));
  BOOST_TEST(mentions(line, "solver.summation"));
  BOOST_TEST(!mentions(line, "break-even"));
}

BOOST_AUTO_TEST_CASE(what_decided_on_the_preconditioner_is_said) {
  Scene pair = two_disks();
  BOOST_TEST(!mentions(told(pair, "preconditioner").at(0), "solver."));
  pair.solver.preconditioner = PreconditionerKind::none;
  BOOST_TEST(mentions(told(pair, "preconditioner").at(0), "solver.preconditioner"));
  pair.solver.preconditioner = PreconditionerKind::automatic;
  pair.solver.coupling = Coupling::local;
  BOOST_TEST(mentions(told(pair, "preconditioner").at(0), "solver.coupling = \"local\""));
}

BOOST_AUTO_TEST_CASE(a_reversal_after_the_end_is_told) {
  Scene sheared = disk(1e-6);
  sheared.time = TimeSettings{.t_final = 2.0};
  sheared.reverse_at = {1.0, 2.0};
  BOOST_TEST(!mentions(told(sheared, "time").at(0), "reverse_at"));
  sheared.reverse_at = {1.0, 20.0, 30.0};
  BOOST_TEST(mentions(told(sheared, "time").at(0), "reverse_at = 20 is after the end"));
}

BOOST_AUTO_TEST_CASE(the_problem_is_named_with_what_is_in_it) {
  Scene enclosed = disk(1e-6);
  BOOST_TEST(mentions(told(enclosed, "problem").at(0), "no enclosing wall"));
  enclosed.flow = QuiescentFlow{};
  enclosed.walls = {outer_wall(Circle{4.0}, 64)};
  BOOST_TEST(mentions(told(enclosed, "problem").at(0), "1 free body"));
  BOOST_TEST(mentions(told(enclosed, "problem").at(0), "one enclosing wall"));
}

BOOST_AUTO_TEST_CASE(each_decision_has_a_line) {
  const auto topics = [](const Scene& scene) {
    std::string all;
    for (const std::string& line : describe(SuspensionSolver(scene))) {
      all += line.substr(0, line.find("  ")) + "; ";
    }
    return all;
  };
  Scene pair = two_disks();
  BOOST_TEST(topics(pair) ==
             "problem; far field; singularities; N_0; near correction; preconditioner; GMRES; "
             "contact; time; unknowns; summation; components; closest pair; ");
  BOOST_TEST(mentions(told(pair, "unknowns").at(0), "128: 64 nodes"));
  BOOST_TEST(!mentions(told(pair, "contact").at(0), "least gap"));
  BOOST_TEST(told(pair, "coupling").empty());
  Scene in_contact = pair;
  in_contact.contact = ContactSettings{0.1};
  BOOST_TEST(mentions(told(in_contact, "contact").at(0), "least gap 0.1"));
  pair.solver.coupling = Coupling::local;
  BOOST_TEST(mentions(told(pair, "coupling").at(0), "lagged"));
}

BOOST_AUTO_TEST_CASE(tolerances_below_which_nothing_is_factorised) {
  Scene pair = two_disks();
  for (const double tolerance : {1e-8, 0.9e-8}) {
    pair.solver.tolerance = tolerance;
    BOOST_TEST(SuspensionSolver(pair).plan().direct_allowed == (tolerance == 1e-8));
  }
}

BOOST_AUTO_TEST_CASE(contact_asks_for_sums_a_hundred_times_as_accurate) {
  Scene pair = two_disks();
  pair.solver.tolerance = 1e-4;
  const Plan without = SuspensionSolver(pair).plan();
  pair.contact = ContactSettings{0.1};
  const Plan with = SuspensionSolver(pair).plan();
  const auto equal = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(100.0 * with.near_tolerance == without.near_tolerance, equal);
  BOOST_TEST(100.0 * with.sum_tolerance == without.sum_tolerance, equal);
}

BOOST_AUTO_TEST_CASE(given_and_chosen_nodes_are_told_apart) {
  Scene pair = disk(1e-6);
  pair.bodies[0].n_nodes = automatic_nodes;
  const int chosen = SuspensionSolver(pair).discretisation()[0]->resolution.n_nodes;
  pair.bodies.push_back(body(Circle{1.0}, chosen, {100.0, 0.0}));
  for (int turn = 0; turn < 2; ++turn) {
    const std::vector<std::string> lines = told(pair, "components");
    BOOST_REQUIRE_EQUAL(lines.size(), 2U);
    for (const bool is_chosen : {true, false}) {
      const std::string& line = lines[is_chosen == (turn == 0) ? 0 : 1];
      BOOST_TEST(mentions(line, "1 x circle 1"));
      BOOST_TEST(mentions(line, "chosen") == is_chosen);
      BOOST_TEST(mentions(line, "recommended") == !is_chosen);
    }
    std::swap(pair.bodies[0], pair.bodies[1]);
  }
}

BOOST_AUTO_TEST_CASE(where_no_number_of_nodes_does_none_is_recommended) {
  Scene slender = disk(1e-12);
  slender.bodies[0].shape = Ellipse{1.0, 1e-3};
  const std::string line = told(slender, "components").at(0);
  BOOST_TEST(mentions(line, "no number up to 4096"));
  BOOST_TEST(!mentions(line, "recommended"));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
