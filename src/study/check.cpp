// Checks claims against measurements: orders and rates by least squares in the logarithms, levels
// by the median, bounds by the largest error.
#include "study/check.hpp"

#include <algorithm>
#include <cmath>

#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

constexpr std::size_t fewest_points = 3;
constexpr double above_floor = 10.0;

struct StraightLine {
  double slope, intercept;
};

/// Fits a line: slope = sum_i (x_i - mean x) (y_i - mean y) / sum_i (x_i - mean x)^2.
StraightLine least_squares(const std::vector<double>& x, const std::vector<double>& y) {
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  const double n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  return {xy / xx, mean_y - xy / xx * mean_x};
}

std::string about(double measured, double claimed, double band) {
  return short_number(measured, 4) + " measured, " + short_number(claimed, 4) + " +- " +
         short_number(band) + " claimed";
}

double logarithm(double x) {
  return std::log(x);
}

double identity(double x) {
  return x;
}

/// Checks one law against the points of the window. The class is the visitor of the variant Law.
class LawCheck {
 public:
  LawCheck(const Window& window, std::span<const Measurement> measurements)
      : window_(window), measurements_(measurements) {
    verdict_.used.assign(measurements.size(), false);
  }

  Verdict operator()(const Algebraic& law) {
    if (!use(above_floor * window_.floor)) return verdict_;
    const StraightLine line = fit(&Measurement::error, logarithm, 0.0);
    return band("order ", -line.slope, law.order, law.band, line);
  }

  Verdict operator()(const Geometric& law) {
    if (!use(above_floor * window_.floor)) return verdict_;
    const StraightLine line = fit(&Measurement::error, identity, law.power);
    return band("rate ", -line.slope, law.rate, law.band * law.rate, line);
  }

  Verdict operator()(const Cost& law) {
    if (!use(0.0)) return verdict_;
    const StraightLine line = fit(&Measurement::operations, logarithm, 0.0);
    return band("order of the operations ", line.slope, law.order, law.band, line);
  }

  Verdict operator()(const Superalgebraic& law) {
    if (!use(above_floor * window_.floor)) return verdict_;
    std::vector<double> orders = local_orders(used_points());
    orders.erase(orders.begin());
    const auto is_finite = [](double order) { return std::isfinite(order); };
    const bool grows = std::ranges::all_of(orders, is_finite) && std::ranges::is_sorted(orders);
    return decide(grows && orders.back() >= law.order, orders.back(),
                  "orders from " + short_number(orders.front()) + " to " +
                      short_number(orders.back()) + (grows ? ", growing" : ", not growing") +
                      "; beyond " + short_number(law.order) + " claimed");
  }

  Verdict operator()(const Floor& law) {
    if (!use(0.0)) return verdict_;
    std::vector<double> errors = used_errors();
    std::sort(errors.begin(), errors.end());
    const double median = errors[errors.size() / 2];
    return decide(median >= law.level / law.factor && median <= law.level * law.factor, median,
                  "median " + short_number(median) + " measured, " + short_number(law.level) +
                      " within a factor " + short_number(law.factor) + " claimed");
  }

  Verdict operator()(const Identity& law) { return at_most(law.tolerance); }

  Verdict operator()(const AtMost& law) { return at_most(law.bound); }

  Verdict operator()(const ErrorBelowTolerance& law) {
    if (!use(0.0)) return verdict_;
    std::vector<double> ratios;
    for (const Measurement& point : used_points()) ratios.push_back(point.error / point.x);
    const auto [least, most] = std::ranges::minmax(ratios);
    return decide(most <= law.most && least >= law.least, most,
                  "error / tolerance from " + short_number(least) + " to " + short_number(most) +
                      " measured, " + short_number(law.least) + " to " + short_number(law.most) +
                      " claimed");
  }

 private:
  /// Compares the largest error with a bound.
  Verdict at_most(double bound) {
    if (!use(0.0)) return verdict_;
    const double largest = std::ranges::max(used_errors());
    return decide(
        largest <= bound, largest,
        "at most " + short_number(largest) + " measured, " + short_number(bound) + " claimed");
  }

  /// Selects the points to check. Returns false, with the verdict set, if no check is possible.
  bool use(double least_error) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < measurements_.size(); ++i) {
      const Measurement& point = measurements_[i];
      if (point.x < window_.from || point.x > window_.to) continue;
      if (!std::isfinite(point.error)) {
        decide(false, point.error, "an error that is not finite");
        return false;
      }
      verdict_.used[i] = least_error == 0.0 || point.error >= least_error;
      count += verdict_.used[i] ? 1 : 0;
    }
    if (count < fewest_points) {
      verdict_.explanation = std::to_string(count) + " points in the window, " +
                             std::to_string(fewest_points) + " needed";
      return false;
    }
    return true;
  }

  std::vector<Measurement> used_points() const {
    std::vector<Measurement> points;
    for (std::size_t i = 0; i < measurements_.size(); ++i) {
      if (verdict_.used[i]) points.push_back(measurements_[i]);
    }
    return points;
  }

  std::vector<double> used_errors() const {
    std::vector<double> errors;
    for (const Measurement& point : used_points()) errors.push_back(point.error);
    return errors;
  }

  /// Fits log(quantity) - power * log(x) = log(C) + slope * abscissa(x).
  StraightLine fit(double Measurement::*quantity, double (*abscissa)(double), double power) const {
    std::vector<double> x, y;
    for (const Measurement& point : used_points()) {
      x.push_back(abscissa(point.x));
      y.push_back(std::log(point.*quantity) - power * std::log(point.x));
    }
    return least_squares(x, y);
  }

  Verdict decide(bool holds, double measured, std::string explanation) {
    verdict_.outcome = holds ? Outcome::holds : Outcome::fails;
    verdict_.measured = measured;
    verdict_.explanation = std::move(explanation);
    return verdict_;
  }

  Verdict band(const char* what, double measured, double claimed, double width, StraightLine line) {
    verdict_.constant = std::exp(line.intercept);
    return decide(std::abs(measured - claimed) <= width, measured,
                  what + about(measured, claimed, width));
  }

  Window window_;
  std::span<const Measurement> measurements_;
  Verdict verdict_;
};

/// Computes -log(e_i / e_{i-1}) / step(x_{i-1}, x_i).
template <class Step>
std::vector<double> local_slopes(std::span<const Measurement> points, const Step& step) {
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
  switch (outcome) {
    case Outcome::holds:
      return "holds";
    case Outcome::fails:
      return "fails";
    case Outcome::inconclusive:
      break;
  }
  return "inconclusive";
}

Verdict check(const Claim& claim, std::span<const Measurement> measurements) {
  return std::visit(LawCheck{claim.window, measurements}, claim.law);
}

std::vector<double> local_orders(std::span<const Measurement> measurements) {
  return local_slopes(measurements, [](double from, double to) { return std::log(to / from); });
}

std::vector<double> local_rates(std::span<const Measurement> measurements) {
  return local_slopes(measurements, [](double from, double to) { return to - from; });
}

}  // namespace stokesbook::study
