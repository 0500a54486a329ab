// Compares error and work of the fast multipole method, the direct sum, and the near field alone.
#include <algorithm>
#include <chrono>
#include <numbers>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "experiments.hpp"
#include "set_ups.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::verification::fmm {

using namespace study;
using Eigen::Index;

namespace {

/// Returns the direct sum for 256 ellipses with 64 nodes each.
const Summed& sources() {
  static const Summed sum(ellipses(16384));
  return sum;
}

/// Takes the values at every 64th node. At these nodes the reference has more digits than the
/// methods.
ComplexVector sample_of(const ComplexVector& velocity) {
  return velocity(Eigen::seq(0, Eigen::last, 64));
}
const ComplexVector& exact_sample() {
  static const ComplexVector exact = [] {
    using Long = std::complex<long double>;
    const Summed& sum = sources();
    const ComplexVector nodes = all_nodes(sum.curves), targets = sample_of(nodes);
    ComplexVector velocity(targets.size());
    for (Index i = 0; i < targets.size(); ++i) {
      Long total{};
      Index first = 0;
      for (const Curve& curve : sum.curves) {
        const ComplexVector n = normals(curve);
        const Eigen::VectorXd w = weights(curve);
        for (Index j = 0; j < curve.size(); ++j) {
          const Long r = Long(targets[i]) - Long(curve.x[j]);
          const Complex eta = sum.density[first + j];
          const auto dot_r = [&](Complex a) { return r.real() * a.real() + r.imag() * a.imag(); };
          if (r == 0.0L) continue;
          total += w[j] * std::numbers::inv_pi_v<long double> * dot_r(n[j]) * dot_r(eta) /
                   (std::norm(r) * std::norm(r)) * r;
        }
        first += curve.size();
      }
      velocity[i] = Complex(total);
    }
    return velocity;
  }();
  return exact;
}

/// Holds velocities, and the work for them.
struct Found {
  ComplexVector velocity;
  double operations, seconds;
};

template <class Work>
Found timed(double operations, const Work& work) {
  using Clock = std::chrono::steady_clock;
  work();
  const Clock::time_point start = Clock::now();
  ComplexVector velocity = work();
  return {velocity, operations, std::chrono::duration<double>(Clock::now() - start).count()};
}

Found multipoles(int order) {
  const FmmSettings settings = of_order(order);
  const Fmm plan(sources().curves, {}, settings);
  FmmWorkspace work = plan.workspace();
  return timed(operations(plan, order),
               [&]() -> ComplexVector { return plan.velocity(sources().density, work); });
}

Found direct(int) {
  const StressletSum sum(sources().curves);
  const auto n = static_cast<double>(sum.size());
  return timed(n * n, [&] { return sum(sources().density); });
}

/// Sums only the near lists of the plan of a given order.
Found near_field(int order) {
  const Fmm plan(sources().curves, {}, of_order(order));
  const StressletNodes nodes(sources().curves);
  const std::vector<Index>& order_of = plan.sources().order;
  ComplexVector velocity = ComplexVector::Zero(nodes.size());
  double pairs = 0.0;
  const auto add = [&](Index target, Index source) {
    if (source == target) return;
    const Complex r{nodes.x[target] - nodes.x[source], nodes.y[target] - nodes.y[source]};
    velocity[target] += std::numbers::pi * stresslet(r, {nodes.nx[source], nodes.ny[source]},
                                                     sources().density[source]);
  };
  for (std::size_t b = 0; b < plan.targets().boxes.size(); ++b) {
    const Box& box = plan.targets().boxes[b];
    for (const Range range : plan.interactions().near[b]) {
      pairs += static_cast<double>(box.size() * (range.last - range.first));
      for (Index i = box.first; i < box.last; ++i) {
        for (Index j = range.first; j < range.last; ++j) {
          add(order_of[static_cast<std::size_t>(i)], order_of[static_cast<std::size_t>(j)]);
        }
      }
    }
  }
  return {velocity, pairs, unmeasured};
}

using VelocityMethod = Found (*)(int order);

Measure over_orders(VelocityMethod method, int fixed = 0) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (int p = 4; p <= 40; p += size == Size::full ? 2 : 6) {
      const Found found = method(fixed > 0 ? fixed : p);
      measurements.push_back(
          {.x = static_cast<double>(p),
           .error = test::relative_error(sample_of(found.velocity), exact_sample()),
           .operations = found.operations,
           .seconds = found.seconds});
    }
    return measurements;
  };
}

}  // namespace

Experiment work_precision() {
  return {
      .key = "work",
      .title = "16384 nodes on ellipses, by three methods",
      .x = "order p",
      .error = "error of the velocity in the 2-norm, relative",
      .axes = Axes::semi_log,
      .lines = {{.key = "fmm", .label = "multipoles", .measure = over_orders(multipoles)},
                {.key = "direct",
                 .label = "direct sum",
                 .measure = over_orders(direct),
                 .claim = Claim{.id = "08_31",
                                .statement = "The direct sum, with which this study compares, "
                                             "is exact to rounding.",
                                .law = Identity{1e-14},
                                .reason = "16384 terms, each to a few units in the last place, "
                                          "against the same sum in more digits",
                                .api = {"stokesbook::StressletSum"}},
                 .control = Control{"multipoles of order 30", over_orders(multipoles, 30)}},
                {.key = "near", .label = "near lists alone", .measure = over_orders(near_field)}},
      .work_precision = true,
      .operation = "operations in kernel evaluations"};
}

}  // namespace stokesbook::verification::fmm
