// Times the fast multipole sum (chapter 08) relative to the direct sum, by tolerance and by the
// number of nodes.
#include "fast_sum.hpp"

#include <cmath>

#include <omp.h>

#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "stopwatch.hpp"

namespace stokesbook {

namespace {

using Eigen::Index;

// Returns ellipses 2:1 in a square array, at various angles.
std::vector<Curve> array_of_ellipses(int bodies, Index n) {
  const Curve ellipse = sample(Ellipse{1.0, 0.5}, n, Side::fluid_outside);
  const int side = static_cast<int>(std::ceil(std::sqrt(bodies)));
  std::vector<Curve> curves;
  for (int k = 0; k < bodies; ++k) {
    const Complex centre{2.5 * (k % side), 2.5 * (k / side)};
    curves.push_back(place(ellipse, centre, 0.1 * k * k));
  }
  return curves;
}

Eigen::MatrixXcd densities(Index nodes, Index fields) {
  Eigen::MatrixXcd density(nodes, fields);
  for (Index field = 0; field < fields; ++field) {
    for (Index j = 0; j < nodes; ++j) {
      density(j, field) = std::polar(1.0, 0.05 * static_cast<double>(j * (field + 1)));
    }
  }
  return density;
}

template <class Work>
double seconds_with(int threads, const Work& work, double budget) {
  const int threads_before = omp_get_max_threads();
  omp_set_num_threads(threads);
  const double seconds = least_seconds(work, budget);
  omp_set_num_threads(threads_before);
  return seconds;
}

// Returns the seconds of the direct sum at all nodes, extrapolated from the sum at some targets.
double seconds_of_direct_sum(const std::vector<Curve>& curves, const ComplexVector& density,
                             double budget) {
  const StressletSum sum(curves);
  const ComplexVector targets = curves[0].x.replicate(16, 1);
  return seconds_with(
             1, [&] { return sum(targets, density); }, budget) *
         static_cast<double>(density.size()) / static_cast<double>(targets.size());
}

double seconds_of_application(const Fmm& fmm, int fields, int threads, double budget) {
  const Eigen::MatrixXcd density = densities(fmm.sources().size(), fields);
  FmmWorkspace work = fmm.workspace(fields);
  return seconds_with(
      threads, [&] { fmm.velocity(density, work); }, budget);
}

}  // namespace

Table time_fast_sum(int bodies, double budget) {
  const std::vector<Curve> curves = array_of_ellipses(bodies, 128);
  const Index nodes = 128 * static_cast<Index>(bodies);
  const double direct = seconds_of_direct_sum(curves, densities(nodes, 1), budget);
  Table table{
      "Fast multipole sum of " + std::to_string(nodes) + " nodes, by the tolerance",
      {"tolerance", "order", "ms", "direct/FMM", "plan/FMM", "2 fields", "4 fields", "two threads"},
      {},
      "  all columns but the last are for one thread; the last is the speed of two threads over\n"
      "  that of one;\n"
      "  fields: time of several fields at once over that of as many applications;\n"
      "  bounds for 1e5 nodes: direct/FMM at least 100 for 1e-6 and 60 for 1e-12, plan/FMM at "
      "most 1 for 1e-6",
      "times as fast as the direct sum",
      3,
      3};
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const FmmSettings settings = FmmSettings::for_tolerance(tolerance);
    const double plan = seconds_with(
        1, [&] { return Fmm(curves, {}, settings); }, budget);
    const Fmm fmm(curves, {}, settings);
    const double one = seconds_of_application(fmm, 1, 1, budget);
    table.rows.push_back({tolerance, static_cast<double>(settings.order), 1e3 * one, direct / one,
                          plan / one, seconds_of_application(fmm, 2, 1, budget) / (2.0 * one),
                          seconds_of_application(fmm, 4, 1, budget) / (4.0 * one),
                          one / seconds_of_application(fmm, 1, 2, budget)});
  }
  return table;
}

Table time_break_even(double budget) {
  Table table{"Fast multipole sum of few nodes: its time over the direct sum's, one thread",
              {"nodes", "1e-3", "1e-6", "1e-9", "1e-12"},
              {},
              "  break_even() returns",
              "time over the direct sum's",
              1,
              4};
  const std::vector<double> tolerances{1e-3, 1e-6, 1e-9, 1e-12};
  for (const Index nodes : {256, 384, 512, 640, 768, 896, 1024, 1536, 2048}) {
    const std::vector<Curve> curves = array_of_ellipses(static_cast<int>(nodes) / 32, 32);
    const StressletSum sum(curves);
    const ComplexVector density = densities(nodes, 1);
    const double direct = seconds_with(
        1, [&] { return sum(density); }, budget);
    std::vector<double> row{static_cast<double>(nodes)};
    for (const double tolerance : tolerances) {
      const Fmm fmm(curves, {}, FmmSettings::for_tolerance(tolerance));
      row.push_back(seconds_of_application(fmm, 1, 1, budget) / direct);
    }
    table.rows.push_back(row);
  }
  for (const double tolerance : tolerances) {
    table.note += ' ';
    table.note += std::to_string(break_even(FmmSettings::for_tolerance(tolerance)));
  }
  return table;
}

}  // namespace stokesbook
