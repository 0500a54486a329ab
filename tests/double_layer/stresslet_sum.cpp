// Checks that the direct sum (08.1), streamed or stored, is the sum of its kernels to rounding, for
// every number of targets and sources, with nodes that nearly touch, and at any scale. The results
// have the same bits for any number of threads.
#include "double_layer/stresslet_sum.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "double_layer/double_layer.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;

namespace {

using Extended = std::complex<long double>;

// Holds the sum, computed by its definition in extended precision, and the sum of the terms'
// moduli. Rounding errors are relative to the sum of the moduli.
struct ReferenceSum {
  Complex velocity;
  double terms = 0.0;
};

ReferenceSum reference_sum(const std::vector<Curve>& curves, Complex target,
                           const ComplexVector& density) {
  Extended velocity{};
  long double terms = 0.0L;
  Index first = 0;
  for (const Curve& curve : curves) {
    const ComplexVector normal = normals(curve);
    const Eigen::VectorXd w = weights(curve);
    for (Index j = 0; j < curve.size(); ++j) {
      const Extended r = Extended{target} - Extended{curve.x[j]};
      const long double rho2 = std::max<long double>(std::norm(r), 0.25L * w[j] * w[j]);
      const Extended eta{density[first + j]}, n{normal[j]};
      const Extended term = (std::conj(r) * n).real() * (std::conj(r) * eta).real() * w[j] /
                            (std::numbers::pi_v<long double> * rho2 * rho2) * r;
      velocity += term;
      terms += std::abs(term);
    }
    first += curve.size();
  }
  return {Complex{velocity}, static_cast<double>(terms)};
}

// Returns the largest error over the targets, relative to the moduli of the terms.
double error_of(const ComplexVector& velocity, const std::vector<Curve>& curves,
                const ComplexVector& targets, const ComplexVector& density) {
  double error = 0.0;
  for (Index i = 0; i < targets.size(); ++i) {
    const ReferenceSum exact = reference_sum(curves, targets[i], density);
    const double smallest = std::numeric_limits<double>::min();
    error = std::max(error, std::abs(velocity[i] - exact.velocity) / (exact.terms + smallest));
  }
  return error;
}

std::vector<Curve> scene(double scale) {
  return {
      place(sample(Ellipse{2.0 * scale, scale}, 46, Side::fluid_outside), scale * Complex{2.5, 0.3},
            0.7),
      place(sample(Star{scale, 0.2, 5}, 90, Side::fluid_outside), scale * Complex{-1.5, 0.2}, -0.3),
      sample(Circle{6.0 * scale}, 64, Side::fluid_inside)};
}

// A term has a dozen operations; the rounding errors of the terms add like a random walk.
constexpr double rounding = 3e-15;

}  // namespace

