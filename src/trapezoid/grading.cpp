#include "trapezoid/grading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double period = 2.0 * std::numbers::pi;

// Carlson's R_F, by duplication: its principal branch, for real and complex arguments.
template <class Number>
Number carlson_rf(Number x, Number y, Number z) {
  for (;;) {
    const Number mean = (x + y + z) / 3.0;
    const Number dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -dx - dy;
    // The series errs by the sixth power of the differences; norms are their squares.
    if (std::max({std::norm(dx), std::norm(dy), std::norm(dz)}) < 2e-3 * 2e-3) {
      const Number e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
      return (1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0 - 3.0 * e2 * e3 / 44.0) /
             std::sqrt(mean);
    }
    const Number root_x = std::sqrt(x), root_y = std::sqrt(y), root_z = std::sqrt(z);
    const Number lambda = root_x * root_y + root_y * root_z + root_z * root_x;
    x = 0.25 * (x + lambda);
    y = 0.25 * (y + lambda);
    z = 0.25 * (z + lambda);
  }
}

// The integral of 1 / sqrt(4 sin^2(t/2) + width^2) from 0 to t, |Re t| <= pi: (2 / width) F(t/2 |
// -4 / width^2). All terms are positive for real t, so that nothing cancels at any width.
template <class Number>
Number integral_in_period(Number t, double width) {
  const Number sine = std::sin(0.5 * t), cosine = std::cos(0.5 * t), ratio = 2.0 * sine / width;
  return ratio * carlson_rf<Number>(cosine * cosine, 1.0 + ratio * ratio, 1.0);
}

double turns(double t) {
  return std::round(t / period);
}

double integral(double t, double width) {
  const double k = turns(t);
  return integral_in_period(t - period * k, width) +
         (k == 0.0 ? 0.0 : 2.0 * k * integral_in_period(std::numbers::pi, width));
}

// Density of nodes m and its derivative.
struct Density {
  double value, slope;
};

// The map between t and C s, from where one of the clusters is: offsets tau = t - t_c keep their
// digits there.
class MapFromCluster {
 public:
  MapFromCluster(const Grading& grading, std::size_t c) : grading_(grading), origin_(c) {
    for (const Cluster& cluster : grading.clusters) {
      shifts_.push_back(parameter() - cluster.parameter);
      constants_.push_back(integral(shifts_.back(), cluster.width));
    }
  }

  double parameter() const { return grading_.clusters[origin_].parameter; }

  // C s(t_c + tau) - C s(t_c).
  double operator()(double tau) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < shifts_.size(); ++k) {
      sum += integral(shifts_[k] + tau, grading_.clusters[k].width) - constants_[k];
    }
    return tau + grading_.strength * sum;
  }

  Density density(double tau) const {
    Density density{1.0, 0.0};
    for (std::size_t k = 0; k < shifts_.size(); ++k) {
      const double t = shifts_[k] + tau;
      const double root = std::hypot(2.0 * std::sin(0.5 * t), grading_.clusters[k].width);
      density.value += grading_.strength / root;
      density.slope -= grading_.strength * std::sin(t) / (root * root * root);
    }
    return density;
  }

  // Solves for tau = width sinh v, by Newton's method in v: there the map is nearly linear about
  // the cluster. Where steps leave the bounds or do not shrink, they halve what is between these.
  double inverse(double value) const {
    const double width = grading_.clusters[origin_].width;
    double high = std::asinh(period / width), low = -high;
    double v = std::clamp(value / grading_.strength, low, high);
    double step = high - low;
    // What is left after a step is about its square.
    while (std::abs(step) > 1e-9) {
      const double tau = width * std::sinh(v);
      const double excess = (*this)(tau)-value;
      (excess > 0.0 ? high : low) = v;
      const double newton = -excess / (density(tau).value * width * std::cosh(v));
      const bool good =
          v + newton >= low && v + newton <= high && 2.0 * std::abs(newton) < std::abs(step);
      step = good ? newton : 0.5 * (low + high) - v;
      v += step;
    }
    return width * std::sinh(v);
  }

 private:
  const Grading& grading_;
  std::size_t origin_;
  std::vector<double> shifts_,  // t_c less the other clusters' parameters
      constants_;               // their integrals at t_c
};

