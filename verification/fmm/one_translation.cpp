// Measures the truncation error of one multipole expansion that is converted once, by the order,
// the separation, and the place in the plane (08.9).
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "double_layer/kernels.hpp"
#include "experiments.hpp"
#include "fmm/translations.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::fmm {

using namespace study;
using Eigen::Index;

namespace {

constexpr std::size_t count = VectorGroup::size;
using Points = std::array<Complex, count>;

Box disk(Complex centre) {
  Box box;
  box.centre = centre;
  box.radius = 1.0;
  return box;
}

/// Returns points on the unit circle. Their coordinates are multiples of 2^-20, so that their sum
/// with a whole number is exact.
Points on_circle(double first_angle) {
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const Complex z = std::polar(1.0 - 1e-6, first_angle + 2.4 * static_cast<double>(i));
    points[i] = {std::ldexp(std::round(std::ldexp(z.real(), 20)), -20),
                 std::ldexp(std::round(std::ldexp(z.imag(), 20)), -20)};
  }
  return points;
}

/// Holds stresslets on the rim of a disk, and targets on the rim of another disk. Both start at the
/// points nearest to the other disk.
struct Pair {
  /// @param  centre    centre of the disk of sources
  /// @param  distance  distance of the disks' centres, along the real axis
  Pair(Complex centre, double distance) : from(disk(centre)), to(disk(centre + distance)) {
    const Points at = on_circle(0.0), targets_at = on_circle(std::numbers::pi);
    const ComplexVector normal = test::random_vector(Index{count}, 1),
                        density = test::random_vector(Index{count}, 2);
    for (std::size_t i = 0; i < count; ++i) {
      const auto k = static_cast<Index>(i);
      const Complex source = centre + at[i], target = centre + distance + targets_at[i];
      x[i] = source.real();
      y[i] = source.imag();
      nx[i] = normal[k].real();
      ny[i] = normal[k].imag();
      ex[i] = density[k].real();
      ey[i] = density[k].imag();
      targets.x[i] = target.real();
      targets.y[i] = target.imag();
    }
  }

  StressletBlock block() const {
    return {x.data(), y.data(), nx.data(), ny.data(), least2.data(), count, ex.data(), ey.data()};
  }

  Complex target(std::size_t i) const { return {targets.x[i], targets.y[i]}; }

  Points exact() const {
    std::array<VectorGroup, 1> sum{};
    add_velocities<1>(block(), targets, sum);
    return as_points(sum[0]);
  }

  /// Returns the local expansion about a disk.
  Expansion local(int order, const Box& about) const {
    Expansions multipole(1, 1, order);
    multipole.clear(0);
    p2m(from, block(), multipole(0, 0));
    Expansion sum = Expansion::Zero(4, order + 1);
    Translations(order).m2l({from}, multipole, std::array<Index, 1>{0}, 0, about, sum);
    return sum;
  }

  Points evaluated(const Expansion& expansion) const {
    VectorGroup sum;
    stokesbook::l2p(to, expansion, targets, sum);
    return as_points(sum);
  }

  /// Returns the largest error, relative to the largest velocity.
  double error(const Points& found) const {
    const Points all = exact();
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      difference = std::max(difference, std::abs(found[i] - all[i]));
      size = std::max(size, std::abs(all[i]));
    }
    return difference / size;
  }

  Box from, to;
  VectorGroup targets;
  std::array<double, count> x, y, nx, ny, ex, ey, least2{};

 private:
  static Points as_points(const VectorGroup& group) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) points[i] = {group.x[i], group.y[i]};
    return points;
  }
};

using TranslationMethod = std::function<double(const Pair&, int order)>;

double converted(const Pair& pair, int order) {
  return pair.error(pair.evaluated(pair.local(order, pair.to)));
}
/// A planted defect: D has the opposite sign, c_s - c_t.
double towards_the_other_side(const Pair& pair, int order) {
  const Box mirrored = disk(2.0 * pair.from.centre - pair.to.centre);
  return pair.error(pair.evaluated(pair.local(order, mirrored)));
}
/// A planted defect: the loop ends one power early.
double one_power_less(const Pair& pair, int order) {
  return converted(pair, order - 1);
}

/// Returns disks of radius 1 with the ratio rho = R/(|D| - R), see (08.8).
Pair pair_of_ratio(double rho) {
  return {{0.3, -0.2}, 1.0 + 1.0 / rho};
}

Measure over_orders(double rho, const TranslationMethod& method) {
  return [=](Size size) {
    const Pair pair = pair_of_ratio(rho);
    std::vector<Measurement> measurements;
    for (int p = 3; p <= 57; p += size == Size::full ? 1 : 3) {
      measurements.push_back({.x = static_cast<double>(p), .error = method(pair, p)});
    }
    return measurements;
  };
}

