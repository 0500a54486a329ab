// Preconditioning by clusters: iterations asked and needed, what they cost, and how they grow.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiments.hpp"
#include "support/once.hpp"
#include "touching.hpp"

namespace stokesbook::verification::krylov {

using namespace study;

namespace {

using Kind = PreconditionerKind;

/// A scene at a place on the x axis, and whether a quick study leaves it out.
struct Case {
  double x;
  std::string name;
  std::function<Scene()> scene;
  bool full_only = false;
};

const Effort& effort_of(const Case& of, Kind preconditioner) {
  static test::Once<std::pair<std::string, Kind>, Effort> efforts;
  return efforts({of.name, preconditioner}, [&] { return effort(of.scene(), preconditioner); });
}

Measure measured(const std::vector<Case>& cases, Kind preconditioner, double Effort::*quantity) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Case& one : cases) {
      if (one.full_only && size == Size::quick) continue;
      const Effort& needed = effort_of(one, preconditioner);
      measurements.push_back({.x = one.x, .error = needed.*quantity, .unknowns = needed.unknowns});
    }
    return measurements;
  };
}

Measure counts(const std::vector<Case>& cases, Kind preconditioner) {
  return measured(cases, preconditioner, &Effort::iterations);
}

Case hexagon_of_seven(double x, double gap, bool full_only = false) {
  return {x, "7 " + std::to_string(gap), [=] { return disk_hexagon(1, gap); }, full_only};
}

std::vector<Case> by_asked_iterations() {
  return {{12, "chain", [] { return disk_chain(1e-3); }},
          {15, "ellipses", ellipses_in_vortices},
          hexagon_of_seven(20, 1e-2),
          hexagon_of_seven(30, 1e-3),
          {35, "19", [] { return disk_hexagon(2, 1e-2); }, true}};
}

std::vector<Case> by_gap(double least_in_quick = 1e-3) {
  std::vector<Case> cases;
  for (const double gap : {1e-4, 1e-3, 1e-2, 3e-2, 1e-1}) {
    cases.push_back(hexagon_of_seven(gap, gap, gap < least_in_quick));
  }
  return cases;
}

std::vector<Case> by_disks() {
  std::vector<Case> cases;
  for (const int count : {20, 40, 60, 150, 400, 1000}) {
    cases.push_back({static_cast<double>(count), "random " + std::to_string(count),
                     [=] { return disk_packing(count); }, count > 60});
  }
  return cases;
}

}  // namespace

Experiment asked_iterations() {
  return {.key = "asked",
          .title = "Iterations asked and needed",
          .x = "iterations asked, m",
          .error = "iterations to a residual of 1e-8",
          .lines = {
              {.key = "clusters",
               .label = "clusters",
               .measure = counts(by_asked_iterations(), Kind::clusters),
               .claim = Claim{.id = "05_26",
                              .statement =
                                  "Clusters solve bodies that nearly touch in no more iterations "
                                  "than was asked: 12 for a chain of five disks with gaps of "
                                  "0.001, 15 for 48 ellipses in vortices, 20 and 30 for a hexagon "
                                  "of seven disks with gaps of 0.01 and 0.001, 35 for one of 19 "
                                  "with gaps of 0.01 (the last in a full study).",
                              .law = ErrorBelowTolerance{1.0, 0.1},
                              .reason = "asked before the method was chosen, from what near-field "
                                        "factorisations reach on the same bodies",
                              .api = {"stokesbook::ClusterPreconditioner"}},
               .control = Control{"every component alone",
                                  counts(by_asked_iterations(), Kind::block_diagonal)}},
              {.key = "blocks",
               .label = "block-diagonal",
               .measure = counts(by_asked_iterations(), Kind::block_diagonal)}}};
}

Experiment contact_iterations() {
  return {
      .key = "contact",
      .title = "Iterations for a hexagon of seven disks",
      .x = "gap, in radii, g",
      .error = "iterations to a residual of 1e-8",
      .lines = {
          {.key = "blocks",
           .label = "block-diagonal",
           .measure = counts(by_gap(), Kind::block_diagonal)},
          {.key = "clusters", .label = "clusters", .measure = counts(by_gap(), Kind::clusters)}}};
}

Experiment contact_seconds() {
  return {.key = "seconds",
          .title = "Time to the solution for a hexagon of seven disks, on one machine",
          .x = "gap, in radii, g",
          .error = "seconds, set-up and iteration",
          .lines = {{.key = "none",
                     .label = "no preconditioner",
                     .measure = measured(by_gap(1e-2), Kind::none, &Effort::seconds)},
                    {.key = "blocks",
                     .label = "block-diagonal",
                     .measure = measured(by_gap(), Kind::block_diagonal, &Effort::seconds)},
                    {.key = "clusters",
                     .label = "clusters",
                     .measure = measured(by_gap(), Kind::clusters, &Effort::seconds)}}};
}

Experiment packings() {
  return {
      .key = "packings",
      .title = "Iterations for random packings of disks, area fraction 0.6",
      .x = "number of disks P",
      .error = "iterations to a residual of 1e-8",
      .lines = {
          {.key = "blocks",
           .label = "block-diagonal",
           .measure = counts(by_disks(), Kind::block_diagonal)},
          {.key = "clusters", .label = "clusters", .measure = counts(by_disks(), Kind::clusters)}}};
}

}  // namespace stokesbook::verification::krylov
