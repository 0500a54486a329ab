// Solves for eight lobed bodies in shear, and measures the effect of the scheme between the bodies
// on their motions.
#include <algorithm>
#include <memory>
#include <tuple>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "set_ups.hpp"
#include "support/once.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

enum class Between {
  plain,
  published,
  tolerance,
  cauchy,
  twice  ///< a planted defect: the Cauchy corrections are added twice
};

CloseScheme scheme_of(const Curve& curve, Between between) {
  switch (between) {
    case Between::published:
      return std::make_shared<const InterpolationCurve>(
          curve, InterpolationSettings::published(curve.size()));
    case Between::tolerance:
      return std::make_shared<const InterpolationCurve>(curve,
                                                        InterpolationSettings::for_tolerance(1e-6));
    default:
      return std::make_shared<const CauchyCurve>(curve);
  }
}

/// Holds the velocity at the centroid, and the angular velocity, of each body.
using Motions = ComplexVector;

/// Solves for free bodies r = (1 + cos(k t)/5)/2, k = 2, 3, 4, 5, 5, 4, 3, 2, in a row with equal
/// spacings, in the shear flow (y, 0). At the spacing 5/4 the gaps are 0.05 and 0.25.
class Row {
 public:
  Row(Index n, double spacing, Between between) : n_(n) {
    std::vector<PlacedCurve> placed;
    Complex centre{};
    for (const int arms : {2, 3, 4, 5, 5, 4, 3, 2}) {
      const Curve curve = sample(Star{0.5, 0.2, arms}, n, Side::fluid_outside);
      curves_.push_back(place(curve, centre, 0.0));
      placed.push_back({scheme_of(curve, between), centre, 0.0});
      centre += spacing;
    }
    sum_ = std::make_unique<StressletSum>(curves_);
    if (between == Between::plain) return;
    factor_ = between == Between::twice ? 2.0 : 1.0;
    near_ = std::make_unique<NearCorrection>(placed, all_nodes(curves_), Targets::own_nodes,
                                             NearSettings{1e-8});
  }

  /// Solves (-1/2 + D - P) eta = -u. The mean rigid motion P eta is the velocity on a body.
  Motions motions() const {
    const ComplexVector flow = all_nodes(curves_).imag().cast<Complex>();
    const auto map = [this](const Eigen::VectorXd& v) -> Eigen::VectorXd {
      const ComplexVector density = deinterleaved(v);
      return interleaved(apply(density)).eval();
    };
    const ComplexVector rhs = -flow;
    const GmresResult result = gmres(map, {}, interleaved(rhs), {1e-12, 300});
    return means(deinterleaved(result.solution));
  }

 private:
  const Curve& curve(Index k) const { return curves_[static_cast<std::size_t>(k)]; }
  ComplexVector arms(Index k) const {
    return (curve(k).x.array() - boundary_centroid(curve(k))).matrix();
  }

  Motions means(const ComplexVector& density) const {
    Motions motions(2 * std::ssize(curves_));
    for (Index k = 0; k < std::ssize(curves_); ++k) {
      const Eigen::VectorXd w = weights(curve(k)) / perimeter(curve(k));
      const ComplexVector own = density.segment(n_ * k, n_), arm = arms(k);
      motions[2 * k] = w.cast<Complex>().dot(own);
      motions[2 * k + 1] = arm.conjugate().cwiseProduct(own).imag().dot(w) / arm.cwiseAbs2().dot(w);
    }
    return motions;
  }

  ComplexVector apply(const ComplexVector& density) const {
    ComplexVector velocity = (*sum_)(density)-0.5 * density;
    if (near_) velocity += factor_ * (*near_)(density);
    const Motions mean = means(density);
    for (Index k = 0; k < std::ssize(curves_); ++k) {
      const ComplexVector own = density.segment(n_ * k, n_);
      velocity.segment(n_ * k, n_) +=
          diagonal_velocity(curve(k), own) -
          (mean[2 * k] + imaginary * mean[2 * k + 1] * arms(k).array()).matrix();
    }
    return velocity;
  }

