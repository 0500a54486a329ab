// Checks that the trapezoid sum plus the near correction (06.17) is the sum of the Cauchy values of
// all curves: at gaps from 1e-1 to 1e-8, for turned and shifted bodies and an enclosing wall. The
// results have the same bits for any number of threads.
#include "near_singular/near_correction.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "double_layer/double_layer.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::largest;

namespace {

constexpr double to_rounding = 1e-14;

std::shared_ptr<const CauchyCurve> reference(const Shape& shape, Index n, Side side) {
  return std::make_shared<CauchyCurve>(sample(shape, n, side));
}

// Holds curves with a smooth density on each, and all nodes in order.
struct Assembly {
  explicit Assembly(std::vector<PlacedCurve> placed_curves) : placed(std::move(placed_curves)) {
    for (const PlacedCurve& p : placed) {
      curves.push_back(place(p.curve(), p.position, p.orientation));
      offsets.push_back(offsets.back() + curves.back().size());
    }
    nodes = all_nodes(curves);
    density.resize(offsets.back());
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const Index n = curves[k].size();
      for (Index j = 0; j < n; ++j) {
        const double t = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
        density[offsets[k] + j] = {std::cos(t) + 0.2 * static_cast<double>(k),
                                   std::sin(2.0 * t + 1.0)};
      }
    }
  }

  // Returns the velocity of one curve by the Cauchy scheme, in the plane's frame.
  ComplexVector cauchy_velocity(std::size_t k, const ComplexVector& targets) const {
    const Complex turn = std::polar(1.0, placed[k].orientation);
    const CauchyCurve& cauchy = *std::get<std::shared_ptr<const CauchyCurve>>(placed[k].scheme);
    const CauchyData data =
        cauchy.data(std::conj(turn) * density.segment(offsets[k], curves[k].size()));
    const ComplexVector local = std::conj(turn) * (targets.array() - placed[k].position).matrix();
    return turn * cauchy.velocity(data, 0, local);
  }

  // Returns the principal values plus all other curves' velocities at the nodes, by Cauchy
  // integrals alone.
  ComplexVector exact_at_nodes() const {
    ComplexVector velocity = 0.5 * density;
    for (std::size_t k = 0; k < curves.size(); ++k) velocity += cauchy_velocity(k, nodes);
    return velocity;
  }

  ComplexVector corrected_at_nodes() const {
    const NearCorrection near(placed, nodes, Targets::own_nodes, {to_rounding});
    ComplexVector velocity = StressletSum(curves)(density) + near(density);
    for (std::size_t k = 0; k < curves.size(); ++k) {
      const Index n = curves[k].size();
      velocity.segment(offsets[k], n) +=
          diagonal_velocity(curves[k], density.segment(offsets[k], n));
    }
    return velocity;
  }

  std::vector<PlacedCurve> placed;
  std::vector<Curve> curves;
  std::vector<Index> offsets{0};
  ComplexVector nodes, density;
};

// Two circles of different size lie along a direction, turned so that nodes face each other or not.
Assembly pair(double gap, double direction, double turn) {
  const Complex centre{0.4, -0.7};
  return Assembly({{reference(Circle{1.0}, 96, Side::fluid_outside), centre, direction},
                   {reference(Circle{0.5}, 64, Side::fluid_outside),
                    centre + std::polar(1.5 + gap, direction), turn}});
}

// Counts the targets that a correction changes.
Index corrected_count(const ComplexVector& correction) {
  return (correction.array() != Complex{}).count();
}

}  // namespace

BOOST_AUTO_TEST_CASE(two_bodies_at_any_gap) {
  for (double gap : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8}) {
    for (double direction : {0.0, 0.8}) {
      for (double turn : {direction, 2.0}) {
        const Assembly bodies = pair(gap, direction, turn);
        BOOST_TEST(largest(bodies.corrected_at_nodes() - bodies.exact_at_nodes()) < 1e-13);
      }
    }
  }
  // Without the correction the error of the sum is far larger.
  const Assembly bodies = pair(1e-2, 0.0, 0.0);
  const NearCorrection near(bodies.placed, bodies.nodes, Targets::own_nodes, {to_rounding});
  BOOST_TEST(largest(near(bodies.density)) > 0.1);
}

