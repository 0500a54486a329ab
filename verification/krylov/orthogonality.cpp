// Measures the loss of orthogonality of the basis after one and two passes of Gram-Schmidt, on two
// circles that nearly touch.
#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "support/body_systems.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr int basis_size = 60;

BodySystem nearly_touching() {
  constexpr double gap = 1e-3;
  constexpr Index nodes = 256;
  return BodySystem(circle_pair(gap), nodes, generic_flow);
}

/// Records the library's basis: the vectors to which GMRES applies the operator.
MatrixXd basis_of_library() {
  const BodySystem system = nearly_touching();
  MatrixXd basis(system.size(), basis_size + 1);
  Index column = 0;
  const LinearMap observed = [&](const VectorXd& v) {
    basis.col(column++) = v;
    return system.apply(v);
  };
  gmres(observed, {}, system.rhs(), {0.0, basis_size});
  return basis.leftCols(basis_size);  // the last vector is the solution, for its residual
}

/// Applies the classical Gram-Schmidt method, in which all projections use the same vector w.
void classical(const MatrixXd& basis, VectorXd& w) {
  w -= basis * (basis.transpose() * w);
}

/// Applies the modified Gram-Schmidt method, in which each projection uses the remainder of the
/// previous projection.
void modified(const MatrixXd& basis, VectorXd& w) {
  for (Index i = 0; i < basis.cols(); ++i) w -= basis.col(i).dot(w) * basis.col(i);
}

template <class Orthogonalise>
MatrixXd basis_by(const Orthogonalise& orthogonalise) {
  const BodySystem system = nearly_touching();
  MatrixXd basis(system.size(), basis_size);
  basis.col(0) = system.rhs().normalized();
  for (Index k = 1; k < basis_size; ++k) {
    VectorXd w = system.apply(basis.col(k - 1));
    orthogonalise(basis.leftCols(k), w);
    basis.col(k) = w.normalized();
  }
  return basis;
}

/// Returns the largest entry of |V^T V - I| for the first k columns of the basis V.
std::vector<Measurement> loss(const MatrixXd& basis) {
  const MatrixXd defect =
      (basis.transpose() * basis - MatrixXd::Identity(basis.cols(), basis.cols())).cwiseAbs();
  std::vector<Measurement> measurements;
  for (Index k = 2; k <= basis.cols(); k += 2) {
    measurements.push_back(
        {.x = static_cast<double>(k), .error = defect.topLeftCorner(k, k).maxCoeff()});
  }
  return measurements;
}

template <class Orthogonalise>
Measure loss_by(const Orthogonalise& orthogonalise) {
  return [=](Size) { return loss(basis_by(orthogonalise)); };
}

}  // namespace

Experiment orthogonality() {
  return {
      .key = "orthogonality",
      .title = "Orthogonality of the basis",
      .x = "iterations k",
      .error = "largest entry of V^T V - I",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "twice",
           .label = "classical, twice (the library)",
           .measure = [](Size) { return loss(basis_of_library()); },
           .claim = Claim{.id = "05_6",
                          .statement =
                              "A basis that is orthogonalised twice stays orthogonal to rounding.",
                          .law = Identity{1e-14},
                          .reason = "the second pass starts from a vector that is nearly "
                                    "orthogonal already, and so loses nothing to "
                                    "cancellation; 1e-14: 60 rounding units",
                          .api = {"stokesbook::gmres"}},
           .control = Control{"classical, once", loss_by(classical)}},
          {.key = "classical", .label = "classical, once", .measure = loss_by(classical)},
          {.key = "modified", .label = "modified, once", .measure = loss_by(modified)}}};
}

}  // namespace stokesbook::verification::krylov
