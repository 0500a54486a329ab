// Compares free and held disks in sheared cells with expansions for small disks, and measures
// viscosity, normal stress and rotation of sheared arrays.
#include <cmath>
#include <numbers>
#include <tuple>

#include "defects.hpp"
#include "experiments.hpp"
#include "periodic/far_sums.hpp"
#include "support/cells.hpp"
#include "support/once.hpp"

namespace stokesbook::verification::periodic {

using namespace study;
using std::numbers::pi;
using test::Cell;
using test::CellMotion;

namespace {

// All near images are summed directly; the order suffices for rounding.
constexpr FmmSettings direct{44, 100000};

CellMotion free_disk(double area_fraction, double shear, Defect defect, Eigen::Index n) {
  static test::Once<std::tuple<double, double, Defect, Eigen::Index>, CellMotion> motions;
  return motions({area_fraction, shear, defect, n}, [&] {
    Cell cell = test::disk_in_a_cell(1.0, {shear, 1.0}, area_fraction, n);
    test::set_shear(cell);
    return solve(cell, direct, {}, images_with(cell.lattice, defect)).bodies[0];
  });
}

double drag(double area_fraction, Defect defect) {
  Cell cell = test::disk_in_a_cell(1.0, imaginary, area_fraction, 32);
  cell.bodies[0].held = RigidMotion{};
  cell.mean_velocity = 1.0;
  return -solve(cell, direct, {}, images_with(cell.lattice, defect)).bodies[0].force.real();
}

// The sums over all images of a lattice with V = 1: S_2 and T_3.
struct SquareSums {
  explicit SquareSums(double shear) {
    constexpr double small = 0.2;  // of a disk without near images
    const FarSums sums = far_sums(Lattice(1.0, {shear, 1.0}), small, 2);
    s2 = sums.s[2] / (small * small);
    t3 = sums.t[3] / (small * small);
  }
  Complex s2, t3;
};

constexpr double small_disk_shear = 0.3;

// (14.17)
double rotation_remainder(double phi, Defect defect) {
  const double omega = free_disk(phi, small_disk_shear, defect, 32).omega;
  return omega + 0.5 - phi / pi * SquareSums(small_disk_shear).s2.real();
}

// (14.16)
Complex stress_remainder(double phi, Defect defect) {
  const Complex second =
      2.0 * imaginary * (1.0 - 2.0 / pi * std::conj(SquareSums(small_disk_shear).t3));
  return free_disk(phi, small_disk_shear, defect, 32).stresslet - 2.0 * imaginary * phi -
         phi * phi * second;
}

double viscosity_remainder(double phi, Defect defect) {
  return stress_remainder(phi, defect).imag();
}

double normal_stress_remainder(double phi, Defect defect) {
  return 2.0 * stress_remainder(phi, defect).real();
}

// (14.13)
double drag_remainder(double phi, Defect defect) {
  return 4.0 * pi / drag(phi, defect) -
         (logarithm_constant(Lattice(1.0, imaginary)) - 0.5 * std::log(phi / pi) + phi);
}

using Remainder = double (*)(double area_fraction, Defect defect);

Measure over_area_fractions(Remainder remainder, Defect defect) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double phi = size == Size::full ? 0.0025 : 0.005; phi < 0.05; phi *= 2.0) {
      measurements.push_back({.x = phi, .error = std::abs(remainder(phi, defect))});
    }
    return measurements;
  };
}

Line small_line(const std::string& key, const std::string& id, const std::string& label,
                Remainder remainder, double order, const std::string& planted, Defect defect) {
  return {.key = key,
          .label = label,
          .measure = over_area_fractions(remainder, nullptr),
          .claim = Claim{.id = id,
                         .statement = "The expansion for small disks leaves a remainder of the "
                                      "next order: " +
                                      label + ".",
                         .law = Algebraic{-order, 0.1},
                         .reason = "the formula of the chapter, whose next term has one power of "
                                   "the area fraction more",
                         .api = {"stokesbook::FarOperator", "stokesbook::far_sums"}},
          .control = Control{planted, over_area_fractions(remainder, defect)}};
}