BOOST_AUTO_TEST_CASE(bodies_that_share_a_shape_in_a_container) {
  // The wall bulges inward to 1e-6 of a body; two ellipses of one reference nearly touch.
  const auto ellipse = reference(Ellipse{0.5, 0.25}, 96, Side::fluid_outside);
  const Assembly scene(
      {{ellipse, {0.0, 0.0}, 0.3},
       {ellipse, (0.5 + 1e-6 + 0.5) * std::polar(1.0, 0.3), 0.3 + std::numbers::pi},
       {reference(Star{0.3, 0.2, 3}, 96, Side::fluid_outside), {-0.8, 0.4}, 1.0},
       {reference(Star{2.0, 0.25, 2}, 256, Side::fluid_inside), {0.0, 1.5 - 0.25 - 1e-6}, 0.0}});
  BOOST_TEST(largest(scene.corrected_at_nodes() - scene.exact_at_nodes()) < 1e-12);
}

BOOST_AUTO_TEST_CASE(points_of_the_fluid) {
  // The targets lie between two bodies 1e-4 apart, on a node of a body, and far from both bodies.
  const Assembly bodies = pair(1e-4, 0.3, 1.0);
  const Complex first = bodies.placed[0].position;
  const ComplexVector targets =
      ComplexVector{{first + std::polar(1.0 + 5e-5, 0.3), first + std::polar(1.0, 0.3),
                     bodies.nodes[100], first + Complex{0.0, 9.0}}};
  const NearCorrection near(bodies.placed, targets, Targets::points, {to_rounding});
  const ComplexVector exact =
      bodies.cauchy_velocity(0, targets) + bodies.cauchy_velocity(1, targets);
  const ComplexVector sum = StressletSum(bodies.curves)(targets, bodies.density);
  BOOST_TEST(largest(sum + near(bodies.density) - exact) < 1e-13);
  BOOST_TEST(near(bodies.density)[3] == 0.0);
}

// Stored rows give the same correction. The automatic choice stores rows for few targets only.
BOOST_AUTO_TEST_CASE(explicit_rows) {
  for (double gap : {1e-1, 1e-4, 1e-8}) {
    const Assembly bodies = pair(gap, 0.3, 1.0);
    const auto planned = [&](NearStorage storage) {
      return NearCorrection(bodies.placed, bodies.nodes, Targets::own_nodes,
                            {to_rounding, storage});
    };
    const NearCorrection factored = planned(NearStorage::factored),
                         rows = planned(NearStorage::explicit_rows);
    BOOST_TEST(factored.explicit_count() == 0);
    BOOST_TEST(rows.explicit_count() == 2);
    BOOST_TEST(rows.pair_count() == factored.pair_count());
    BOOST_TEST(largest(rows(bodies.density) - factored(bodies.density)) < 1e-12);
  }
  const auto circle = reference(Circle{1.0}, 256, Side::fluid_outside);
  const Assembly two({{circle, {0.0, 0.0}, 0.0}, {circle, {2.03, 0.0}, 1.0}});
  const NearCorrection few(two.placed, two.nodes, Targets::own_nodes, {1e-2}),
      many(two.placed, two.nodes, Targets::own_nodes, {1e-14});
  BOOST_TEST(few.pair_count() > 0);
  BOOST_TEST(few.explicit_count() == 2);
  BOOST_TEST(many.pair_count() > few.pair_count());
  BOOST_TEST(many.explicit_count() == 0);
}

BOOST_AUTO_TEST_CASE(only_near_targets_are_corrected) {
  const auto circle = reference(Circle{1.0}, 64, Side::fluid_outside);
  const Assembly far({{circle, {0.0, 0.0}, 0.0}, {circle, {9.0, 0.0}, 0.0}});
  const NearCorrection nothing(far.placed, far.nodes, Targets::own_nodes, {to_rounding});
  BOOST_TEST(corrected_count(nothing(far.density)) == 0);

  const Assembly three(
      {{circle, {0.0, 0.0}, 0.0}, {circle, {9.0, 0.0}, 0.0}, {circle, {0.0, 2.1}, 0.0}});
  const NearCorrection one_pair(three.placed, three.nodes, Targets::own_nodes, {1e-6});
  const ComplexVector correction = one_pair(three.density);
  BOOST_TEST(corrected_count(correction.segment(64, 64)) == 0);
  for (Index first : {0, 128}) {
    BOOST_TEST(corrected_count(correction.segment(first, 64)) > 2);
    BOOST_TEST(corrected_count(correction.segment(first, 64)) < 32);
  }
}

