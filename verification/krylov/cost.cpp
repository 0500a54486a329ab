// Counts the multiplications of a GMRES solve for various numbers of nodes. Compares the count
// k n^2 of GMRES with the count n^3 of a factorisation.
#include <cmath>

#include "experiments.hpp"
#include "support/body_systems.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;

namespace {

std::vector<Index> resolutions(Size size) {
  return size == Size::full ? std::vector<Index>{32, 48, 64, 96, 128}
                            : std::vector<Index>{32, 48, 64, 96};
}

/// Counts multiplications of the dense sums (one product in each iteration, one for the residual)
/// and of the orthogonalisation (four for each entry of each earlier basis vector).
double multiplications(double unknowns, double iterations) {
  return (iterations + 1.0) * unknowns * unknowns + 2.0 * unknowns * iterations * iterations;
}

/// Returns the iterations for nine circles in shear, to the tolerance 1e-12.
double reduced_iterations(Index nodes) {
  const BodySystem system(nine_circles(), nodes, shear);
  return gmres(system.map(), {}, system.rhs(), {1e-12, 500}).iterations;
}

double power_iterations(Index nodes) {
  const BorderedSystem system(nine_circles(), nodes, shear, Between::trapezoid,
                              ClosureForm::power_bordered);
  return gmres(system.map(), {}, system.rhs(), {1e-12, 500}).iterations;
}

template <class Count>
Measure costs(const Count& count) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Index nodes : resolutions(size)) {
      const double unknowns = 18.0 * static_cast<double>(nodes);
      const double operations = count(nodes, unknowns);
      measurements.push_back({.x = static_cast<double>(nodes),
                              .error = operations,
                              .unknowns = unknowns,
                              .operations = operations});
    }
    return measurements;
  };
}

}  // namespace

Experiment costs_of_a_solve() {
  return {.key = "cost",
          .title = "Cost of a solve, nine circles",
          .x = "nodes of a circle, N",
          .error = "multiplications",
          .lines = {{.key = "gmres",
                     .label = "GMRES, reduced form",
                     .measure = costs([](Index nodes, double unknowns) {
                       return multiplications(unknowns, reduced_iterations(nodes));
                     }),
                     .claim = Claim{.id = "05_24",
                                    .statement = "A solve takes a number of multiplications in "
                                                 "proportion to the square of the number of nodes.",
                                    .law = Cost{2.0, 0.1},
                                    .reason = "a number of products that does not grow, N^2 each; "
                                              "the orthogonalisation, linear in N, is small",
                                    .api = {"stokesbook::gmres"}},
                     .control = Control{"Power's border and the plain trapezoid rule",
                                        costs([](Index nodes, double unknowns) {
                                          return multiplications(unknowns, power_iterations(nodes));
                                        })}},
                    {.key = "lu",
                     .label = "LU factorisation",
                     .measure = costs([](Index, double unknowns) {
                       return unknowns * unknowns * unknowns / 3.0;
                     })}},
          .operation = "multiplications"};
}

}  // namespace stokesbook::verification::krylov
