// Eight lobed bodies in shear: what the scheme between bodies does to their motions.
#include <algorithm>
#include <map>
#include <memory>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "set_ups.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

enum class Between { plain, published, tolerance, cauchy };

CloseScheme scheme_of(const Curve& curve, Between between) {
  if (between == Between::cauchy) return std::make_shared<const CauchyCurve>(curve);
  return std::make_shared<const InterpolationCurve>(
      curve, between == Between::published ? InterpolationSettings::published(curve.size())
                                           : InterpolationSettings::for_tolerance(1e-6));
}

/// Velocity at the centroid, and the turn at the mean radius, of each body.
using Motions = ComplexVector;

/// Free bodies r = (1 + cos(k t)/5)/2, k = 2, 3, 4, 5, 5, 4, 3, 2, in a row with the spacing 5/4, in
/// the shear flow (y, 0). The gaps are 0.05 and 0.25.
class Row {
 public:
  Row(Index n, Between between) : n_(n) {
    std::vector<PlacedCurve> placed;
    Complex centre{};
    for (const int arms : {2, 3, 4, 5, 5, 4, 3, 2}) {
      const Curve curve = sample(Star{0.5, 0.2, arms}, n, Side::fluid_outside);
      curves_.push_back(place(curve, centre, 0.0));
      placed.push_back({scheme_of(curve, between), centre, 0.0});
      centre += 1.25;
    }
    sum_ = std::make_unique<StressletSum>(curves_);
    if (between == Between::plain) return;
    near_ =
        std::make_unique<NearCorrection>(placed, nodes(), Targets::own_nodes, NearSettings{1e-8});
  }

  /// Solves (-1/2 + D - P) eta = -u, P eta the mean rigid motion: the velocity on a body is P eta.
  Motions motions() const {
    const ComplexVector flow = nodes().imag().cast<Complex>();
    const auto map = [this](const Eigen::VectorXd& v) -> Eigen::VectorXd {
      const ComplexVector density = deinterleaved(v);
      return interleaved(apply(density)).eval();
    };
    const ComplexVector rhs = -flow;
    const GmresResult result = gmres(map, {}, interleaved(rhs), {1e-12, 300});
    return means(deinterleaved(result.solution));
  }

 private:
  ComplexVector nodes() const {
    ComplexVector x(n_ * std::ssize(curves_));
    for (Index k = 0; k < std::ssize(curves_); ++k) x.segment(n_ * k, n_) = curve(k).x;
    return x;
  }
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
    if (near_) velocity += (*near_)(density);
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
};

/// Largest error of a motion.
double error_of(Index n, Between between) {
  static const Motions exact = Row(256, Between::cauchy).motions();
  static std::map<std::pair<Index, Between>, double> known;
  const auto [entry, is_new] = known.try_emplace({n, between}, 0.0);
  if (is_new) entry->second = test::largest(Row(n, between).motions() - exact);
  return entry->second;
}

std::vector<Index> counts(Size size) {
  return size == Size::full ? std::vector<Index>{32, 48, 64, 80, 96, 112, 128, 160}
                            : std::vector<Index>{32, 48, 64, 96, 128};
}

Measure over_nodes(Between between) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Index n : counts(size)) {
      measurements.push_back({.x = static_cast<double>(n), .error = error_of(n, between)});
    }
    return measurements;
  };
}

Measure over_plain_error(Between between) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Index n : counts(size)) {
      measurements.push_back({.x = error_of(n, Between::plain), .error = error_of(n, between)});
    }
    std::ranges::sort(measurements, {}, &Measurement::x);
    return measurements;
  };
}

constexpr const char* error_text = "largest error of a velocity, or of a turn at unit distance";

}  // namespace

Experiment lobed_bodies() {
  return {
      .key = "lobed",
      .title = "Eight lobed bodies in shear",
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
          .title = "Eight lobed bodies: beside the trapezoid rule",
          .x = "error by the trapezoid rule e",
          .error = error_text,
          .lines = {{.key = "published",
                     .label = "interpolation, published parameters",
                     .measure = over_plain_error(Between::published)},
                    {.key = "tolerance",
                     .label = "interpolation for 1e-6",
                     .measure = over_plain_error(Between::tolerance)},
                    {.key = "cauchy",
                     .label = "Cauchy integrals",
                     .measure = over_plain_error(Between::cauchy)}}};
}

}  // namespace stokesbook::verification::near_singular
