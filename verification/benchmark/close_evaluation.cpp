// Times velocities close to a curve by the trapezoid sum, the Cauchy scheme and interpolation
// (chapter 06), and the two forms of storing near corrections.
#include "close_evaluation.hpp"

#include <memory>
#include <numbers>

#include <omp.h>

#include "near_singular/near_correction.hpp"
#include "stopwatch.hpp"

namespace stokesbook {

namespace {

using Eigen::Index;

Curve ellipse(Index n) {
  return sample(Ellipse{1.0, 0.5}, n, Side::fluid_outside);
}

// Returns points at a distance of half a node spacing from the curve.
ComplexVector close_points(const Curve& curve, Index count) {
  const Curve places = sample(Ellipse{1.0, 0.5}, count, curve.side);
  const double step = std::numbers::pi / static_cast<double>(curve.size());
  return places.x - step * places.dx.cwiseAbs().cwiseProduct(normals(places));
}

// Returns the least time for each target, in nanoseconds.
template <class Evaluate>
double nanoseconds(const Evaluate& evaluate, Index targets, double budget) {
  return 1e9 * least_seconds(evaluate, budget) / static_cast<double>(targets);
}

double time_interpolation(const Curve& curve, const ComplexVector& density,
                          const ComplexVector& targets, const InterpolationSettings& settings,
                          double budget) {
  const InterpolationCurve scheme(curve, settings);
  const InterpolationData data = scheme.data(density);
  return nanoseconds([&] { return scheme.velocity(data, 0, targets); }, targets.size(), budget);
}

// Returns the seconds that the plan of a near correction and thirty applications take, for each
// curve. The 64 bodies have one shape and share the products of factored storage. The explicit rows
// of 64 bodies exceed the cache.
double time_thirty_applications(const std::shared_ptr<const CauchyCurve>& scheme, Index targets,
                                NearStorage storage, double budget) {
  constexpr Index bodies = 64;
  std::vector<PlacedCurve> placed;
  ComplexVector points(bodies * targets);
  const ComplexVector local = close_points(scheme->curve(), 2 * targets).head(targets);
  for (Index k = 0; k < bodies; ++k) {
    const Complex centre = 10.0 * static_cast<double>(k);
    placed.push_back({scheme, centre, 0.0});
    points.segment(k * targets, targets) = (local.array() + centre).matrix();
  }
  const ComplexVector density = ComplexVector::Ones(bodies * scheme->curve().size());
  const auto work = [&] {
    const NearCorrection near(placed, points, Targets::points, {1e-14, storage});
    Complex sum{};
    for (int application = 0; application < 30; ++application) sum += near(density)[0];
    return sum;
  };
  return least_seconds(work, budget) / static_cast<double>(bodies);
}

// Returns the largest number of targets next to a curve for which NearCorrection stores explicit
// rows by default.
Index most_targets_with_rows(const std::shared_ptr<const CauchyCurve>& scheme) {
  const auto are_kept = [&](Index targets) {
    const ComplexVector points = close_points(scheme->curve(), 2 * targets).head(targets);
    return NearCorrection({{scheme, {}, 0.0}}, points, Targets::points, {}).explicit_count() == 1;
  };
  Index targets = 2;
  while (are_kept(targets)) targets += 2;
  return targets - 2;
}

// Runs the work with one thread, and restores the number of threads.
template <class Work>
void with_one_thread(const Work& work) {
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(1);
  work();
  omp_set_num_threads(threads_before);
}

}  // namespace

Table time_close_evaluation(double budget) {
  Table table{"Close evaluation, ns a target, one thread",
              {"nodes", "plain", "Cauchy", "derivatives", "published", "for 1e-6", "Cauchy/plain",
               "derivs/plain", "publ/Cauchy", "1e-6/Cauchy"},
              {},
              "  bounds, at 128 nodes: Cauchy/plain at most 3, interpolation/Cauchy at least 20",
              "ns a target",
              1,
              5};
  with_one_thread([&] {
    for (const Index n : {64, 128, 256, 512}) {
      const Curve curve = ellipse(n);
      const ComplexVector density = curve.dx, targets = close_points(curve, 1000);
      const StressletSum sum({curve});
      const CauchyCurve cauchy(curve);
      const CauchyData data = cauchy.data(density);
      const CauchyDerivativeData derivative_data = cauchy.derivative_data(data);
      const Index m = targets.size();
      const double plain = nanoseconds([&] { return sum(targets, density); }, m, budget);
      const double velocity =
          nanoseconds([&] { return cauchy.velocity(data, 0, targets); }, m, budget);
      const double derivatives =
          nanoseconds([&] { return cauchy.derivatives(derivative_data, 0, targets); }, m, budget);
      const double published =
          time_interpolation(curve, density, targets, InterpolationSettings::published(n), budget);
      const double six = time_interpolation(curve, density, targets,
                                            InterpolationSettings::for_tolerance(1e-6), budget);
      table.rows.push_back({static_cast<double>(n), plain, velocity, derivatives, published, six,
                            velocity / plain, derivatives / plain, published / velocity,
                            six / velocity});
    }
  });
  return table;
}

Table time_near_storage(double budget) {
  Table table{"Near corrections: time of explicit rows over factored, by targets a curve",
              {"nodes", "8", "16", "24", "32", "48", "64", "kept up to"},
              {},
              "  the plan and thirty applications, 64 bodies of one shape, one thread",
              "time of rows over factored",
              1,
              6};
  with_one_thread([&] {
    for (const Index n : {32, 64, 128, 256}) {
      const auto scheme = std::make_shared<const CauchyCurve>(ellipse(n));
      std::vector<double> row{static_cast<double>(n)};
      for (const Index targets : {8, 16, 24, 32, 48, 64}) {
        const auto seconds = [&](NearStorage storage) {
          return time_thirty_applications(scheme, targets, storage, budget);
        };
        row.push_back(seconds(NearStorage::explicit_rows) / seconds(NearStorage::factored));
      }
      row.push_back(static_cast<double>(most_targets_with_rows(scheme)));
      table.rows.push_back(row);
    }
  });
  return table;
}

}  // namespace stokesbook