using Value = double (*)(const CellMotion& motion);

double excess_viscosity(const CellMotion& motion) {
  return motion.stresslet.imag();
}

double normal_stress_difference(const CellMotion& motion) {
  return -2.0 * motion.stresslet.real();
}

double excess_rotation(const CellMotion& motion) {
  return motion.omega + 0.5;
}

// A range of shears. Its ends may leave out those at which a value vanishes by symmetry.
struct Shears {
  double from, to;
};

Measure over_shears(double area_fraction, Value value, const Shears& shears) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double step = size == Size::full ? 0.05 : 0.1;
    for (double shear = shears.from; shear < shears.to + 0.5 * step; shear += step) {
      const CellMotion motion = free_disk(area_fraction, shear, nullptr, 64);
      measurements.push_back({.x = shear, .error = value(motion)});
    }
    return measurements;
  };
}

Experiment over_a_period(const std::string& key, const std::string& title, const std::string& error,
                         Value value, const Shears& shears) {
  Experiment experiment{.key = key,
                        .title = title,
                        .x = "shear γ",
                        .error = error,
                        .axes = Axes::no_law,
                        .lines = {}};
  for (const int percent : {10, 30, 50}) {
    const double area_fraction = 0.01 * percent;
    experiment.lines.push_back({.key = "percent_" + std::to_string(percent),
                                .label = "area fraction 0." + std::to_string(percent / 10),
                                .measure = over_shears(area_fraction, value, shears)});
  }
  return experiment;
}

Measure viscosities(double shear) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double phi : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
      const CellMotion motion = free_disk(phi, shear, nullptr, 96);
      measurements.push_back({.x = phi, .error = excess_viscosity(motion)});
    }
    return measurements;
  };
}

std::vector<Measurement> two_terms(Size) {
  std::vector<Measurement> measurements;
  const double second = 2.0 - 4.0 / pi * SquareSums(0.5).t3.real();
  for (const double phi : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
    measurements.push_back({.x = phi, .error = 2.0 * phi + second * phi * phi});
  }
  return measurements;
}

}  // namespace

Experiment small_disks() {
  return {
      .key = "small",
      .title = "Remainders of the expansions for small disks",
      .x = "area fraction φ",
      .error = "error of the expansion",
      .lines = {small_line("rotation", "14_12", "rotation of a free disk", rotation_remainder, 2.0,
                           "the sum S_2 by rows", sum_by_rows),
                small_line("viscosity", "14_13", "viscosity", viscosity_remainder, 3.0,
                           "no term with conj(A_1)", without_the_layer),
                small_line("normal", "14_14", "first normal stress difference",
                           normal_stress_remainder, 3.0, "the sum T_3 is zero", without_third_sum),
                small_line("drag", "14_15", "drag of a held disk", drag_remainder, 2.0,
                           "no constant of the logarithm", without_the_logarithm)}};
}

Experiment viscosity() {
  return over_a_period("viscosity", "Viscosity that one free disk for each cell adds",
                       "added viscosity, relative to the fluid's", excess_viscosity, {0.0, 1.0});
}

Experiment normal_stress() {
  return over_a_period("normal_stress", "First normal stress difference, in half a period",
                       "-N1 over viscosity and shear rate", normal_stress_difference, {0.05, 0.45});
}

Experiment rotation() {
  return over_a_period("rotation", "Rotation of a free disk beside that of the mean flow",
                       "angular velocity over the shear rate, plus one half", excess_rotation,
                       {0.1, 0.9});
}

Experiment dense_arrays() {
  return {
      .key = "dense",
      .title = "Viscosity of arrays of free disks against the area fraction",
      .x = "area fraction φ",
      .error = "added viscosity, relative to the fluid's",
      .lines = {
          {.key = "square", .label = "square lattice", .measure = viscosities(0.0)},
          {.key = "sheared", .label = "shear 0.3", .measure = viscosities(0.3)},
          {.key = "half", .label = "shear 0.5", .measure = viscosities(0.5)},
          {.key = "two_terms", .label = "two terms of (14.16), shear 0.5", .measure = two_terms}}};
}

}  // namespace stokesbook::verification::periodic
