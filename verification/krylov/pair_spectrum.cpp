// The spectrum of two circles in closed form: how far the eigenvalues cluster, and why near
// contacts are hard.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "experiments.hpp"
#include "record/number_text.hpp"
#include "support/spectra.hpp"
#include "systems.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int largest_mode = 5;

/// The parameter of bipolar coordinates whose circles are two unit circles.
double bipolar(double gap) {
  return std::acosh(1.0 + 0.5 * gap);
}

/// Distances from 1 of the preconditioned eigenvalues of mode k >= 2, the larger first: e^{-y} with
/// sinh(2 k alpha - y) = +-k sinh(2 alpha).
std::array<double, 2> distances_from_one(double alpha, int k) {
  const double turn = std::asinh(k * std::sinh(2.0 * alpha));
  return {std::exp(-2.0 * alpha * k + turn), std::exp(-2.0 * alpha * k - turn)};
}

/// Nodes that hold the eigenvectors of many modes.
Index nodes_for_modes(double gap) {
  return 2 * static_cast<Index>(std::ceil(12.0 + 40.0 / bipolar(gap)));
}

/// Moduli of the eigenvalues of A M^{-1} - 1, largest first, with the block of that shape in M.
///
/// The pair is its own image under the half turn, which takes node j of one circle to node
/// j + N / 2 of the other and vectors to their negative. Densities that go into plus or minus
/// themselves are known from one circle, so that half the unknowns do, and every modulus counts
/// twice.
std::vector<double> computed_distances(double gap, const Shape& block) {
  const Index nodes = nodes_for_modes(gap), size = 2 * nodes;
  const BodySystem system(circle_pair(gap), nodes, shear);
  const MatrixXd inverse = invert_block(self_block(alone(block, nodes)));
  MatrixXd preconditioned(size, size);
  for (Index column = 0; column < size; ++column) {
    VectorXd density(2 * size);
    const auto own = inverse.col(column);
    density << own, -own.tail(nodes), -own.head(nodes);
    preconditioned.col(column) = system.apply(density).head(size);
  }
  preconditioned.diagonal().array() -= 1.0;
  std::vector<double> distances;
  for (const Complex value : test::eigenvalues(preconditioned)) {
    distances.insert(distances.end(), 2, std::abs(value));
  }
  std::ranges::sort(distances, std::greater{});
  return distances;
}

/// Largest distance of a known value from the nearest computed one.
double spectrum_error(double gap, const Shape& block) {
  const std::vector<double> computed = computed_distances(gap, block);
  double error = 0.0;
  for (int k = 2; k <= largest_mode; ++k) {
    for (const double known : distances_from_one(bipolar(gap), k)) {
      double nearest = 1.0;
      for (const double value : computed) nearest = std::min(nearest, std::abs(value - known));
      error = std::max(error, nearest);
    }
  }
  return error;
}

Measure spectrum_errors(const Shape& block) {
  return [=](Size size) {
    std::vector<double> gaps{0.2, 0.3, 0.5, 1.0, 2.0};
    if (size == Size::full) gaps.insert(gaps.begin(), {0.05, 0.1});
    std::vector<Measurement> measurements;
    for (const double gap : gaps) {
      measurements.push_back({.x = gap,
                              .error = spectrum_error(gap, block),
                              .unknowns = 4.0 * static_cast<double>(nodes_for_modes(gap))});
    }
    return measurements;
  };
}

/// One of each four equal eigenvalues.
Measure clustering(double gap, const Shape& block) {
  return [=](Size) {
    const std::vector<double> distances = computed_distances(gap, block);
    std::vector<Measurement> measurements;
    for (std::size_t rank = 4; rank <= distances.size(); rank += 4) {
      const double distance = distances[rank - 1];
      if (distance < 1e-13) break;
      measurements.push_back({.x = static_cast<double>(rank), .error = distance});
    }
    return measurements;
  };
}

Line cluster_line(const std::string& key, const std::string& id, double gap) {
  const double alpha = bipolar(gap);
  return {.key = key,
          .label = "gap " + short_number(gap),
          .measure = clustering(gap, Circle{}),
          .claim = Claim{.id = id,
                         .statement = "The eigenvalues of two circles cluster at 1: the j-th is "
                                      "about e^{-a j / 4} away, cosh a = 1 + g / 2.",
                         .law = Geometric{0.25 * alpha, 0.05},
                         .window = {.from = 12.0 / alpha, .floor = 1e-11},
                         .reason = "eight eigenvalues a mode, whose distances fall by e^{-2 a} "
                                   "from mode to mode; 0.05: the stairs of four equal ones",
                         .api = {"stokesbook::BlockDiagonalPreconditioner"}},
          .control = Control{"the blocks of another shape, an ellipse 2:1",
                             clustering(gap, Ellipse{1.0, 0.5})}};
}

}  // namespace

Experiment pair_spectrum() {
  return {.key = "pair",
          .title = "Spectrum of two circles against its closed form",
          .x = "gap, in radii, g",
          .error = "largest error of the eigenvalues of the modes 2 to 5",
          .lines = {{.key = "eigenvalues",
                     .label = "preconditioned operator",
                     .measure = spectrum_errors(Circle{}),
                     .claim = Claim{.id = "05_8",
                                    .statement = "Preconditioned by their own blocks, two equal "
                                                 "circles have the eigenvalues 1 +- exp(-2 k a "
                                                 "+- asinh(k sinh 2a)), cosh a = 1 + g / 2.",
                                    .law = Identity{1e-12},
                                    .reason = "bipolar coordinates separate the problem, see the "
                                              "chapter; 1e-12: eigenvalues of a matrix "
                                              "that is not normal",
                                    .api = {"stokesbook::BlockDiagonalPreconditioner"}},
                     .control = Control{"the blocks of another shape, an ellipse 2:1",
                                        spectrum_errors(Ellipse{1.0, 0.5})}}}};
}

Experiment clusters() {
  return {.key = "clusters",
          .title = "Eigenvalues of two circles cluster at 1",
          .x = "rank j",
          .error = "distance of the eigenvalue from 1",
          .axes = Axes::semi_log,
          .lines = {cluster_line("far", "05_9", 2.0), cluster_line("half", "05_10", 0.5),
                    cluster_line("near", "05_11", 0.2)}};
}

}  // namespace stokesbook::verification::krylov
