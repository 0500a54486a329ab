// Tests near corrections inside a sum over the nodes of two bodies, at gaps down to 1e-8.
#include <memory>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "near_singular/near_correction.hpp"
#include "set_ups.hpp"
#include "support/plain_rule.hpp"

namespace stokesbook::verification::near_singular {

using namespace study;
using Eigen::Index;

namespace {

/// Holds two circles with nodes that face each other across a gap, at an arbitrary place and angle.
/// Each circle has the density of a flow that is singular inside it.
class Pair {
 public:
  explicit Pair(double gap) {
    add(Circle{1.0}, 96, {0.4, -0.7}, direction);
    add(Circle{0.5}, 64, Complex{0.4, -0.7} + std::polar(1.5 + gap, direction),
        direction + std::numbers::pi);
  }

  const std::vector<Curve>& curves() const { return curves_; }
  ComplexVector nodes() const { return all_nodes(curves_); }
  const ComplexVector& density() const { return density_; }
  Complex frame(std::size_t k) const { return std::polar(1.0, orientations_[k]); }
  Complex centre(std::size_t k) const { return centres_[k]; }
  Curve reference(std::size_t k) const { return schemes_[k]->curve(); }

  /// Returns the density of body k in the body's own frame.
  ComplexVector local_density(std::size_t k) const {
    return std::conj(frame(k)) * density_.segment(k == 0 ? 0 : 96, curves_[k].size());
  }

  std::vector<PlacedCurve> placed(bool by_interpolation) const {
    std::vector<PlacedCurve> result;
    for (std::size_t k : {0, 1}) {
      CloseScheme scheme = schemes_[k];
      if (by_interpolation) {
        scheme = std::make_shared<const InterpolationCurve>(
            schemes_[k]->curve(), InterpolationSettings::for_tolerance(1e-6));
      }
      result.push_back({scheme, centres_[k], orientations_[k]});
    }
    return result;
  }

  /// Returns the largest error of a sum at the nodes, relative to the flow. `sum` excludes the
  /// principal values on the bodies themselves.
  double error(const ComplexVector& sum) const {
    const ComplexVector exact = flow_.velocity(nodes());
    ComplexVector velocity = sum - 0.5 * density_;
    velocity.head(96) += diagonal_velocity(curves_[0], density_.head(96));
    velocity.tail(64) += diagonal_velocity(curves_[1], density_.tail(64));
    return test::largest(velocity - exact) / test::largest(exact);
  }

 private:
  static constexpr double direction = 0.3;

  void add(const Shape& shape, Index n, Complex centre, double orientation) {
    const Curve reference = sample(shape, n, Side::fluid_outside);
    schemes_.push_back(std::make_shared<const CauchyCurve>(reference));
    centres_.push_back(centre);
    orientations_.push_back(orientation);
    curves_.push_back(place(reference, centre, orientation));
    const test::Pole pole{centre + 0.1 * Complex{0.6, -0.3}, {0.2, -0.1}, 0.3};
    flow_.poles.push_back(pole);
    const Curve& curve = curves_.back();
    density_.conservativeResize(density_.size() + n);
    density_.tail(n) = test::density_of(curve, test::ExactFlow{{pole}}.velocity(curve.x));
  }