BOOST_AUTO_TEST_CASE(streamed_and_stored_are_the_sum_of_the_kernels) {
  for (double scale : {1e-3, 1.0, 1e3}) {
    const std::vector<Curve> curves = scene(scale);
    const ComplexVector density = random_vector(200, 1), nodes = all_nodes(curves);
    for (KernelStorage storage : {KernelStorage::streamed, KernelStorage::stored}) {
      const StressletSum sum(curves, storage);
      BOOST_TEST(sum.size() == 200);
      BOOST_TEST(error_of(sum(density), curves, nodes, density) < rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(any_number_of_targets_and_sources) {
  // The numbers are close to the sizes of the pairs, vectors, chunks and blocks that the loops
  // process.
  for (Index n : {4, 6, 18, 510, 512, 514, 1030}) {
    const std::vector<Curve> curves = {sample(Ellipse{1.0, 0.6}, n, Side::fluid_outside)};
    const StressletSum sum(curves);
    const ComplexVector density = random_vector(n, 2);
    for (Index m : {0, 1, 2, 3, 63, 64, 65, 127, 129}) {
      const ComplexVector targets = 3.0 * random_vector(m, 3);
      const ComplexVector velocity = sum(targets, density);
      BOOST_REQUIRE(velocity.size() == m);
      BOOST_TEST(error_of(velocity, curves, targets, density) < rounding);
    }
  }
}

BOOST_AUTO_TEST_CASE(pairs_count_as_half_a_weight_apart_at_least) {
  // The nodes of neighbouring circles face each other. The gaps are above half a weight, below half
  // a weight, and zero.
  for (Index n : {32, 34}) {
    const Curve left = sample(Circle{1.0}, n, Side::fluid_outside);
    const double half_weight = 0.5 * weights(left)[0];
    for (double gap : {1.001 * half_weight, 0.999 * half_weight, 1e-8, 0.0}) {
      const std::vector<Curve> curves = {left, place(left, {2.0 + gap, 0.0}, 0.0),
                                         place(left, {-2.0 - gap, 0.0}, 0.0)};
      const ComplexVector density = random_vector(3 * n, 4), nodes = all_nodes(curves);
      for (KernelStorage storage : {KernelStorage::streamed, KernelStorage::stored}) {
        const ComplexVector velocity = StressletSum(curves, storage)(density);
        BOOST_TEST(error_of(velocity, curves, nodes, density) < rounding);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(two_targets_that_share_a_division_do_not_disturb_each_other) {
  // The first target lies on a node; the other target lies on a node as well, or is far away.
  const std::vector<Curve> curves = {sample(Circle{1e-3}, 16, Side::fluid_outside)};
  const StressletSum sum(curves);
  const ComplexVector density = random_vector(16, 5);
  for (Complex other : {curves[0].x[3], curves[0].x[4], Complex{1e6, 1e6}, Complex{2e-3, 0.0}}) {
    const ComplexVector targets = ComplexVector{{curves[0].x[3], other}};
    BOOST_TEST(error_of(sum(targets, density), curves, targets, density) < rounding);
  }
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const std::vector<Curve> curves = scene(1.0);
  const ComplexVector density = random_vector(200, 6), targets = 5.0 * random_vector(517, 7);
  const int threads_before = omp_get_max_threads();
  for (KernelStorage storage : {KernelStorage::streamed, KernelStorage::stored}) {
    omp_set_num_threads(1);
    const StressletSum sum(curves, storage);
    const ComplexVector at_nodes = sum(density), elsewhere = sum(targets, density);
    for (int threads : {2, 3}) {
      omp_set_num_threads(threads);
      const StressletSum again(curves, storage);
      BOOST_TEST((again(density) == at_nodes));
      BOOST_TEST((again(targets, density) == elsewhere));
    }
  }
  omp_set_num_threads(threads_before);
}

// Two targets lie off the nodes. One target lies on a node: the kernel bounds the distance from
// below.
BOOST_AUTO_TEST_CASE(matrix_is_the_same_map) {
  const std::vector<Curve> curves = scene(1.0);
  const StressletSum sum(curves);
  const ComplexVector density = random_vector(200, 3);
  const ComplexVector targets =
      ComplexVector{{Complex{0.3, 3.0}, Complex{-4.0, 1.0}, curves[0].x[3]}};
  const Eigen::VectorXd product = sum.matrix(targets) * interleaved(density);
  BOOST_TEST(error_of(deinterleaved(product), curves, targets, density) < rounding);
}

BOOST_AUTO_TEST_CASE(derivatives_are_the_sum_of_the_kernels) {
  for (double scale : {1e-3, 1.0, 1e3}) {
    const std::vector<Curve> curves = scene(scale);
    const ComplexVector density = random_vector(200, 3);
    const ComplexVector targets =
        scale * ComplexVector{{Complex{0.3, 3.0}, Complex{-4.0, 1.0}, Complex{0.1, 0.4}}};
    const std::vector<FlowDerivatives> found = StressletSum(curves).derivatives(targets, density);
    for (std::size_t i = 0; i < found.size(); ++i) {
      FlowDerivatives exact;
      double terms = 0.0;
      Index first = 0;
      for (const Curve& curve : curves) {
        const ComplexVector normal = normals(curve);
        const Eigen::VectorXd w = weights(curve);
        for (Index j = 0; j < curve.size(); ++j) {
          const Complex r = targets[static_cast<Index>(i)] - curve.x[j];
          exact += stresslet_derivatives(r, normal[j], w[j] * density[first + j]);
          terms += w[j] * std::abs(density[first + j]) / std::norm(r);
        }
        first += curve.size();
      }
      BOOST_TEST(std::abs(found[i].pressure - exact.pressure) < rounding * terms);
      BOOST_TEST(std::abs(found[i].vorticity - exact.vorticity) < rounding * terms);
      BOOST_TEST(std::abs(found[i].strain - exact.strain) < rounding * terms);
    }
  }
}

BOOST_AUTO_TEST_CASE(matrices_are_stored_for_few_nodes_only) {
  BOOST_TEST((StressletSum::automatic_storage(32) == KernelStorage::stored));
  BOOST_TEST((StressletSum::automatic_storage(4096) == KernelStorage::streamed));
}