  Index n_;
  std::vector<Curve> curves_;
  std::unique_ptr<StressletSum> sum_;
  std::unique_ptr<NearCorrection> near_;
  double factor_ = 1.0;
};

/// Solves once for all lines.
const Motions& motions_of(Index n, double spacing, Between between) {
  static test::Once<std::tuple<Index, double, Between>, Motions> solved;
  return solved({n, spacing, between}, [&] { return Row(n, spacing, between).motions(); });
}

/// Returns the largest error of a motion, compared with a solution on twice as many nodes with
/// Cauchy integrals between the bodies.
double error_of(Index n, double spacing, Between between) {
  return test::largest(motions_of(n, spacing, between) -
                       motions_of(2 * n, spacing, Between::cauchy));
}

Measure over_nodes(Between between) {
  return [=](Size size) {
    std::vector<Index> counts{32, 48, 64, 96};
    if (size == Size::full) counts.insert(counts.end(), {128, 160});
    std::vector<Measurement> measurements;
    for (const Index n : counts) {
      measurements.push_back({.x = static_cast<double>(n), .error = error_of(n, 1.25, between)});
    }
    return measurements;
  };
}

/// Measures errors on 64 nodes for each body; the spacings range from bodies that nearly touch to
/// distant ones.
Measure over_plain_error(Between between) {
  return [=](Size size) {
    std::vector<double> spacings{2.0, 1.4, 1.3, 1.25, 1.22};
    if (size == Size::full) spacings.insert(spacings.end(), {1.75, 1.5, 1.35, 1.21});
    std::vector<Measurement> measurements;
    for (const double spacing : spacings) {
      measurements.push_back(
          {.x = error_of(64, spacing, Between::plain), .error = error_of(64, spacing, between)});
    }
    std::ranges::sort(measurements, {}, &Measurement::x);
    return measurements;
  };
}

Line beside_line(const std::string& key, const std::string& id, const std::string& label,
                 Between between) {
  return {.key = key,
          .label = label,
          .measure = over_plain_error(between),
          .claim = Claim{.id = id,
                         .statement = "Corrections by " + label +
                                      " never make a row of bodies worse than the trapezoid rule "
                                      "does.",
                         .law = ErrorBelowTolerance{1.1, 0.0},
                         .reason = "the rule's error is replaced by a smaller one; far bodies "
                                   "share the error of the density, and what differs is 1e-8",
                         .api = {"stokesbook::NearCorrection", "stokesbook::NearSettings"}},
          .control = Control{"Cauchy corrections, added twice", over_plain_error(Between::twice)}};
}

constexpr const char* error_text = "largest error of a velocity, or of a turn at unit distance";

}  // namespace

Experiment lobed_bodies() {
  return {
      .key = "lobed",
      .title = "Eight lobed bodies in shear, spacing 1.25",
      .x = "nodes a body N",
      .error = error_text,
      .axes = Axes::semi_log,
      .lines = {
          {.key = "plain", .label = "trapezoid rule", .measure = over_nodes(Between::plain)},
          {.key = "published",
           .label = "interpolation, published parameters",
           .measure = over_nodes(Between::published)},
          {.key = "tolerance",
           .label = "interpolation for 1e-6",
           .measure = over_nodes(Between::tolerance)},
          {.key = "cauchy", .label = "Cauchy integrals", .measure = over_nodes(Between::cauchy)}}};
}

Experiment beside_the_plain_rule() {
  return {.key = "beside",
          .title = "Eight lobed bodies, 64 nodes each, at several spacings",
          .x = "error by the trapezoid rule e",
          .error = error_text,
          .lines = {{.key = "published",
                     .label = "interpolation, published parameters",
                     .measure = over_plain_error(Between::published)},
                    beside_line("tolerance", "06_32", "interpolation for 1e-6", Between::tolerance),
                    beside_line("cauchy", "06_33", "Cauchy integrals", Between::cauchy)}};
}

}  // namespace stokesbook::verification::near_singular
