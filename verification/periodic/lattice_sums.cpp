// Compares the sums over far images with direct sums, for powers at which these converge.
#include <cmath>

#include "experiments.hpp"
#include "periodic/far_sums.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using Eigen::Index;

namespace {

constexpr int most_power = 80;

const Lattice& sheared_lattice() {
  static const Lattice lattice({1.0, 0.0}, {0.3, 1.0});
  return lattice;
}

constexpr double disk_radius = 0.7;  // of a disk that contains the Voronoi cell of the lattice

// Sums w^-m over the vectors between two radii.
Complex direct_sum(double from, double to, int m) {
  Complex sum;
  for (const Complex w : sheared_lattice().half_disk(to)) {
    if (std::abs(w) >= from) sum += 2.0 * std::pow(disk_radius / w, m);
  }
  return sum;
}

using SumsOfPowers = Eigen::VectorXcd (*)();

Eigen::VectorXcd far_images() {
  return far_sums(sheared_lattice(), disk_radius, most_power / 2).s;
}

// A planted defect: a disk so small that all images are far, minus the near images.
Eigen::VectorXcd all_minus_near() {
  constexpr double small = 0.1;
  Eigen::VectorXcd sums = far_sums(sheared_lattice(), small, most_power / 2).s;
  for (int m = 2; m <= most_power; m += 2) {
    sums[m] = std::pow(disk_radius / small, m) * sums[m] - direct_sum(0.0, 3.0 * disk_radius, m);
  }
  return sums;
}

// The binomial factors of the far operator are at most 2^(m-1).
Measure over_powers(SumsOfPowers sums) {
  return [=](Size size) {
    const Eigen::VectorXcd found = sums();
    std::vector<Measurement> measurements;
    for (int m = 12; m <= most_power; m += size == Size::full ? 2 : 4) {
      const Complex exact = direct_sum(3.0 * disk_radius, 70.0, m);
      measurements.push_back(
          {.x = static_cast<double>(m), .error = std::ldexp(std::abs(found[m] - exact), m - 1)});
    }
    return measurements;
  };
}

}  // namespace

Experiment lattice_sums() {
  return {
      .key = "sums",
      .title = "Sums over the far images of a sheared cell",
      .x = "power m",
      .error = "error, times the largest binomial factor of the far operator",
      .axes = Axes::semi_log,
      .lines = {{.key = "split",
                 .label = "split by incomplete gamma functions",
                 .measure = over_powers(far_images),
                 .claim = Claim{.id = "14_1",
                                .statement = "The sums over far images have rounding errors that "
                                             "the far operator does not amplify.",
                                .law = Identity{2e-15},
                                .reason = "the largest term of each split sum has the size of the "
                                          "sum itself, except for the lowest powers",
                                .api = {"stokesbook::far_sums"}},
                 .control = Control{"all images minus the near ones", over_powers(all_minus_near)}},
                {.key = "difference",
                 .label = "all images minus the near ones",
                 .measure = over_powers(all_minus_near)}}};
}

}  // namespace stokesbook::verification::periodic
