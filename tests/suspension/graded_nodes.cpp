// Tests the choice of nodes for gaps: equidistant nodes where these suffice, few graded nodes
// otherwise, and enough nodes that the motions of nearly touching bodies have the accuracy
// requested.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "scenes.hpp"
#include "support/dense.hpp"
#include "support/smooth_curve.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/system/linear_system.hpp"

using namespace stokesbook;
using Eigen::Index;

namespace {

// An ellipse nearly touches two circles, one on each side, in a linear flow.
class NearlyTouching {
 public:
  NearlyTouching() {
    const Curve ellipse = sample(shapes_[0], 400, Side::fluid_outside);
    const ComplexVector normal = -normals(ellipse);
    const auto beside = [&](Index node, double radius, double gap) {
      return ellipse.x[node] + (radius + gap) * normal[node];
    };
    positions_ = {0.0, beside(37, 1.0, 1e-5), beside(170, 0.7, 1e-3)};
  }

  std::vector<Resolution> chosen(double tolerance) const {
    std::vector<SmoothCurve> curves;
    for (std::size_t k = 0; k < 3; ++k) {
      const Curve even = sample(shapes_[k], 128, Side::fluid_outside);
      curves.push_back(test::smooth_curve(even, positions_[k], turns_[k]));
    }
    std::vector<std::vector<GapRequirement>> demands(3);
    for (std::size_t k : {1u, 2u}) {
      const ClosestPoints closest = closest_points(curves[0], curves[k]);
      const DensityDecay decay = density_decay(curves[0], curves[k], closest);
      demands[0].push_back({closest.parameter_a, decay.a});
      demands[k].push_back({closest.parameter_b, decay.b});
    }
    return {nodes_for_gaps(demands[0], 96, tolerance), nodes_for_gaps(demands[1], 32, tolerance),
            nodes_for_gaps(demands[2], 32, tolerance)};
  }

  std::vector<RigidMotion> motions(const std::vector<Resolution>& nodes) const {
    StokesProblem problem;
    std::vector<PlacedCurve> placed;
    for (std::size_t k = 0; k < 3; ++k) {
      const Curve own = sample(shapes_[k], nodes[k].n_nodes, Side::fluid_outside, nodes[k].grading);
      placed.push_back({std::make_shared<CauchyCurve>(own), positions_[k], turns_[k]});
      Component body;
      body.curve = place(own, positions_[k], turns_[k]);
      body.centre = positions_[k];
      problem.components.push_back(body);
    }
    problem.background = all_nodes(curves_of(problem)).unaryExpr([](Complex x) {
      return x.imag() + Complex{0.3, -0.4} * std::conj(x);
    });
    Plan plan;
    plan.near_tolerance = 1e-13;
    const SuspensionOperator system(problem, placed, plan);
    const ComplexVector rhs = system.right_hand_side();
    // The dense system is solved directly: GMRES would need hundreds of iterations, as many as
    // these gaps have length scales.
    Eigen::MatrixXd matrix(2 * rhs.size(), 2 * rhs.size());
    for (Index column = 0; column < matrix.cols(); ++column) {
      ComplexVector unit = ComplexVector::Zero(rhs.size());
      unit[column / 2] = column % 2 == 0 ? Complex{1.0} : imaginary;
      const ComplexVector velocity = system(unit);
      matrix.col(column) = interleaved(velocity);
    }
    const Eigen::VectorXd density = test::solve(matrix, interleaved(rhs));
    return system.closure().complete(deinterleaved(density)).motions;
  }

