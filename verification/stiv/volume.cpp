// Compares the volume of two circles with the integral of their gaps (10.6).
#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::stiv {

using namespace study;
using Eigen::Index;

namespace {

constexpr double radius = 0.5;

struct Impact {
  double separation, depth;
};

// Returns the contacts of two circles that approach along the x axis from a wide gap to a depth.
std::vector<Contact> contacts(const Impact& impact, Index m, Index m_of_other, double phase) {
  constexpr double travel = 0.2;
  const double distance = 2.0 * radius + impact.separation + travel - impact.depth;
  return violations({{body(Circle{radius}, m), body(Circle{radius}, m_of_other)},
                     {{{{0.0, 0.0}, phase}, {0.0, 0.0}, 0.0},
                      {{{distance, 0.0}, 0.7 * phase}, {-travel, 0.0}, 0.0}}},
                    {{impact.separation}, 1e-9});
}

/// @param  m_of_other  vertices of the other circle; a number other than m is a planted defect
double volume(const Impact& impact, Index m, Index m_of_other, double phase) {
  double sum = 0.0;
  for (const Contact& contact : contacts(impact, m, m_of_other, phase)) sum -= contact.volume;
  return sum;
}

// Returns the gap of the point at an angle phi from the axis. All depths are below half of the
// separation, so that the gap is the distance at the end of the step minus the separation.
double gap(const Impact& impact, double phi) {
  const double distance = 2.0 * radius + impact.separation - impact.depth;
  return std::abs(distance - std::polar(radius, phi)) - radius - impact.separation;
}

// Integrates the gaps of both circles by Simpson's rule. The rule has order 4 because the integrand
// vanishes at the ends of the contact.
double exact_volume(const Impact& impact) {
  double inside = 0.0, outside = 1.0;
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = 0.5 * (inside + outside);
    (gap(impact, middle) < 0.0 ? inside : outside) = middle;
  }
  constexpr int intervals = 400;
  double sum = 0.0;
  for (int k = 0; k <= intervals; ++k) {
    const double weight = k == 0 || k == intervals ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    sum -= weight * gap(impact, inside * (2.0 * k / intervals - 1.0));
  }
  return 2.0 * radius * sum * (2.0 * inside / intervals) / 3.0;
}

double published(const Impact& impact) {
  return 2.0 * 4.0 / 3.0 * std::sqrt(radius) * std::pow(impact.depth, 1.5);
}

constexpr double thin = 1e-3, wide = 0.05;

std::vector<double> depths(Size size) {
  std::vector<double> all;
  for (double p = size == Size::full ? 1e-5 : 1e-4; p < 2e-2; p *= std::sqrt(10.0))
    all.push_back(p);
  return all;
}

Measure over_depths(double (*of)(const Impact& impact)) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double depth : depths(size)) {
      measurements.push_back({.x = depth, .error = of({thin, depth})});
    }
    return measurements;
  };
}

double measured(const Impact& impact) {
  return volume(impact, 8192, 8192, 1e-4);
}

// A planted defect: the edges are as long as the contact.
double with_long_edges(const Impact& impact) {
  return volume(impact, 64, 64, 1e-4);
}

// Measures the root mean square of the errors over orientations of the polygons.
//
// @param  m_of_other  vertices of the other circle; 0: as many as on the first
Measure over_vertices(double (*reference)(const Impact& impact), Index m_of_other = 0) {
  return [=](Size size) {
    const Impact impact{wide, 1e-2};
    const double exact = reference(impact);
    std::vector<Measurement> measurements;
    for (Index m = 256; m <= (size == Size::full ? 8192 : 2048); m *= 2) {
      constexpr int phases = 16;
      double sum = 0.0;
      for (int k = 0; k < phases; ++k) {
        const double phase = 2.0 * std::numbers::pi / static_cast<double>(m) * (k + 0.3) / phases;
        const double found = volume(impact, m, m_of_other == 0 ? m : m_of_other, phase);
        sum += std::pow(found / exact - 1.0, 2);
      }
      measurements.push_back({.x = static_cast<double>(m), .error = std::sqrt(sum / phases)});
    }
    return measurements;
  };
}

}  // namespace

Experiment volume_of_depth() {
  return {
      .key = "depth",
      .title = "The volume of two circles of radius 1/2",
      .x = "depth p",
      .error = "|V|",
      .lines = {
          {.key = "volume",
           .label = "volume",
           .measure = over_depths(measured),
           .claim = Claim{.id = "10_6",
                          .statement = "The volume grows as the power 3/2 of the depth.",
                          .law = Algebraic{-1.5, 0.01},
                          .reason = "the gap is a parabola of height p, over a length "
                                    "in proportion to the root of p",
                          .api = {"stokesbook::Contact"}},
           .control = Control{"64 vertices a circle, with edges as long as the contact",
                              over_depths(with_long_edges)}},
          {.key = "published", .label = "(8/3) √a p^(3/2)", .measure = over_depths(published)}}};
}

Experiment volume_of_vertices() {
  return {
      .key = "volume",
      .title = "The volume of two circles, by polygons",
      .x = "vertices M",
      .error = "relative error of V, root mean square",
      .lines = {{.key = "volume",
                 .label = "volume",
                 .measure = over_vertices(exact_volume),
                 .claim = Claim{.id = "10_7",
                                .statement = "The volume is of order 2 in the vertices.",
                                .law = Algebraic{2.0, 0.2},
                                .reason = "the trapezoid rule for an integrand with kinks at the "
                                          "ends of the contact, and edges for arcs",
                                .api = {"stokesbook::Contact"}},
                 .control = Control{"128 vertices on the other circle, always",
                                    over_vertices(exact_volume, 128)}},
                {.key = "published",
                 .label = "against (8/3) √a p^(3/2)",
                 .measure = over_vertices(published)}}};
}

}  // namespace stokesbook::verification::stiv