  std::vector<std::shared_ptr<const CauchyCurve>> schemes_;
  std::vector<Complex> centres_;
  std::vector<double> orientations_;
  std::vector<Curve> curves_;
  ComplexVector density_;
  test::ExactFlow flow_;
};

ComplexVector plain(const Pair& pair) {
  return StressletSum(pair.curves())(pair.density());
}

ComplexVector corrected(const Pair& pair, bool by_interpolation, NearStorage storage) {
  const NearCorrection near(pair.placed(by_interpolation), pair.nodes(), Targets::own_nodes,
                            {1e-14, storage});
  return plain(pair) + near(pair.density());
}

ComplexVector factored(const Pair& pair) {
  return corrected(pair, false, NearStorage::factored);
}
ComplexVector by_rows(const Pair& pair) {
  return corrected(pair, false, NearStorage::explicit_rows);
}
ComplexVector by_interpolation(const Pair& pair) {
  return corrected(pair, true, NearStorage::explicit_rows);
}

/// A planted defect: the kernel has no bound on small distances. The sum and the subtraction round
/// their distances in different frames.
ComplexVector unbounded(const Pair& pair) {
  ComplexVector velocity = plain(pair);  // sum of each body on itself; the other part is replaced
  for (std::size_t source : {0, 1}) {
    const std::size_t target = 1 - source;
    const ComplexVector& x = pair.curves()[target].x;
    const ComplexVector density = pair.frame(source) * pair.local_density(source);
    const ComplexVector local =
        std::conj(pair.frame(source)) * (x.array() - pair.centre(source)).matrix();
    const Curve reference = pair.reference(source);
    const CauchyCurve cauchy(reference);
    const ComplexVector correction =
        cauchy.velocity(cauchy.data(pair.local_density(source)), 0, local) -
        test::plain_rule(reference, pair.local_density(source), local);
    velocity.segment(target == 0 ? 0 : 96, x.size()) +=
        test::plain_rule(pair.curves()[source], density, x) -
        StressletSum({pair.curves()[source]})(x, density) + pair.frame(source) * correction;
  }
  return velocity;
}

/// A planted defect: only the first body is corrected.
ComplexVector first_only(const Pair& pair) {
  const NearCorrection near({pair.placed(false).front()}, pair.curves()[1].x, Targets::points,
                            {1e-14});
  ComplexVector velocity = plain(pair);
  velocity.tail(64) += near(pair.density().head(96));
  return velocity;
}

using Sum = ComplexVector (*)(const Pair&);

Measure errors_over_gaps(Sum sum) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    const double factor = size == Size::full ? std::sqrt(10.0) : 10.0;
    for (double gap = 1e-8; gap < 0.3; gap *= factor) {
      const Pair pair(gap);
      measurements.push_back({.x = gap, .error = pair.error(sum(pair))});
    }
    return measurements;
  };
}

Claim independent_of_the_gap(const std::string& id, const std::string& how) {
  return {.id = id,
          .statement = "A sum over two bodies with near corrections " + how +
                       " is exact to 1e-12 at every gap.",
          .law = Identity{1e-12},
          .reason = "what is subtracted again is bounded by the density, as rho >= w/2",
          .api = {"stokesbook::NearCorrection", "stokesbook::StressletSum",
                  "stokesbook::find_near_targets"}};
}

}  // namespace

Experiment pairs() {
  return {.key = "pairs",
          .title = "The sum over the nodes of two circles",
          .x = "gap g",
          .error = "error of the velocity at the nodes, relative to the largest",
          .lines = {
              {.key = "plain", .label = "trapezoid rule", .measure = errors_over_gaps(plain)},
              {.key = "factored",
               .label = "Cauchy corrections, factored",
               .measure = errors_over_gaps(factored),
               .claim = independent_of_the_gap("06_30", "that are evaluated anew"),
               .control = Control{"a kernel that is not bounded", errors_over_gaps(unbounded)}},
              {.key = "rows",
               .label = "Cauchy corrections, rows",
               .measure = errors_over_gaps(by_rows),
               .claim = independent_of_the_gap("06_31", "that are kept as rows"),
               .control = Control{"one of the two bodies corrected", errors_over_gaps(first_only)}},
              {.key = "interpolation",
               .label = "corrections by interpolation for 1e-6",
               .measure = errors_over_gaps(by_interpolation)},
              {.key = "unbounded",
               .label = "Cauchy corrections of an unbounded kernel",
               .measure = errors_over_gaps(unbounded)}}};
}

}  // namespace stokesbook::verification::near_singular