 private:
  std::vector<Shape> shapes_{Ellipse{2.0, 1.0}, Circle{1.0}, Circle{0.7}};
  std::vector<Complex> positions_;
  std::vector<double> turns_{0.0, 1.1, -2.0};
};

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

BOOST_AUTO_TEST_CASE(gaps_that_ask_for_little_leave_nodes_equidistant) {
  for (double tolerance : {1e-4, 1e-10}) {
    for (const std::vector<GapRequirement>& gaps :
         {std::vector<GapRequirement>{}, {{0.3, 2.0}}, {{0.3, infinite}, {1.0, 1.5}}}) {
      const Resolution nodes = nodes_for_gaps(gaps, 64, tolerance);
      BOOST_TEST(nodes.n_nodes == 64);
      BOOST_TEST(!nodes.is_graded());
    }
    // If a gap requires only a few more equidistant nodes than the shape, the nodes are not graded,
    // and their number grows.
    const double depth = 1.3 * std::log(1e4 / tolerance) / 64.0;
    const Resolution more = nodes_for_gaps({{0.3, depth}}, 64, tolerance);
    BOOST_TEST(!more.is_graded());
    BOOST_TEST(more.n_nodes == std::max(64, nodes_for_decay(depth, tolerance)));
  }
}

// Graded nodes belong to one configuration: they must save a quarter of the nodes. A wall with many
// bodies beside it would have nearly as many graded nodes as equidistant ones.
BOOST_AUTO_TEST_CASE(nodes_crowd_where_this_saves_a_quarter_of_them) {
  const double tolerance = 1e-3, depth = 0.05;
  const int even = nodes_for_decay(depth, tolerance);
  std::vector<GapRequirement> gaps;
  for (int count = 1; count <= 12; ++count) {
    gaps.push_back({0.5 * count, depth});
    const Resolution nodes = nodes_for_gaps(gaps, 16, tolerance);
    BOOST_TEST(nodes.is_graded() == (nodes.n_nodes < even));
    BOOST_TEST((nodes.n_nodes == even || 1.3 * nodes.n_nodes < even));
  }
  BOOST_TEST(!nodes_for_gaps(gaps, 16, tolerance).is_graded());
}

BOOST_AUTO_TEST_CASE(recommended_counts_are_counts_however_narrow_the_gap) {
  for (double tolerance : {1e-2, 1e-6, 1e-12}) {
    for (double decay = 1.0; decay > 1e-300; decay *= 0.1) {
      const int nodes = nodes_for_decay(decay, tolerance);
      BOOST_TEST(nodes >= 0);
      BOOST_TEST(nodes <= 1'000'000'000);
      BOOST_TEST(nodes % 16 == 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(counts_grow_as_the_logarithm_of_the_depth) {
  int last = 0;
  for (double depth : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const Resolution nodes = nodes_for_gaps({{0.3, depth}}, 32, 1e-8);
    BOOST_TEST(nodes.grading.clusters.size() == 1u);
    BOOST_TEST(nodes.n_nodes % 16 == 0);
    BOOST_TEST(nodes.n_nodes >= last);
    BOOST_TEST(nodes.n_nodes <= (last == 0 ? 128 : last + 32));
    last = nodes.n_nodes;
  }
}

BOOST_AUTO_TEST_CASE(the_count_resolves_every_gap_and_the_shape) {
  const std::vector<GapRequirement> gaps{{0.3, 1e-3}, {2.0, 1e-2}, {4.0, 0.2}, {5.0, infinite}};
  const double tolerance = 1e-9;
  const Resolution nodes = nodes_for_gaps(gaps, 96, tolerance);
  const double needed = std::log(1e5 / tolerance);
  BOOST_REQUIRE(nodes.is_graded());
  for (const auto& [parameter, depth] : gaps) {
    if (std::isinf(depth)) continue;
    BOOST_TEST(nodes.n_nodes * graded_depth(nodes.grading, parameter, depth) >= needed);
  }
  for (int k = 0; k < 16; ++k) {
    const double everywhere = graded_depth(nodes.grading, 0.4 * k, needed / 96.0);
    BOOST_TEST(nodes.n_nodes * everywhere > 0.999 * needed);
  }
}

BOOST_AUTO_TEST_CASE(the_count_resolves_the_shape_between_any_clusters) {
  const double tolerance = 1e-6, needed = std::log(1e5 / tolerance);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> turns(0.0, 1.0), exponent(-3.0, -1.0);
  for (std::size_t count = 1; count <= 20; ++count) {
    std::vector<GapRequirement> gaps(1 + count % 5);
    for (auto& [parameter, depth] : gaps) {
      parameter = 2.0 * std::numbers::pi * turns(random);
      depth = std::pow(10.0, exponent(random));
    }
    const Resolution nodes = nodes_for_gaps(gaps, 48, tolerance);
    BOOST_REQUIRE(nodes.is_graded());
    for (int k = 0; k < 200; ++k) {
      const double depth = graded_depth(nodes.grading, std::numbers::pi * k / 100.0, needed / 48.0);
      BOOST_TEST(nodes.n_nodes * depth > 0.96 * needed);
    }
  }
}

BOOST_AUTO_TEST_CASE(few_nodes_of_a_shape_without_gaps_are_rounded_up) {
  const Resolution nodes = nodes_for_gaps({}, 8, 1e-6);
  BOOST_TEST(nodes.n_nodes == 16);
  BOOST_TEST(!nodes.is_graded());
}

BOOST_AUTO_TEST_CASE(a_narrow_cluster_serves_wide_gaps_beside_it) {
  const GapRequirement narrow{1.0, 1e-4}, beside{1.05, 0.1}, apart{1.2, 0.1}, far{4.0, 1e-3};
  const auto places = [](const std::vector<GapRequirement>& gaps) {
    std::vector<double> parameters;
    for (const Cluster& cluster : nodes_for_gaps(gaps, 32, 1e-8).grading.clusters) {
      parameters.push_back(cluster.parameter);
    }
    return parameters;
  };
  BOOST_TEST(places({beside, narrow}) == std::vector<double>{1.0});
  BOOST_TEST((places({apart, narrow}) == std::vector<double>{1.0, 1.2}));
  BOOST_TEST((places({far, beside, narrow}) == std::vector<double>{1.0, 4.0}));
  // A cluster at the wide gap would not suffice for the narrow gap beside it, so the narrow gap
  // keeps its own cluster.
  BOOST_TEST(places({{1.0, 1e-2}, {1.0 + 5e-3, 1e-5}}) == std::vector<double>{1.0 + 5e-3});
  // Two parameters that differ by 2 pi belong to the same point of the curve.
  BOOST_TEST(places({narrow, {1.0 + 2.0 * std::numbers::pi, 0.1}}) == std::vector<double>{1.0});
}

BOOST_AUTO_TEST_CASE(the_order_of_gaps_does_not_matter) {
  std::vector<GapRequirement> gaps{{0.3, 1e-3}, {2.0, 1e-2}, {2.005, 1e-2}, {4.0, 0.2}};
  const Resolution nodes = nodes_for_gaps(gaps, 48, 1e-8);
  std::reverse(gaps.begin(), gaps.end());
  const Resolution again = nodes_for_gaps(gaps, 48, 1e-8);
  BOOST_TEST(nodes.n_nodes == again.n_nodes);
  BOOST_TEST((nodes.grading == again.grading));
}

BOOST_AUTO_TEST_CASE(demands_that_make_no_sense_are_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : {0.0, -1.0, nan}) {
    BOOST_CHECK_THROW(nodes_for_gaps({{0.0, bad}}, 32, 1e-6), std::invalid_argument);
    BOOST_CHECK_THROW(nodes_for_gaps({{0.0, 0.1}}, 32, bad), std::invalid_argument);
  }
  BOOST_CHECK_THROW(nodes_for_gaps({}, 0, 1e-6), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(motions_of_bodies_that_nearly_touch_have_the_digits_asked_for) {
  const NearlyTouching bodies;
  std::vector<Resolution> reference = bodies.chosen(1e-9);
  for (Resolution& nodes : reference) nodes.n_nodes += nodes.n_nodes / 2;
  const std::vector<RigidMotion> exact = bodies.motions(reference);
  for (double tolerance : {1e-3, 1e-5, 1e-7}) {
    std::vector<Resolution> nodes = bodies.chosen(tolerance);
    for (const Resolution& chosen : nodes) {
      BOOST_TEST(chosen.is_graded());
    }
    BOOST_TEST(test::largest_difference(bodies.motions(nodes), exact) < tolerance);
    for (Resolution& chosen : nodes) chosen.grading = {};
    BOOST_TEST(test::largest_difference(bodies.motions(nodes), exact) > tolerance);
  }
}
