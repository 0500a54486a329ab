// Measures Krylov recycling. Directions of the previous step save iterations in the solve of the
// next step, but these directions require products with the operator.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/dense.hpp"
#include "support/once.hpp"
#include "support/spectra.hpp"
#include "support/touching.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr GmresOptions step_options{1e-8, 500};

/// Returns the operator A M^{-1} on interleaved vectors.
LinearMap preconditioned(const LinearSystem& discrete) {
  return [&discrete](const VectorXd& v) -> VectorXd {
    const VectorXd density = discrete.precondition ? discrete.precondition(v) : v;
    const ComplexVector velocity = discrete.system(deinterleaved(density));
    return interleaved(velocity);
  };
}

/// Computes, by Arnoldi's method, an orthonormal basis of a Krylov space and the matrix H with
/// A V_k = V_{k+1} H (05.3).
struct Arnoldi {
  MatrixXd basis, hessenberg;

  Arnoldi(const LinearMap& apply, const VectorXd& start, Index size)
      : basis(start.size(), size + 1), hessenberg(MatrixXd::Zero(size + 1, size)) {
    basis.col(0) = start.normalized();
    for (Index k = 0; k < size; ++k) {
      VectorXd w = apply(basis.col(k));
      for (int pass = 0; pass < 2; ++pass) {
        const VectorXd overlap = basis.leftCols(k + 1).transpose() * w;
        w -= basis.leftCols(k + 1) * overlap;
        hessenberg.col(k).head(k + 1) += overlap;
      }
      hessenberg(k + 1, k) = w.norm();
      basis.col(k + 1) = w.normalized();
    }
  }
};

/// Returns the harmonic Ritz vectors that belong to the harmonic Ritz values of least modulus. Each
/// complex vector is returned as its real and its imaginary part.
MatrixXd softest_directions(const Arnoldi& arnoldi, Index count) {
  const Index size = arnoldi.hessenberg.cols();
  MatrixXd square = arnoldi.hessenberg.topRows(size);
  const double last = arnoldi.hessenberg(size, size - 1);
  const VectorXd unit = VectorXd::Unit(size, size - 1);
  square += last * last * test::solve(square.transpose(), unit) * unit.transpose();
  const test::Eigenpairs pairs = test::eigenpairs(square);
  std::vector<Index> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](Index i) { return std::abs(pairs.values[i]); });
  MatrixXd chosen(size, 0);
  for (const Index i : order) {
    const Complex value = pairs.values[i];
    if (value.imag() < 0.0) continue;  // the conjugate has the same two parts
    if (chosen.cols() >= count) break;
    const Index parts = value.imag() > 0.0 ? 2 : 1;
    chosen.conservativeResize(Eigen::NoChange, chosen.cols() + parts);
    chosen.col(chosen.cols() - parts) = pairs.vectors.col(i).real();
    if (parts == 2) chosen.rightCols(1) = pairs.vectors.col(i).imag();
  }
  return arnoldi.basis.leftCols(size) * chosen;
}

/// Holds two linear systems on the same nodes: at the start of a scene, and a time dt later.
struct TwoSteps {
  test::Discretised first;
  LinearSystem second;
  GmresResult solved;

  TwoSteps(const Scene& scene, double dt)
      : first(scene),
        second(first.discrete),
        solved(solve(first.discrete, first.discrete.system.right_hand_side(), step_options)) {
    const Completion completion =
        first.discrete.system.closure().complete(deinterleaved(solved.solution));
    Configuration moved = first.configuration;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k].position += dt * completion.motions[k].velocity;
      moved[k].orientation += dt * completion.motions[k].omega;
    }
    second = first.solver.linear_system(first.solver.instant(moved), first.discretisation);
  }

  /// Returns the number of products with the operator, including the products for the recycled
  /// directions.
  double products(Index recycled) const {
    const ComplexVector data = second.system.right_hand_side();
    const VectorXd rhs = interleaved(data), old = solved.solution;
    const ComplexVector of_old = second.system(deinterleaved(old));
    const VectorXd rest = rhs - interleaved(of_old);
    const LinearMap apply = preconditioned(second);
    // All solves begin with the density of the earlier step, and GMRES measures its tolerance
    // relative to the residual of this density.
    const double tolerance = step_options.tolerance * rhs.norm() / rest.norm();
    if (recycled == 0) return gmres(apply, {}, rest, {tolerance, 500}).iterations;
    const ComplexVector earlier = first.discrete.system.right_hand_side();
    const Arnoldi arnoldi(preconditioned(first.discrete), interleaved(earlier), solved.iterations);
    const MatrixXd directions = softest_directions(arnoldi, recycled);
    MatrixXd images(directions.rows(), directions.cols());
    for (Index j = 0; j < images.cols(); ++j) images.col(j) = apply(directions.col(j));
    const MatrixXd range = test::orthogonal_factor(images);
    const auto outside = [&](const VectorXd& v) -> VectorXd {
      return v - range * (range.transpose() * v);
    };
    const LinearMap deflated = [&](const VectorXd& v) { return outside(apply(v)); };
    const VectorXd left = outside(rest);
    const double scaled = tolerance * rest.norm() / left.norm();
    return gmres(deflated, {}, left, {scaled, 500}).iterations + static_cast<double>(images.cols());
  }
};

struct RecyclingCase {
  std::string key, label;
  Scene scene;
  double dt;
};

std::vector<RecyclingCase> cases() {
  using enum PreconditionerKind;
  return {{"ellipses", "48 ellipses in vortices, block-diagonal",
           test::with_preconditioner(test::ellipses_in_vortices(), block_diagonal), 0.025},
          {"packing", "40 disks at random, no preconditioner",
           test::with_preconditioner(test::disk_packing(40), none), 0.02},
          {"clusters", "40 disks at random, clusters",
           test::with_preconditioner(test::disk_packing(40), clusters), 0.02}};
}

Measure products(const RecyclingCase& one) {
  return [=](Size) {
    static test::Once<std::string, std::vector<Measurement>> measured;
    return measured(one.key, [&] {
      const TwoSteps steps(one.scene, one.dt);
      std::vector<Measurement> measurements;
      for (const Index recycled : {0, 2, 4, 8}) {
        measurements.push_back(
            {.x = static_cast<double>(recycled) + 1.0, .error = steps.products(recycled)});
      }
      return measurements;
    });
  };
}

}  // namespace

Experiment recycling() {
  std::vector<Line> lines;
  for (const RecyclingCase& one : cases()) {
    lines.push_back({.key = one.key, .label = one.label, .measure = products(one)});
  }
  return {.key = "recycling",
          .title = "Products with directions that the previous step supplies",
          .x = "number of directions plus one, k",
          .error = "products with the operator, to 1e-8",
          .lines = std::move(lines)};
}

}  // namespace stokesbook::verification::preconditioning
