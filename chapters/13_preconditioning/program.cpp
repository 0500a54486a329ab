// Chapter 13: a row of four disks whose gaps close; GMRES without preconditioner, with the blocks of
// single bodies, and with clusters of bodies.
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "closure/closure.hpp"
#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/cauchy.hpp"
#include "preconditioning/cluster_preconditioner.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::size_t disk_count = 4;

// [row]
// A row of unit disks in the flow (y, x), with enough nodes for the gap.
struct Row {
  double gap;
  CauchyCurve disk;  // evaluates the double layer of a disk at any distance (chapter 06)
  StokesProblem problem;

  explicit Row(double g) : gap(g), disk(sample(Circle{1.0}, nodes(), Side::fluid_outside)) {
    for (std::size_t k = 0; k < disk_count; ++k) {
      const Complex centre = (2.0 + g) * std::polar(static_cast<double>(k), 0.3);
      const Curve curve = place(disk.curve(), centre, 0.0);
      problem.components.push_back({ComponentKind::free_body, curve, centre, {}, 0.0, {}});
    }
    problem.background = imaginary * all_nodes(curves_of(problem)).conjugate();
  }

  // Resolves densities with modes exp(-alpha |k|), cosh alpha = 1 + gap / 2.
  Index nodes() const {
    return 2 * static_cast<Index>(std::ceil(8.0 + 9.0 / std::acosh(1.0 + 0.5 * gap)));
  }
  // The double layer of one disk at nodes of other disks.
  MatrixXd layer(const ComplexVector& targets, std::size_t source) const {
    return disk.velocity_rows(targets.array() - problem.components[source].centre);
  }
};
// [row]

// [system]
// The reduced system of free bodies: own blocks, and D (I - P) between different bodies.
MatrixXd reduced_matrix(const Row& row) {
  const Index size = 2 * row.nodes();
  MatrixXd matrix(size * disk_count, size * disk_count);
  for (std::size_t source = 0; source < disk_count; ++source) {
    const Component& own = row.problem.components[source];
    const RigidModeMatrices rigid = rigid_mode_matrices(own.curve, own.centre);
    for (std::size_t target = 0; target < disk_count; ++target) {
      auto block = matrix.block(size * static_cast<Index>(target),
                                size * static_cast<Index>(source), size, size);
      if (target == source) {
        block = self_block(own);
      } else {
        const MatrixXd layer = row.layer(row.problem.components[target].curve.x, source);
        block = layer - (layer * rigid.modes) * rigid.projection;
      }
    }
  }
  return matrix;
}
// [system]

// [clusters]
// Each disk with its neighbours in the row. Their gap, over their radius, sets the compression.
ClusterPreconditioner clusters(const Row& row, ClusterForm form) {
  const MatrixXd block = cluster_block(row.problem.components[0], form, held_gauge(row.problem));
  const auto inverse = std::make_shared<const MatrixXd>(invert_block(block));
  std::vector<std::vector<Neighbour>> neighbours(disk_count);
  for (std::size_t k = 0; k + 1 < disk_count; ++k) {
    neighbours[k].push_back({k + 1, row.gap});
    neighbours[k + 1].push_back({k, row.gap});
  }
  return {row.problem, form,
          std::vector(disk_count, BlockDiagonalPreconditioner::Member{inverse, 0.0}), neighbours,
          [&row](const ComplexVector& targets, std::size_t source) {
            return row.layer(targets, source);
          }};
}
// [clusters]

BlockDiagonalPreconditioner single_bodies(const Row& row) {
  const MatrixXd block = self_block(row.problem.components[0]);
  const auto inverse = std::make_shared<const MatrixXd>(invert_block(block));
  return BlockDiagonalPreconditioner(
      std::vector(disk_count, BlockDiagonalPreconditioner::Member{inverse, 0.0}));
}

}  // namespace

int main() {
  std::puts("Iterations of GMRES to a residual of 1e-8, a row of four disks\n");
  std::puts("    gap    nodes     none  single bodies  free clusters  held clusters");
  // [solve]
  for (const double gap : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01}) {
    const Row row(gap);
    const MatrixXd matrix = reduced_matrix(row);
    const ComplexVector data = Closure(row.problem).right_hand_side();
    const auto iterations = [&](const LinearMap& precondition) {
      return gmres([&](const VectorXd& v) -> VectorXd { return matrix * v; }, precondition,
                   interleaved(data), {.tolerance = 1e-8})
          .iterations;
    };
    std::printf("%7g %8td %8d %14d %14d %14d\n", gap, row.nodes(), iterations({}),
                iterations(single_bodies(row)), iterations(clusters(row, ClusterForm::mobility)),
                iterations(clusters(row, ClusterForm::resistance)));
  }
  // [solve]
}
