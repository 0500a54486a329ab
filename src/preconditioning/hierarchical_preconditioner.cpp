// Eliminates components, then groups of components in a tree, each up to the few directions in
// which it is coupled to all others (13.7), (13.8). Couplings are blocks between near groups, and
// multipole expansions between all others.
#include "preconditioning/hierarchical_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "preconditioning/boundary_pieces.hpp"
#include "preconditioning/component_tree.hpp"
#include "preconditioning/far_field.hpp"
#include "preconditioning/large_problems.hpp"
#include "preconditioning/tree_level.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace {

using Member = BlockDiagonalPreconditioner::Member;

// The tolerance of groups falls by this factor from level to level: the larger a group is, the
// softer are the motions in which its errors show.
constexpr double tolerance_fall = 0.6;
// Where it ends: below, rounding in single precision costs more iterations than it saves.
constexpr double least_tolerance = 0.06;

Eigen::Matrix2f rotation(double angle) {
  return Eigen::Rotation2Df(static_cast<float>(angle)).toRotationMatrix();
}

Index unknowns_of(const std::vector<ReducedGroup>& groups) {
  Index sum = 0;
  for (const ReducedGroup& group : groups) sum += group.width();
  return sum;
}

// Sorts the pieces into the order of a tree.
std::vector<BoundaryPiece> in_order(std::vector<BoundaryPiece> pieces,
                                    const std::vector<Index>& order) {
  std::vector<BoundaryPiece> ordered;
  for (const Index k : order) ordered.push_back(std::move(pieces[static_cast<std::size_t>(k)]));
  return ordered;
}

}  // namespace

HierarchicalPreconditioner::HierarchicalPreconditioner(const StokesProblem& problem,
                                                       std::vector<Member> alone,
                                                       const LayerBlock& layer,
                                                       const HierarchySettings& settings) {
  std::vector<BoundaryPiece> pieces = boundary_pieces(problem, alone);
  alone.clear();  // only the rounded inverses are needed from here on
  if (pieces.empty()) return;
  const auto arcs = std::ranges::count_if(pieces, &BoundaryPiece::is_arc);
  std::vector<Box> disks;
  for (const BoundaryPiece& piece : pieces) disks.push_back(piece.disk);
  const ComponentTree tree(disks);
  pieces = in_order(std::move(pieces), tree.order);
  const std::vector<Index> offsets = node_offsets(problem);
  const bool is_large = stokesbook::is_large(offsets.back());
  std::map<const MatrixXf*, std::shared_ptr<const CompactMatrix>> compact;
  for (const BoundaryPiece& piece : pieces) {
    auto& inverse = compact[piece.inverse.get()];
    if (!inverse) inverse = std::make_shared<CompactMatrix>(*piece.inverse);
    singles_.push_back({2 * (offsets[piece.component] + piece.first), inverse, piece.orientation});
  }
  // All arcs together have one flux; the weight keeps the share of each.
  const FarField far_field(settings.order, held_gauge(problem),
                           std::sqrt(static_cast<double>(arcs)));
  LevelSettings of_level{settings.tolerance, settings.reach, is_large};
  std::vector<ReducedGroup> groups =
      keep(reduce_pieces(problem, pieces, tree.levels[0], layer, far_field, of_level));
  pieces.clear();
  return_freed_memory(is_large);
  of_level.tolerance = settings.group_tolerance;
  for (std::size_t l = 1; l + 1 < tree.levels.size() && unknowns_of(groups) > settings.root; ++l) {
    groups = keep(reduce_groups(tree.levels[l], groups, far_field, of_level));
    of_level.tolerance = std::max(tolerance_fall * of_level.tolerance,
                                  std::min(of_level.tolerance, least_tolerance));
    return_freed_memory(is_large);
  }
  MatrixXf last = coupled_system(groups, far_field);
  groups.clear();
  root_ = CompactMatrix(Eigen::PartialPivLU<Eigen::Ref<MatrixXf>>(last).inverse());
  last.resize(0, 0);
  return_freed_memory(is_large);
}

std::vector<ReducedGroup> HierarchicalPreconditioner::keep(ReducedLevel level) {
  Index first = 0, direction = 0;
  levels_.emplace_back();
  for (std::size_t a = 0; a < level.bases.size(); ++a) {
    levels_.back().push_back(
        {first, direction, std::move(level.bases[a]), std::move(level.inverses[a])});
    first += levels_.back().back().basis.rows();
    direction += levels_.back().back().basis.cols();
  }
  return std::move(level.groups);
}

Eigen::VectorXd HierarchicalPreconditioner::operator()(const Eigen::VectorXd& v) const {
  const auto own = [](const Single& single) {
    return Eigen::seqN(single.first, single.inverse->rows());
  };
  Eigen::VectorXd result(v.size());
  if (levels_.empty()) return result;
  const auto unknowns = [](const Group& group) {
    return Eigen::seqN(group.first, group.basis.rows());
  };
  const auto directions = [](const Group& group) {
    return Eigen::seqN(group.first_direction, group.basis.cols());
  };
  // Upwards: Q^T of the data of each level, which are the data of the next level.
  std::vector<VectorXf> data(levels_.size() + 1);
  const Group& last = levels_[0].back();
  data[0].resize(last.first + last.basis.rows());
  for (std::size_t k = 0; k < singles_.size(); ++k) {
    data[0](unknowns(levels_[0][k])) = v(own(singles_[k])).cast<float>();
  }
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    const std::vector<Group>& groups = levels_[l];
    data[l + 1].resize(groups.back().first_direction + groups.back().basis.cols());
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < groups.size(); ++a) {
      data[l + 1](directions(groups[a])) =
          groups[a].basis.transposed_times(data[l](unknowns(groups[a])));
    }
  }
  // Downwards: T^{-1} (z + Q (y - Q^T z)) with the solution y of the level above (13.8).
  VectorXf solution = root_.times(data.back());
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const std::vector<Group>& groups = levels_[l];
    const VectorXf difference = solution - data[l + 1];
    solution = data[l];
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < groups.size(); ++a) {
      const Group& group = groups[a];
      auto part = solution(unknowns(group));
      part += group.basis.times(difference(directions(group)));
      if (group.inverse.size() > 0) part = group.inverse.times(part);
    }
  }
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < singles_.size(); ++k) {
    const Single& single = singles_[k];
    const auto part = solution(unknowns(levels_[0][k])).reshaped(2, Eigen::AutoSize);
    const Eigen::Matrix2f turn = rotation(single.orientation);
    const Eigen::Matrix2Xf local = turn.transpose() * part;
    const VectorXf solved = single.inverse->times(local.reshaped());
    const Eigen::Matrix2Xf in_plane = turn * solved.reshaped(2, Eigen::AutoSize);
    result(own(single)) = in_plane.reshaped().cast<double>();
  }
  return result;
}

Index HierarchicalPreconditioner::bytes() const {
  Index sum = 2 * root_.size();
  for (const std::vector<Group>& level : levels_) {
    for (const Group& group : level) sum += 2 * (group.basis.size() + group.inverse.size());
  }
  return sum;
}

}  // namespace stokesbook
