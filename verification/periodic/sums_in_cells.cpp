// Compares velocities and derivatives of sources in cells with Ewald sums, by the order and by the
// tolerance that chooses the order.
#include <cmath>

#include "defects.hpp"
#include "experiments.hpp"
#include "periodic/far_operator.hpp"
#include "support/periodic_sources.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using Eigen::Index;
using test::PeriodicSources;

namespace {

constexpr FmmSettings all_digits{44, 100000};

// A cell with the radius of a disk that contains its Voronoi cell.
struct RimCell {
  Complex a1, a2;
  double radius;

  Lattice lattice() const { return {a1, a2}; }

  // The rate at which errors fall for sources and targets on the rim of the disk: the logarithm of
  // the ratio (|w| - R)/R for the nearest far image.
  double rate() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Complex w : lattice().half_disk(6.0 * radius)) {
      if (std::abs(w) >= 3.0 * radius) nearest = std::min(nearest, std::abs(w));
    }
    return std::log(nearest / radius - 1.0);
  }
};

const RimCell square{1.0, {0.0, 1.0}, std::sqrt(0.5)}, sheared{1.0, {0.5, 1.0}, 0.625},
    oblong{2.0, {0.0, 1.0}, 0.5 * std::sqrt(5.0)}, slender{8.0, {0.0, 1.0}, 0.5 * std::sqrt(65.0)};

ComplexVector rim(const RimCell& cell, Index n, double start) {
  ComplexVector points(n);
  for (Index j = 0; j < n; ++j) {
    points[j] = std::polar(cell.radius, start + 2.0 * std::numbers::pi * static_cast<double>(j) /
                                                    static_cast<double>(n));
  }
  return points;
}

// Random stresslets on the rim, without a net source.
PeriodicSources rim_sources(const RimCell& cell) {
  PeriodicSources sources = test::random_sources(cell.lattice(), 0.0, 40, 0);
  sources.curve.x = rim(cell, 40, 0.0);
  return sources;
}

using Images = FmmImagePlan (*)(const RimCell& cell);

FmmImagePlan all_near_images(const RimCell& cell) {
  return images_in(cell.lattice());
}

FmmImagePlan neighbours_only(const RimCell& cell) {
  return eight_neighbours(cell.a1, cell.a2);
}

Measure over_orders(const RimCell& cell, Images images) {
  return [=](Size size) {
    const PeriodicSources sources = rim_sources(cell);
    const ComplexVector targets = rim(cell, size == Size::full ? 40 : 12, 0.05);
    std::vector<Measurement> measurements;
    for (int p = 6; p <= 46; p += size == Size::full ? 2 : 5) {
      measurements.push_back(
          {.x = static_cast<double>(p),
           .error = test::errors(sources, targets, {p, 100000}, images(cell)).velocity});
    }
    return measurements;
  };
}

Line order_line(const std::string& key, const std::string& id, const std::string& label,
                const RimCell& cell, Images wrong) {
  return {.key = key,
          .label = label,
          .measure = over_orders(cell, all_near_images),
          .claim = Claim{.id = id,
                         .statement = "Errors of a " + label +
                                      " fall at the rate of the nearest image that is far.",
                         .law = Geometric{cell.rate(), 0.08, 0.5},
                         .window = {.floor = 1e-15},
                         .reason = "sources and targets on the rim have a series in R/(|w| - R); "
                                   "a power of p between 0 and 1 belongs to the double poles, of "
                                   "which few face each other",
                         .api = {"stokesbook::FarOperator", "stokesbook::images_in"}},
          .control = Control{"the eight neighbours are the near images", over_orders(cell, wrong)}};
}

using Choice = FmmSettings (*)(double tolerance);

FmmSettings for_half_of_the_digits(double tolerance) {
  return FmmSettings::for_tolerance(std::sqrt(tolerance));
}

// Sources and targets anywhere in the Voronoi cell.
PeriodicSources cell_sources() {
  return test::random_sources(square.lattice(), 0.0, 40, 0);
}

PeriodicSources square_rim() {
  return rim_sources(square);
}

// The errors are those in the 2-norm, as for an Fmm without images, at points near the sources.
Measure over_tolerances(PeriodicSources (*make)(), Choice choice) {
  return [=](Size size) {
    const PeriodicSources sources = make();
    const ComplexVector targets = std::polar(1.0, 0.05) * sources.curve.x;
    ComplexVector exact(targets.size());
    for (Index i = 0; i < targets.size(); ++i) exact[i] = sources.velocity(targets[i]);
    std::vector<Measurement> measurements;
    for (int digits = 12; digits >= 3; digits -= size == Size::full ? 1 : 3) {
      const double tolerance = std::pow(10.0, -digits);
      const FmmSettings settings{choice(tolerance).order, 100000};
      const Fmm fmm({sources.curve}, {}, targets, settings, images_in(sources.lattice));
      measurements.push_back(
          {.x = tolerance,
           .error = test::relative_error(fmm.velocity(sources.density).col(0), exact)});
    }
    return measurements;
  };
}

