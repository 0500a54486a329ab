// Tests the symmetry of the mobility matrix, which is Lorentz' reciprocal theorem (03.15), for
// bodies without symmetry.
#include "experiments.hpp"
#include "support/mobility_matrix.hpp"

namespace stokesbook::verification::closure {

using namespace study;
using namespace test;

namespace {

constexpr double large_gauge = 100.0;

StokesProblem one_body(Eigen::Index n) {
  return {{free_body(lopsided_curve(), n, {{0.3, -0.2}, 0.5})}, 1.3, {}, large_gauge};
}

StokesProblem three_bodies(Eigen::Index n) {
  return {{free_body(lopsided_curve(), n, {{-1.9, 0.2}, 1.0}),
           free_body(Ellipse{1.0, 0.6}, n, {{1.2, 0.9}, 0.4}),
           free_body(Star{0.8, 0.1, 3}, n, {{0.6, -1.9}})},
          1.3,
          {},
          large_gauge};
}

double asymmetry(const Eigen::MatrixXd& mobility) {
  return (mobility - mobility.transpose()).cwiseAbs().maxCoeff() / mobility.cwiseAbs().maxCoeff();
}

Line symmetry_line(const std::string& key, const std::string& id, const std::string& label,
                   StokesProblem (*bodies)(Eigen::Index), ClosureForm form) {
  const std::vector<double> nodes = node_counts(16, 112, 13);
  const auto measure = [=](Complex arm) {
    return at(nodes,
              [=](double x) { return asymmetry(mobility_matrix(bodies(count(x)), form, arm)); });
  };
  return {.key = key,
          .label = label,
          .measure = measure(0.0),
          .claim = Claim{.id = id,
                         .statement = "The mobility matrix is symmetric, once the bodies are "
                                      "resolved.",
                         .law = Identity{1e-13},
                         .window = {.from = 80.0},
                         .reason = "the reciprocal theorem; 1e-13: rounding",
                         .api = {"stokesbook::Closure"}},
          .control = Control{"forces at other points than those whose velocities are taken",
                             measure({0.1, 0.2})}};
}

}  // namespace

Experiment symmetry() {
  return {.key = "symmetry",
          .title = "Symmetry of the mobility matrix",
          .x = "nodes of each body N",
          .error = "largest |M - M^T|, relative to the largest entry",
          .axes = Axes::semi_log,
          .lines = {symmetry_line("one", "03_11", "one body without symmetry", one_body,
                                  ClosureForm::reduced),
                    symmetry_line("three", "03_12", "three bodies", three_bodies,
                                  ClosureForm::scaled_bordered)}};
}

}  // namespace stokesbook::verification::closure
