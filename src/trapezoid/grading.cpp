// Computes graded parameters: inverts the map s(t) of (06.18), a sum of elliptic integrals, by
// Halley's method. Evaluates the map at complex t, which gives rates of convergence.
#include "trapezoid/grading.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "trapezoid/plane.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

constexpr double period = 2.0 * std::numbers::pi;

// Evaluates Carlson's elliptic integral R_F by the duplication theorem: the principal branch, for
// real and complex arguments.
template <class Number>
Number carlson_rf(Number x, Number y, Number z) {
  for (;;) {
    const Number mean = (x + y + z) / 3.0;
    const Number dx = 1.0 - x / mean, dy = 1.0 - y / mean, dz = -dx - dy;
    // The error of the series is of sixth order in the differences; std::norm squares them.
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

// Integrates 1 / sqrt(4 sin^2(t/2) + width^2) from 0 to t, |Re t| <= pi. The result is
// (2 / width) F(t/2 | -4 / width^2) with the elliptic integral F of the first kind. For real t all
// terms are positive, so that nothing cancels at any width.
template <class Number>
Number integral_in_period(Number t, double width) {
  const Number sine = std::sin(0.5 * t), cosine = std::cos(0.5 * t), ratio = 2.0 * sine / width;
  return ratio * carlson_rf<Number>(cosine * cosine, 1.0 + ratio * ratio, 1.0);
}

// Integrates as integral_in_period() up to any real t: each period adds two half periods.
double integral(double t, double width) {
  const double k = std::round(t / period);
  return integral_in_period(t - period * k, width) +
         (k == 0.0 ? 0.0 : 2.0 * k * integral_in_period(std::numbers::pi, width));
}

// Node density m of (06.18), and its derivative with respect to t.
struct Density {
  double value, slope;
};

// The map between t and C s (06.18), with the origin at the parameter t_c of one of the clusters:
// near t_c, the offsets tau = t - t_c have full relative accuracy.
class MapFromCluster {
 public:
  MapFromCluster(const Grading& grading, std::size_t c) : grading_(grading), origin_(c) {
    for (const Cluster& cluster : grading.clusters) {
      shifts_.push_back(parameter() - cluster.parameter);
      constants_.push_back(integral(shifts_.back(), cluster.width));
    }
  }

  double parameter() const { return grading_.clusters[origin_].parameter; }

  // Returns C s(t_c + tau) - C s(t_c).
  double operator()(double tau) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < shifts_.size(); ++k) {
      sum += integral(shifts_[k] + tau, grading_.clusters[k].width) - constants_[k];
    }
    return tau + grading_.strength * sum;
  }

  // m = 1 + b sum_k 1 / sqrt(4 sin^2(t_k/2) + delta_k^2), t_k the offset from cluster k.
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

  // Finds the v, tau = width sinh v, at which the map has a value: about the cluster, the map is
  // nearly linear in v. A step of Halley's method that leaves the bounds, or that does not shrink
  // by half, is replaced by a bisection of the bounds.
  double inverse(double value, double guess) const {
    double high = std::asinh(period / width()), low = -high;
    double v = std::clamp(guess, low, high);
    double step = high - low;
    // The error after a step is about the cube of that step.
    while (std::abs(step) > 1e-9) {
      const double tau = offset(v), slope = width() * std::cosh(v);
      const double excess = (*this)(tau)-value;
      (excess > 0.0 ? high : low) = v;
      const Density m = density(tau);
      const double newton = -excess / (m.value * slope);
      // Half the second derivative over the first one.
      const double curvature = 0.5 * (m.slope * slope / m.value + std::tanh(v));
      const double halley = newton / (1.0 + newton * curvature);
      const bool good =
          v + halley >= low && v + halley <= high && 2.0 * std::abs(halley) < std::abs(step);
      step = good ? halley : 0.5 * (low + high) - v;
      v += step;
    }
    return v;
  }

  // Guesses v for the inverse of a value.
  double guess(double value) const { return value / grading_.strength; }

  // Returns tau = width sinh v.
  double offset(double v) const { return width() * std::sinh(v); }

 private:
  double width() const { return grading_.clusters[origin_].width; }

  const Grading& grading_;
  std::size_t origin_;
  std::vector<double> shifts_,  // t_c minus the parameter of each cluster
      constants_;               // integral of each cluster at t_c
};

