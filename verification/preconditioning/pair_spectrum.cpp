// Compares the spectrum of two circles with its closed form (13.2), and shows how the clustering
// of the eigenvalues depends on the gap.
#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments.hpp"
#include "support/body_systems.hpp"
#include "support/spectra.hpp"
#include "text/number_text.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

/// Returns the parameter alpha of the bipolar coordinates of two unit circles, from
/// cosh(alpha) = 1 + gap / 2.
double bipolar(double gap) {
  return std::acosh(1.0 + 0.5 * gap);
}

/// Returns a number of nodes that resolves the eigenvectors of many modes.
Index nodes_for_modes(double gap) {
  return 2 * static_cast<Index>(std::ceil(12.0 + 40.0 / bipolar(gap)));
}

/// Returns the eigenvalues of A M^{-1} - 1 in closed form (13.2). The nonzero eigenvalues are
/// +-e^{-y} with sinh(2 n alpha - y) = +-n sinh(2 alpha), and each eigenvalue occurs twice. The
/// mode n = 1 has only the eigenvalues with the larger y. The eigenvalues of rigid motions, and of
/// modes that the nodes do not resolve, are 0.
VectorXd known_spectrum(double gap) {
  const double alpha = bipolar(gap);
  const Index nodes = nodes_for_modes(gap);
  std::vector<double> decays{4.0 * alpha};
  for (int n = 2; n < nodes / 2; ++n) {
    const double turn = std::asinh(n * std::sinh(2.0 * alpha));
    decays.insert(decays.end(), {2.0 * n * alpha - turn, 2.0 * n * alpha + turn});
  }
  VectorXd values = VectorXd::Zero(4 * nodes);
  Index next = 0;
  for (const double y : decays) {
    for (const double sign : {1.0, 1.0, -1.0, -1.0}) values[next++] = sign * std::exp(-y);
  }
  return values;
}

/// Computes the eigenvalues of A M^{-1} - 1; M contains the block of the given shape.
///
/// The half turn maps the pair to itself: node j of one circle goes to node j + N / 2 of the other,
/// and vectors change their sign. A density that is even or odd under this map is determined by its
/// values on one circle, so half the unknowns suffice. The even and the odd densities have
/// eigenvalues of opposite sign.
VectorXcd computed_spectrum(double gap, const Shape& block) {
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
  const VectorXcd values = test::eigenvalues(preconditioned);
  VectorXcd all(2 * size);
  all << values, -values;
  return all;
}

/// This many eigenvalues are compared at either end of the spectrum. The inner eigenvalues of
/// A M^{-1} are nearer to 1. Rounding errors change these eigenvalues more, because the matrix is
/// not normal.
constexpr Index outer = 16;

Measure spectrum_errors(const Shape& block) {
  return [=](Size size) {
    std::vector<double> gaps{0.2, 0.3, 0.5, 1.0, 2.0};
    if (size == Size::full) gaps.insert(gaps.begin(), {0.05, 0.1});
    std::vector<Measurement> measurements;
    for (const double gap : gaps) {
      measurements.push_back({.x = gap,
                              .error = test::spectrum_distance(computed_spectrum(gap, block),
                                                               known_spectrum(gap), outer),
                              .unknowns = 4.0 * static_cast<double>(nodes_for_modes(gap))});
    }
    return measurements;
  };
}

/// Returns the distances of the eigenvalues from 1. Each distance occurs four times and is returned
/// once.
Measure clustering(double gap, const Shape& block) {
  return [=](Size) {
    VectorXd distances = computed_spectrum(gap, block).cwiseAbs();
    std::ranges::sort(distances, std::greater{});
    std::vector<Measurement> measurements;
    for (Index rank = 4; rank <= distances.size(); rank += 4) {
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
  return {
      .key = "pair",
      .title = "Spectrum of two circles against its closed form",
      .x = "gap, in radii, g",
      .error = "largest error of the 16 least and the 16 largest eigenvalues",
      .lines = {
          {.key = "eigenvalues",
           .label = "preconditioned operator",
           .measure = spectrum_errors(Circle{}),
           .claim =
               Claim{
                   .id = "13_1",
                   .statement = "Preconditioned by their own blocks, two equal "
                                "circles have the eigenvalues 1 +- exp(-2 n a +- "
                                "asinh(n sinh 2a)), n >= 2, and 1 +- exp(-4 a), each "
                                "twice, cosh a = 1 + g / 2; all others are 1.",
                   .law = Identity{1e-12},
                   .reason =
                       "bipolar coordinates separate the problem, see the "
                       "chapter; 1e-12: eigenvalues of a matrix "
                       "that is not normal, of which the 16 least and the 16 largest are compared",
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
          .lines = {cluster_line("far", "13_2", 2.0), cluster_line("half", "13_3", 0.5),
                    cluster_line("near", "13_4", 0.2)}};
}

}  // namespace stokesbook::verification::preconditioning
