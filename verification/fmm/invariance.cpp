// Tests that the sums are the same for any number of threads, and for several densities at once.
#include <algorithm>

#include <omp.h>

#include "experiments.hpp"
#include "set_ups.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::fmm {

using namespace study;
using Eigen::Index;

namespace {

const FmmSettings nine_digits = FmmSettings::for_tolerance(1e-9);

ComplexVector by_threads(int threads) {
  omp_set_num_threads(threads);
  ComplexVector velocity =
      Fmm(summed_ellipses().curves, {}, nine_digits).velocity(summed_ellipses().density);
  omp_set_num_threads(1);
  return velocity;
}

/// A planted defect: each thread evaluates the sum of its own sources, and the sums are added.
ComplexVector by_shares(int threads) {
  const Summed& sum = summed_ellipses();
  const Fmm plan(sum.curves, {}, nine_digits);
  const Index n = sum.density.size();
  ComplexVector velocity = ComplexVector::Zero(n);
  for (Index thread = 0; thread < threads; ++thread) {
    const Index first = thread * n / threads, last = (thread + 1) * n / threads;
    ComplexVector share = ComplexVector::Zero(n);
    share.segment(first, last - first) = sum.density.segment(first, last - first);
    velocity += plan.velocity(share);
  }
  return velocity;
}

Measure over_threads(ComplexVector (*velocity)(int)) {
  return [=](Size) {
    const ComplexVector alone = velocity(1);
    std::vector<Measurement> measurements;
    for (const int threads : {1, 2, 3, 4}) {
      measurements.push_back({.x = static_cast<double>(threads),
                              .error = test::relative_error(velocity(threads), alone)});
    }
    return measurements;
  };
}

/// Names the order in which the entries of several densities are read.
enum class Reading {
  by_fields,
  by_nodes  ///< a planted defect: entries stored node by node are read field by field
};

Eigen::MatrixXcd read(const Eigen::MatrixXcd& density, Reading reading) {
  if (reading == Reading::by_fields) return density;
  const Eigen::MatrixXcd by_nodes = density.transpose();
  return Eigen::Map<const Eigen::MatrixXcd>(by_nodes.data(), density.rows(), density.cols());
}

/// Measures the largest difference between fields that are summed together and alone.
Measure over_fields(Reading reading) {
  return [=](Size) {
    const Summed& sum = summed_ellipses();
    const Fmm plan(sum.curves, {}, nine_digits);
    std::vector<Measurement> measurements;
    for (const Index fields : {2, 3, 4, 7}) {
      Eigen::MatrixXcd density(sum.density.size(), fields);
      for (Index k = 0; k < fields; ++k) {
        density.col(k) = test::random_vector(density.rows(), static_cast<unsigned>(10 + k));
      }
      const Eigen::MatrixXcd together = plan.velocity(read(density, reading));
      double error = 0.0;
      for (Index k = 0; k < fields; ++k) {
        const ComplexVector alone = plan.velocity(density.col(k));
        error = std::max(error, test::relative_error(together.col(k), alone));
      }
      measurements.push_back({.x = static_cast<double>(fields), .error = error});
    }
    return measurements;
  };
}

}  // namespace

Experiment threads() {
  return {.key = "threads",
          .title = "Velocities by several threads",
          .x = "threads t",
          .error = "difference from one thread in the 2-norm, relative",
          .lines = {
              {.key = "velocity",
               .label = "nodes on ellipses",
               .measure = over_threads(by_threads),
               .claim = Claim{.id = "08_32",
                              .statement = "The number of threads does not change a bit.",
                              .law = Identity{0.0},
                              .reason = "every sum is made by one thread, in an order that "
                                        "the plan has set",
                              .api = {"stokesbook::Fmm", "stokesbook::Quadtree"}},
               .control = Control{"a thread for a part of the sources", over_threads(by_shares)}}}};
}

Experiment fields() {
  return {.key = "fields",
          .title = "Several densities at once",
          .x = "densities k",
          .error = "largest difference from one after the other in the 2-norm, relative",
          .lines = {{.key = "velocity",
                     .label = "nodes on ellipses",
                     .measure = over_fields(Reading::by_fields),
                     .claim = Claim{.id = "08_33",
                                    .statement = "Densities that are summed at once have the "
                                                 "velocities that they have alone.",
                                    .law = Identity{1e-14},
                                    .reason = "the same sums, but for the order in which "
                                              "compilers add",
                                    .api = {"stokesbook::Fmm", "stokesbook::FmmStrengths"}},
                     .control = Control{"densities stored node by node, read one after the other",
                                        over_fields(Reading::by_nodes)}}}};
}

}  // namespace stokesbook::verification::fmm
