// Counts the kernel evaluations of the direct sum, which takes all pairs of nodes.
#include "double_layer/double_layer.hpp"
#include "experiments.hpp"

namespace stokesbook::verification::double_layer {

using namespace study;
using Eigen::Index;

namespace {

constexpr Index nodes_per_body = 16;

std::vector<Curve> row_of_bodies(Index count) {
  const Curve body = sample(Ellipse{0.5, 0.3}, nodes_per_body, Side::fluid_outside);
  std::vector<Curve> bodies;
  for (Index k = 0; k < count; ++k) {
    bodies.push_back(place(body, {1.5 * static_cast<double>(k), 0.0}, static_cast<double>(k)));
  }
  return bodies;
}

/// Counts the kernel evaluations of an assembled sum: the blocks of 2 x 2 entries that are not
/// zero.
Index evaluations(const Eigen::MatrixXd& matrix) {
  Index count = 0;
  for (Index j = 0; j < matrix.cols(); j += 2) {
    for (Index i = 0; i < matrix.rows(); i += 2) {
      if (!matrix.block<2, 2>(i, j).isZero(0.0)) ++count;
    }
  }
  return count;
}

Index all_pairs(const std::vector<Curve>& bodies) {
  return evaluations(double_layer_matrix(bodies));
}

/// A planted defect: only pairs of nodes on one body are counted.
Index own_pairs(const std::vector<Curve>& bodies) {
  Index count = 0;
  for (const Curve& body : bodies) count += evaluations(double_layer_matrix(body));
  return count;
}

Measure counted(Index (*count)(const std::vector<Curve>&)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (Index bodies = 1; bodies <= (size == Size::full ? 64 : 16); bodies *= 2) {
      const auto operations = static_cast<double>(count(row_of_bodies(bodies)));
      measurements.push_back({.x = static_cast<double>(bodies * nodes_per_body),
                              .error = operations,
                              .operations = operations});
    }
    return measurements;
  };
}

}  // namespace

Experiment cost() {
  return {.key = "cost",
          .title = "Kernel evaluations of the direct sum",
          .x = "nodes of all bodies n",
          .error = "kernel evaluations",
          .lines = {{.key = "all",
                     .label = "all pairs",
                     .measure = counted(all_pairs),
                     .claim = Claim{.id = "02_27",
                                    .statement = "The double layer of all nodes at all nodes "
                                                 "takes n^2 kernel evaluations.",
                                    .law = Cost{2.0, 0.01},
                                    .reason = "a kernel for each pair; none is zero",
                                    .api = {"stokesbook::StressletSum",
                                            "stokesbook::double_layer_matrix"}},
                     .control = Control{"each body on itself only", counted(own_pairs)}}},
          .operation = "kernel evaluations"};
}

}  // namespace stokesbook::verification::double_layer