// Images of curves correct the nodes like further curves with the same densities, also the nodes of
// their own curve: the first image of the circle nearly touches the circle itself.
BOOST_AUTO_TEST_CASE(images_of_curves) {
  const std::vector<Complex> images = {{2.02, 0.0}, {-0.4, -2.6}};
  const std::vector<PlacedCurve> placed = {
      {reference(Circle{1.0}, 96, Side::fluid_outside), {0.1, 0.0}, 0.3},
      {reference(Ellipse{0.4, 0.2}, 64, Side::fluid_outside), {0.2, 1.3}, 0.1}};
  const Assembly bodies(placed);
  std::vector<PlacedCurve> copies = placed;
  ComplexVector densities(3 * bodies.nodes.size());
  densities << bodies.density, bodies.density, bodies.density;
  for (const Complex w : images) {
    for (PlacedCurve copy : placed) {
      copy.position += w;
      copies.push_back(copy);
    }
  }
  const Assembly all(copies);
  for (const NearStorage storage : {NearStorage::factored, NearStorage::explicit_rows}) {
    const NearSettings settings{to_rounding, storage};
    const NearCorrection near(placed, bodies.nodes, Targets::own_nodes, settings, images);
    const ComplexVector exact =
        NearCorrection(copies, all.nodes, Targets::own_nodes, settings)(densities).head(160);
    BOOST_TEST(largest(near(bodies.density) - exact) < 1e-13);
    BOOST_TEST(
        largest(near(bodies.density) - NearCorrection(placed, bodies.nodes, Targets::own_nodes,
                                                      settings)(bodies.density)) > 0.1);
  }
  const ComplexVector targets{{Complex{1.105, 0.0}, Complex{0.0, 1.06}, Complex{0.1, -1.02}}};
  const auto found =
      near_derivative_corrections(placed, bodies.density, targets, to_rounding, images);
  const auto exact = near_derivative_corrections(copies, densities, targets, to_rounding);
  for (std::size_t i = 0; i < 3; ++i) {
    const double scale = 1.0 + std::abs(exact[i].strain);
    BOOST_TEST(std::abs(found[i].pressure - exact[i].pressure) < 1e-12 * scale);
    BOOST_TEST(std::abs(found[i].strain - exact[i].strain) < 1e-12 * scale);
  }
}

BOOST_AUTO_TEST_CASE(a_loose_tolerance_corrects_fewer_and_is_met) {
  const Assembly bodies = pair(0.05, 0.3, 1.0);
  const ComplexVector exact =
      StressletSum(bodies.curves)(bodies.density) +
      NearCorrection(bodies.placed, bodies.nodes, Targets::own_nodes, {1e-14})(bodies.density);
  Index previous = bodies.nodes.size();
  for (double loose : {1e-12, 1e-9, 1e-6, 1e-3}) {
    const NearCorrection near(bodies.placed, bodies.nodes, Targets::own_nodes, {loose});
    const ComplexVector velocity =
        StressletSum(bodies.curves)(bodies.density) + near(bodies.density);
    BOOST_TEST(largest(velocity - exact) < loose * largest(bodies.density));
    BOOST_TEST(corrected_count(near(bodies.density)) < previous);
    previous = corrected_count(near(bodies.density));
  }
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const auto ellipse = reference(Ellipse{0.5, 0.25}, 64, Side::fluid_outside);
  std::vector<PlacedCurve> row;
  for (int k = 0; k < 7; ++k)
    row.push_back({ellipse, {0.55 * k, 0.0}, 0.5 * std::numbers::pi + 0.01 * k});
  const Assembly bodies(row);
  const int threads_before = omp_get_max_threads();
  const auto correction = [&](int threads) -> ComplexVector {
    omp_set_num_threads(threads);
    return NearCorrection(bodies.placed, bodies.nodes, Targets::own_nodes,
                          {to_rounding})(bodies.density);
  };
  const ComplexVector alone = correction(1);
  BOOST_TEST(largest(alone) > 0.01);
  BOOST_TEST((correction(2) == alone));
  BOOST_TEST((correction(3) == alone));
  omp_set_num_threads(threads_before);
}