// Which sources are in the sum.
struct Kinds {
  bool layer, forces, torques;
};

using Quantity = double test::PeriodicErrors::*;

Measure over_shears(const Kinds& kinds, Quantity quantity, Defect defect) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double step = size == Size::full ? 0.05 : 0.25;
    for (double shear = 0.0; shear < 1.0 + 0.5 * step; shear += step) {
      const Lattice lattice(1.0, {shear, 1.0});
      PeriodicSources sources = test::random_sources(lattice, {0.3, -1.2}, 20, 3);
      if (!kinds.layer) sources.density.setZero();
      for (PointForce& point : sources.points) {
        if (!kinds.forces) point.force = 0.0;
        if (!kinds.torques) point.torque = 0.0;
      }
      const ComplexVector targets = test::points_in_cell(lattice, {0.3, -1.2}, 8, 5);
      measurements.push_back(
          {.x = shear,
           .error =
               test::errors(sources, targets, all_digits, images_with(lattice, defect)).*quantity});
    }
    return measurements;
  };
}

Line ewald_line(const std::string& key, const std::string& id, const std::string& label,
                const Kinds& kinds, Quantity quantity, const std::string& planted, Defect defect) {
  return {
      .key = key,
      .label = label,
      .measure = over_shears(kinds, quantity, nullptr),
      .claim = Claim{.id = id,
                     .statement = "Near and far images together are the Ewald sum: " + label + ".",
                     .law = Identity{1e-12},
                     .reason = "both are the periodic flow with the mean velocity zero, and "
                               "they share no formula",
                     .api = {"stokesbook::FarOperator", "stokesbook::images_in"}},
      .control = Control{planted, over_shears(kinds, quantity, defect)}};
}

}  // namespace

Experiment orders() {
  return {
      .key = "orders",
      .title = "Velocities of sources on the rim of the disk",
      .x = "order p",
      .error = "largest error of the velocity, relative",
      .axes = Axes::semi_log,
      .lines = {order_line("square", "14_2", "square cell", square, neighbours_only),
                order_line("sheared", "14_3", "cell sheared by one half", sheared, neighbours_only),
                order_line("oblong", "14_4", "cell 2:1", oblong, neighbours_only),
                order_line("slender", "14_5", "cell 8:1", slender, neighbours_only),
                {.key = "neighbours",
                 .label = "square cell, eight neighbours",
                 .measure = over_orders(square, neighbours_only)}}};
}

Experiment tolerances() {
  return {.key = "tolerances",
          .title = "Velocities for a tolerance, square cell",
          .x = "tolerance ε",
          .error = "error of the velocity in the 2-norm, relative",
          .lines = {
              {.key = "cell",
               .label = "sources in the cell",
               .measure = over_tolerances(cell_sources, FmmSettings::for_tolerance),
               .claim = Claim{.id = "14_6",
                              .statement = "The order that the fast multipole method chooses for a "
                                           "tolerance meets it in a cell.",
                              .law = ErrorBelowTolerance{1.0, 1e-3},
                              .reason = "near images end where two boxes are well separated, so "
                                        "that far images are no harder than the worst pair of "
                                        "boxes",
                              .api = {"stokesbook::images_in"}},
               .control = Control{"the order of half of the digits",
                                  over_tolerances(cell_sources, for_half_of_the_digits)}},
              {.key = "rim",
               .label = "sources on the rim of the disk",
               .measure = over_tolerances(square_rim, FmmSettings::for_tolerance)}}};
}

Experiment ewald_sums() {
  const Quantity velocity = &test::PeriodicErrors::velocity,
                 derivatives = &test::PeriodicErrors::derivatives;
  return {
      .key = "ewald",
      .title = "Sums in a sheared cell against Ewald sums",
      .x = "shear γ",
      .error = "largest error, relative",
      .axes = Axes::no_law,
      .lines = {
          ewald_line("layer", "14_7", "velocities of a double layer", {true, false, false},
                     velocity, "no term with conj(A_1)", without_the_layer),
          ewald_line("torques", "14_8", "velocities of torques", {false, false, true}, velocity,
                     "no term with Im B_1", without_the_torques),
          ewald_line("forces", "14_9", "velocities of forces with a net force",
                     {false, true, false}, velocity, "no term with conj(A_0)", without_the_forces),
          ewald_line("mean", "14_10", "velocities of all sources, with the mean zero",
                     {true, true, true}, velocity, "no term with B_2", without_the_mean),
          ewald_line("derivatives", "14_11", "pressure, vorticity and strain", {true, true, true},
                     derivatives, "the sum S_2 by rows", sum_by_rows)}};
}

}  // namespace stokesbook::verification::periodic