void require_valid(const std::vector<Cluster>& clusters, const std::vector<double>& strengths) {
  const auto require = [](bool valid, const std::string& what, double value) {
    if (!valid)
      throw std::invalid_argument("a grading's " + what + ", got " + std::to_string(value));
  };
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  for (const double strength : strengths) {
    require(positive(strength), "strength must be positive", strength);
  }
  for (const Cluster& cluster : clusters) {
    require(positive(cluster.width), "widths must be positive", cluster.width);
    require(std::isfinite(cluster.parameter), "parameters must be finite", cluster.parameter);
  }
}

void require_valid(const Grading& grading) {
  require_valid(grading.clusters, {grading.strength});
}

// All clusters' integrals over half a period.
double half_period_integral(const std::vector<Cluster>& clusters) {
  double sum = 0.0;
  for (const Cluster& cluster : clusters) {
    sum += integral_in_period(std::numbers::pi, cluster.width);
  }
  return sum;
}

// C, the mean of m.
double mean_density(double strength, double half_integral) {
  return 1.0 + strength * half_integral / std::numbers::pi;
}

double mean_density(const Grading& grading) {
  return mean_density(grading.strength, half_period_integral(grading.clusters));
}

}  // namespace

std::vector<GradedParameter> graded_parameters(const Grading& grading, Index n) {
  require_valid(grading);
  std::vector<GradedParameter> parameters;
  if (grading.clusters.empty()) {
    for (Index j = 0; j < n; ++j) {
      parameters.push_back({period * static_cast<double>(j) / static_cast<double>(n), 1.0, 0.0});
    }
    return parameters;
  }
  const double mean = mean_density(grading);
  std::vector<MapFromCluster> maps;
  for (std::size_t c = 0; c < grading.clusters.size(); ++c) maps.emplace_back(grading, c);
  std::vector<double> clusters_s;
  for (const MapFromCluster& map : maps) clusters_s.push_back(-map(-map.parameter()) / mean);
  for (Index j = 0; j < n; ++j) {
    const double s = period * static_cast<double>(j) / static_cast<double>(n);
    std::size_t nearest = 0;
    double offset = period;
    for (std::size_t c = 0; c < maps.size(); ++c) {
      const double distance = std::remainder(s - clusters_s[c], period);
      if (std::abs(distance) < std::abs(offset)) {
        nearest = c;
        offset = distance;
      }
    }
    const MapFromCluster& map = maps[nearest];
    const double tau = map.inverse(mean * offset);
    const auto [m, slope] = map.density(tau);
    const double dt = mean / m;
    parameters.push_back({map.parameter() + tau, dt, -dt * dt * slope / m});
  }
  return parameters;
}

std::vector<double> graded_positions(const Grading& grading,
                                     const std::vector<GradedParameter>& parameters) {
  require_valid(grading);
  const double mean = mean_density(grading);
  double at_zero = 0.0;
  for (const auto& [parameter, width] : grading.clusters) at_zero += integral(-parameter, width);
  std::vector<double> positions;
  for (const auto& [t, first, second] : parameters) {
    double sum = -at_zero;
    for (const auto& [parameter, width] : grading.clusters) sum += integral(t - parameter, width);
    positions.push_back((t + grading.strength * sum) / mean);
  }
  return positions;
}

double graded_position(const Grading& grading, double parameter) {
  return graded_positions(grading, {{parameter, 1.0, 0.0}}).front();
}

std::vector<double> graded_depths(const std::vector<Cluster>& clusters,
                                  const std::vector<double>& strengths, double parameter,
                                  double depth) {
  require_valid(clusters, strengths);
  // The integral from there on is less than rounding; further on, sines overflow.
  constexpr double deepest = 80.0;
  double sum = 0.0;
  for (const Cluster& cluster : clusters) {
    const Complex t{std::remainder(parameter - cluster.parameter, period),
                    std::min(depth, deepest)};
    // Right on a cut of the branch, over a cluster or opposite to it, the sign is that of a zero.
    sum += std::abs(integral_in_period(t, cluster.width).imag());
  }
  const double half_integral = half_period_integral(clusters);
  std::vector<double> depths;
  for (const double strength : strengths) {
    depths.push_back((depth + strength * sum) / mean_density(strength, half_integral));
  }
  return depths;
}

double graded_depth(const Grading& grading, double parameter, double depth) {
  return graded_depths(grading.clusters, {grading.strength}, parameter, depth).front();
}

}  // namespace stokesbook
