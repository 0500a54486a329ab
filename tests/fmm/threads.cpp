// Checks that results have the same bits for any number of threads, in planning and in application,
// and from several threads that share a plan.
#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const std::vector<Curve> curves = test::ellipses(8, 64);
  const ComplexVector points = random_vector(400, 1), force = random_vector(400, 2);
  const Eigen::VectorXd torque = random_vector(400, 3).real();
  const ComplexVector density = random_vector(64 * 64, 4);
  const int threads_before = omp_get_max_threads();
  const auto velocity = [&](int threads) {
    omp_set_num_threads(threads);
    return Fmm(curves, points, {12, 20}).velocity({density, force, torque});
  };
  const auto vorticity = [&](int threads) {
    omp_set_num_threads(threads);
    double sum = 0.0;
    for (const FlowDerivatives& flow :
         Fmm(curves, points, {12, 20}).derivatives({density, force, torque})) {
      sum += flow.vorticity;
    }
    return sum;
  };
  const Eigen::MatrixXcd alone = velocity(1);
  const double alone_vorticity = vorticity(1);
  for (const int threads : {2, 3}) {
    BOOST_TEST((velocity(threads) == alone));
    BOOST_TEST(vorticity(threads) == alone_vorticity);
  }
  omp_set_num_threads(threads_before);
}

BOOST_AUTO_TEST_CASE(two_threads_use_one_plan) {
  const Fmm fmm(test::ellipses(6, 64), {}, {12, 20});
  Eigen::MatrixXcd density(36 * 64, 2), together(36 * 64, 2);
  density << random_vector(36 * 64, 1), random_vector(36 * 64, 2);
#pragma omp parallel for num_threads(2)
  for (Index field = 0; field < 2; ++field) {
    FmmWorkspace work = fmm.workspace();
    for (int k = 0; k < 5; ++k) together.col(field) = fmm.velocity(density.col(field), work);
  }
  for (Index field = 0; field < 2; ++field) {
    BOOST_TEST((fmm.velocity(density.col(field)) == together.col(field)));
  }
}