void require_valid(const std::vector<Cluster>& clusters, const std::vector<double>& strengths) {
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  for (const double strength : strengths) {
    require(positive(strength), "a grading's strength must be positive, got ", strength);
  }
  for (const Cluster& cluster : clusters) {
    require(positive(cluster.width), "a grading's widths must be positive, got ", cluster.width);
    require(std::isfinite(cluster.parameter), "a grading's parameters must be finite, got ",
            cluster.parameter);
  }
}

// Sums the integrals of all clusters over half a period.
double half_period_integral(const std::vector<Cluster>& clusters) {
  double sum = 0.0;
  for (const Cluster& cluster : clusters) {
    sum += integral_in_period(std::numbers::pi, cluster.width);
  }
  return sum;
}

// Returns C of (06.18), the mean of m.
double mean_density(double strength, double half_integral) {
  return 1.0 + strength * half_integral / std::numbers::pi;
}

}  // namespace

std::vector<GradedParameter> graded_parameters(const Grading& grading, Index n) {
  require_valid(grading.clusters, {grading.strength});
  std::vector<GradedParameter> parameters;
  if (grading.clusters.empty()) {
    for (Index j = 0; j < n; ++j) {
      parameters.push_back({period * static_cast<double>(j) / static_cast<double>(n), 1.0, 0.0});
    }
    return parameters;
  }
  const double mean = mean_density(grading.strength, half_period_integral(grading.clusters));
  std::vector<MapFromCluster> maps;
  for (std::size_t c = 0; c < grading.clusters.size(); ++c) maps.emplace_back(grading, c);
  // s(t_c) of each cluster, where s(0) = 0.
  std::vector<double> clusters_s;
  for (const MapFromCluster& map : maps) clusters_s.push_back(-map(-map.parameter()) / mean);
  std::vector<double> latest;  // v of the nodes before with the same nearest cluster
  auto nearest_before = clusters_s.begin();
  for (Index j = 0; j < n; ++j) {
    const double s = period * static_cast<double>(j) / static_cast<double>(n);
    const auto offset = [&](double cluster_s) { return std::remainder(s - cluster_s, period); };
    const auto nearest = std::ranges::min_element(
        clusters_s, {}, [&](double cluster_s) { return std::abs(offset(cluster_s)); });
    if (nearest != std::exchange(nearest_before, nearest)) latest.clear();
    // t follows from the nearest cluster; dt/ds = C / m and d2t/ds2 = -(dt/ds)^2 m' / m.
    const MapFromCluster& map = maps[static_cast<std::size_t>(nearest - clusters_s.begin())];
    const double value = mean * offset(*nearest);
    latest.push_back(map.inverse(value, latest.size() < 2
                                            ? map.guess(value)
                                            : 2.0 * latest.back() - *std::prev(latest.end(), 2)));
    const double tau = map.offset(latest.back());
    const auto [m, slope] = map.density(tau);
    const double dt = mean / m;
    parameters.push_back({map.parameter() + tau, dt, -dt * dt * slope / m});
  }
  return parameters;
}

std::vector<double> graded_positions(const Grading& grading,
                                     const std::vector<GradedParameter>& parameters) {
  require_valid(grading.clusters, {grading.strength});
  const double mean = mean_density(grading.strength, half_period_integral(grading.clusters));
  // C s(t) = t + b sum_c [I_c(t - t_c) - I_c(-t_c)] with the integral I_c of each cluster (06.18).
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

std::vector<double> graded_depths(const std::vector<Cluster>& clusters,
                                  const std::vector<double>& strengths, double parameter,
                                  double depth) {
  require_valid(clusters, strengths);
  // The rest of the integral beyond this depth is below rounding; far beyond, the sines overflow.
  constexpr double deepest = 80.0;
  double sum = 0.0;
  for (const Cluster& cluster : clusters) {
    const Complex t{std::remainder(parameter - cluster.parameter, period),
                    std::min(depth, deepest)};
    // Above a cluster, and opposite to it, t lies on a branch cut, where the sign of the imaginary
    // part is that of a zero: only the modulus counts.
    sum += std::abs(integral_in_period(t, cluster.width).imag());
  }
  const double half_integral = half_period_integral(clusters);
  // |Im s| = (d + b sum) / C, see graded_depth().
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
