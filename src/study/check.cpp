// Checks claims against measurements: orders and rates by least squares in the logarithms, levels
// by the median, bounds by the largest error.
#include "study/check.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

constexpr std::size_t fewest_points = 3;
constexpr double above_floor = 10.0;

/// Returns the slope of the fitted line,
/// sum_i (x_i - mean x) (y_i - mean y) / sum_i (x_i - mean x)^2.
double fitted_slope(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y) {
  const Eigen::ArrayXd from_mean = x - x.mean();
  return (from_mean * (y - y.mean())).sum() / from_mean.square().sum();
}

/// Checks one law against the selected points. The verdict lacks the list of used measurements.
struct LawCheck {
  const std::vector<Measurement>& points;
  Eigen::ArrayXd x = all(&Measurement::x);
  Eigen::ArrayXd error = all(&Measurement::error);

  Verdict operator()(const Algebraic& law) const {
    // log e = log C - p log x; of errors that grow, the power -p is shown
    const bool grows = law.order < 0.0;
    const double slope = fitted_slope(x.log(), error.log());
    return band(grows ? "power " : "order ", grows ? slope : -slope, std::abs(law.order), law.band);
  }

  Verdict operator()(const Geometric& law) const {
    // log e - q log x = log C - alpha x
    const double slope = fitted_slope(x, error.log() - law.power * x.log());
    return band("rate ", -slope, law.rate, law.band * law.rate);
  }

  Verdict operator()(const Cost& law) const {
    const double slope = fitted_slope(x.log(), all(&Measurement::operations).log());
    return band("order of the operations ", slope, law.order, law.band);
  }

  Verdict operator()(const Superalgebraic& law) const {
    std::vector<double> orders = local_orders(points);
    orders.erase(orders.begin());
    const auto is_finite = [](double order) { return std::isfinite(order); };
    const bool grows = std::ranges::all_of(orders, is_finite) && std::ranges::is_sorted(orders);
    return verdict(grows && orders.back() >= law.order, orders.back(),
                   "orders from " + short_number(orders.front()) + " to " +
                       short_number(orders.back()) + (grows ? ", growing" : ", not growing") +
                       "; beyond " + short_number(law.order) + " claimed");
  }

  Verdict operator()(const Floor& law) const {
    Eigen::ArrayXd sorted = error;
    std::ranges::sort(sorted);
    const double median = sorted[sorted.size() / 2];
    return verdict(median >= law.level / law.factor && median <= law.level * law.factor, median,
                   "median " + short_number(median) + " measured, " + short_number(law.level) +
                       " within a factor " + short_number(law.factor) + " claimed");
  }

  Verdict operator()(const Identity& law) const { return (*this)(AtMost{law.tolerance}); }

  Verdict operator()(const AtMost& law) const {
    const double largest = error.maxCoeff();
    return verdict(
        largest <= law.bound, largest,
        "at most " + short_number(largest) + " measured, " + short_number(law.bound) + " claimed");
  }

  Verdict operator()(const ErrorBelowTolerance& law) const {
    const Eigen::ArrayXd ratios = error / x;
    const double least = ratios.minCoeff(), most = ratios.maxCoeff();
    return verdict(most <= law.most && least >= law.least, most,
                   "error / tolerance from " + short_number(least) + " to " + short_number(most) +
                       " measured, " + short_number(law.least) + " to " + short_number(law.most) +
                       " claimed");
  }

 private:
  Eigen::ArrayXd all(double Measurement::*quantity) const {
    return Eigen::ArrayXd::NullaryExpr(std::ssize(points), [&](Eigen::Index i) {
      return points[static_cast<std::size_t>(i)].*quantity;
    });
  }

  static Verdict band(const char* name, double measured, double claimed, double width) {
    return verdict(std::abs(measured - claimed) <= width, measured,
                   name + short_number(measured, 4) + " measured, " + short_number(claimed, 4) +
                       " +- " + short_number(width) + " claimed");
  }

  static Verdict verdict(bool holds, double measured, const std::string& explanation) {
    return {holds ? Outcome::holds : Outcome::fails, measured, explanation, {}};
  }
};

bool fits_errors(const Law& law) {
  return std::holds_alternative<Algebraic>(law) || std::holds_alternative<Geometric>(law) ||
         std::holds_alternative<Superalgebraic>(law);
}

/// Computes -log(e_i / e_{i-1}) / step(x_{i-1}, x_i).
std::vector<double> local_slopes(std::span<const Measurement> points, const auto& step) {
  std::vector<double> slopes(points.size(), unmeasured);
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].error > 0.0 && points[i - 1].error > 0.0) {
      slopes[i] =
          -std::log(points[i].error / points[i - 1].error) / step(points[i - 1].x, points[i].x);
    }
  }
  return slopes;
}

}  // namespace

std::string to_string(Outcome outcome) {
  if (outcome == Outcome::inconclusive) return "inconclusive";
  return outcome == Outcome::holds ? "holds" : "fails";
}

Verdict check(const Claim& claim, std::span<const Measurement> measurements) {
  std::vector<bool> used(measurements.size(), false);
  std::vector<Measurement> points;
  const bool has_floor = claim.window.floor > 0.0 && fits_errors(claim.law);
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement& point = measurements[i];
    if (point.x < claim.window.from || point.x > claim.window.to) continue;
    if (!std::isfinite(point.error)) {
      return {Outcome::fails, point.error, "an error that is not finite", used};
    }
    if (has_floor && point.error < above_floor * claim.window.floor) continue;
    used[i] = true;
    points.push_back(point);
  }
  if (points.size() < fewest_points) {
    return {Outcome::inconclusive, unmeasured,
            std::to_string(points.size()) + " points in the window, " +
                std::to_string(fewest_points) + " needed",
            used};
  }
  Verdict verdict = std::visit(LawCheck{points}, claim.law);
  verdict.used = used;
  return verdict;
}

std::vector<double> local_orders(std::span<const Measurement> measurements) {
  return local_slopes(measurements, [](double from, double to) { return std::log(to / from); });
}

std::vector<double> local_rates(std::span<const Measurement> measurements) {
  return local_slopes(measurements, [](double from, double to) { return to - from; });
}

}  // namespace stokesbook::study