Line order_line(const std::string& key, const std::string& id, const std::string& label,
                double rho) {
  return {.key = key,
          .label = "ρ = " + label,
          .measure = over_orders(rho, converted),
          .claim = Claim{.id = id,
                         .statement = "A translation at the ratio rho = " + label +
                                      " leaves out a multiple of p rho^p.",
                         .law = Geometric{std::log(1.0 / rho), 0.05, 1.0},
                         .window = {.floor = 1e-15},
                         .reason = "a geometric series in the ratio of radius and distance; the "
                                   "factor p is that of a double pole",
                         .api = {"stokesbook::Translations", "stokesbook::p2m", "stokesbook::l2p"}},
          .control = Control{"converted towards the other side",
                             over_orders(rho, towards_the_other_side)}};
}

Measure over_ratios(int order, const TranslationMethod& method) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (double inverse = 2.0; inverse < 13.0; inverse *= size == Size::full ? 1.1 : 1.2) {
      measurements.push_back({.x = inverse, .error = method(pair_of_ratio(1.0 / inverse), order)});
    }
    return measurements;
  };
}

Line ratio_line(const std::string& key, const std::string& id, int order) {
  const std::string p = std::to_string(order);
  return {.key = key,
          .label = "order " + p,
          .measure = over_ratios(order, converted),
          .claim = Claim{.id = id,
                         .statement = "With expansions of order " + p +
                                      " the error of a translation falls like rho^" + p + ".",
                         .law = Algebraic{static_cast<double>(order), 0.4},
                         .window = {.from = 4.0, .floor = 1e-15},
                         .reason = "the first power left out is p + 1, and the velocity itself "
                                   "falls like rho; closer than rho = 1/4 further powers count",
                         .api = {"stokesbook::Translations", "stokesbook::find_interactions"}},
          .control = Control{"a power less", over_ratios(order, one_power_less)}};
}

/// At rho = 1/3 the truncation error of this order is below rounding.
constexpr int high_order = 45;

double recentred(const Pair& pair) {
  return converted(pair, high_order);
}

/// A planted defect: psi = psi_c - conj(c) phi' is taken about the origin instead of the box
/// centre.
double about_the_origin(const Pair& pair) {
  const Expansion local = pair.local(high_order, pair.to);
  const Complex c = pair.to.centre;
  const auto phi = [&](Index l) { return Complex{local(0, l), local(1, l)}; };
  const auto psi = [&](Index l) {
    const Complex slope = l < high_order ? static_cast<double>(l + 1) * phi(l + 1) : Complex{};
    return Complex{local(2, l), local(3, l)} - std::conj(c) * slope;
  };
  Points found;
  for (std::size_t i = 0; i < count; ++i) {
    const Complex z = pair.target(i), w = z - c;
    Complex value{}, slope{}, other{};
    for (Index l = high_order; l >= 0; --l) {
      slope = slope * w + value;
      value = value * w + phi(l);
      other = other * w + psi(l);
    }
    found[i] = value - z * std::conj(slope) - std::conj(other);
  }
  return pair.error(found);
}

Measure over_places(double (*method)(const Pair&)) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (int k = 4; k <= 28; k += 4) {
      const double distance = std::ldexp(1.0, k);
      measurements.push_back({.x = distance, .error = method({{distance, 0.5 * distance}, 4.0})});
    }
    return measurements;
  };
}

}  // namespace

Experiment translation() {
  return {.key = "translation",
          .title = "One translation, sources and targets on the rims of their disks",
          .x = "order p",
          .error = "largest error of the velocity, relative to the largest",
          .axes = Axes::semi_log,
          .lines = {order_line("close", "08_1", "2/3", 2.0 / 3.0),
                    order_line("half", "08_2", "1/2", 0.5),
                    order_line("third", "08_3", "1/3", 1.0 / 3.0)}};
}

Experiment separation() {
  return {.key = "separation",
          .title = "One translation, by the distance of the boxes",
          .x = "inverse ratio of radius and distance (1/ρ)",
          .error = "largest error of the velocity, relative to the largest",
          .lines = {ratio_line("four", "08_4", 4), ratio_line("eight", "08_5", 8),
                    ratio_line("twelve", "08_6", 12)}};
}

Experiment centres() {
  return {.key = "centres",
          .title = "A pair of boxes, moved away from the origin",
          .x = "distance from the origin, in radii, |c|/R",
          .error = "largest error of the velocity, relative to the largest",
          .lines = {
              {.key = "recentred",
               .label = "psi about the centre of its box",
               .measure = over_places(recentred),
               .claim = Claim{.id = "08_7",
                              .statement = "Expansions are equally accurate anywhere in the plane.",
                              .law = Identity{1e-13},
                              .reason = "they depend on differences of positions only",
                              .api = {"stokesbook::Expansion", "stokesbook::Translations"}},
               .control = Control{"psi about the origin", over_places(about_the_origin)}},
              {.key = "origin",
               .label = "psi about the origin",
               .measure = over_places(about_the_origin),
               .claim = Claim{.id = "08_8",
                              .statement = "Without a centre psi loses digits in proportion to "
                                           "the distance from the origin.",
                              .law = Algebraic{-1.0},
                              .window = {.from = 100.0},
                              .reason = "two terms of the size |c| phi' cancel",
                              .api = {"stokesbook::Expansion"}},
               .control = Control{"psi about its box", over_places(recentred)}}}};
}

}  // namespace stokesbook::verification::fmm
