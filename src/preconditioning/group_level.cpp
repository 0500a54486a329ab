// Reduces the groups of one level of a tree, whose children have been reduced before, to few
// directions (chapter 13, section "A tree of groups").
#include <algorithm>
#include <utility>

#include <Eigen/LU>

#include "preconditioning/component_tree.hpp"
#include "preconditioning/directions.hpp"
#include "preconditioning/large_problems.hpp"
#include "preconditioning/tree_level.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXf;

namespace {

// Overwrites the matrix with its factors: each thread has such matrices, which are large on the
// last levels.
using FactorisedInPlace = Eigen::PartialPivLU<Eigen::Ref<MatrixXf>>;

// Adds a product to a sum, which has no rows before the first.
template <class Product>
void add(const Product& product, MatrixXf& sum) {
  if (sum.rows() > 0) {
    sum.noalias() += product;
  } else {
    sum.noalias() = product;
  }
}

// A level of groups whose children have been reduced.
class Level {
 public:
  Level(const std::vector<Box>& groups, const std::vector<ReducedGroup>& below,
        const FarField& far_field)
      : groups_(groups), below_(below), far_field_(far_field), first_{0} {
    for (const ReducedGroup& child : below) first_.push_back(first_.back() + child.width());
  }

  Index size(Index a) const { return first_[last_child(a)] - first_[first_child(a)]; }

  // Assembles T of a group: the identity of each child, and the couplings of the children.
  MatrixXf matrix(Index a) const {
    MatrixXf matrix = MatrixXf::Identity(size(a), size(a));
    for (std::size_t i = first_child(a); i < last_child(a); ++i) {
      for (std::size_t j = first_child(a); j < last_child(a); ++j) {
        if (i == j) continue;
        auto block = matrix.block(place(a, i), place(a, j), below_[i].width(), below_[j].width());
        if (const MatrixXf* coupling = below_[i].coupling(static_cast<Index>(j))) {
          block = *coupling;
        } else {
          block =
              below_[i].incoming *
              (far_field_.multipole_to_local(below_[j].disk, below_[i].disk) * below_[j].outgoing);
        }
      }
    }
    return matrix;
  }

  // Returns T^{-1} of a group; a matrix without rows and columns for a single child, where it is the
  // identity.
  MatrixXf inverse(Index a) const {
    if (is_single(a)) return {};
    MatrixXf factors = matrix(a);
    return FactorisedInPlace(factors).inverse();
  }

  // Multiplies T^{-1} of a group by columns. Another factorisation costs less than keeping the
  // inverses of all groups, which would take as much memory as their couplings. The rounded inverse
  // is not accurate enough: couplings that were computed with it would be amplified above.
  MatrixXf solved(Index a, const MatrixXf& columns) const {
    if (is_single(a)) return columns;
    MatrixXf factors = matrix(a);
    return FactorisedInPlace(factors).solve(columns);
  }

  MatrixXf outgoing(const Box& disk, Index a) const {
    MatrixXf outgoing(far_field_.size(), size(a));
    for (std::size_t i = first_child(a); i < last_child(a); ++i) {
      outgoing.middleCols(place(a, i), below_[i].width()) =
          far_field_.multipole_to_multipole(below_[i].disk, disk) * below_[i].outgoing;
    }
    return outgoing;
  }

  MatrixXf incoming(const Box& disk, Index a) const {
    MatrixXf incoming(size(a), far_field_.size());
    for (std::size_t i = first_child(a); i < last_child(a); ++i) {
      incoming.middleRows(place(a, i), below_[i].width()) =
          below_[i].incoming * far_field_.local_to_local(disk, below_[i].disk);
    }
    return incoming;
  }

  // Adds the near part of B^T B to the lower triangle of a Gram matrix: products of the blocks from
  // near children of a source to those of a target.
  void add_gram(Index target, Index source, MatrixXf& gram) const {
    for (std::size_t i = first_child(target); i < last_child(target); ++i) {
      for (std::size_t j = first_child(source); j < last_child(source); ++j) {
        const MatrixXf* left = below_[i].coupling(static_cast<Index>(j));
        if (left == nullptr) continue;
        for (std::size_t k = first_child(source); k <= j; ++k) {
          const MatrixXf* right = below_[i].coupling(static_cast<Index>(k));
          if (right == nullptr) continue;
          gram.block(place(source, j), place(source, k), left->cols(), right->cols()).noalias() +=
              left->transpose() * *right;
        }
      }
    }
  }

  // Multiplies the near part of the block from a source to a target by columns.
  MatrixXf near_coupled(Index target, Index source, const MatrixXf& columns) const {
    MatrixXf result = MatrixXf::Zero(size(target), columns.cols());
    for (std::size_t i = first_child(target); i < last_child(target); ++i) {
      const MatrixXf near = near_sum(i, source, columns);
      if (near.rows() > 0) result.middleRows(place(target, i), near.rows()) = near;
    }
    return result;
  }

  // Projects the incoming expansions of each child, side by side, onto the directions of a group.
  MatrixXf felt_expansions(Index a, const MatrixXf& basis) const {
    MatrixXf felt(basis.cols(), 0);
    for (std::size_t i = first_child(a); i < last_child(a); ++i) {
      felt = side_by_side(felt, rows(basis, a, i).transpose() * below_[i].incoming);
    }
    return felt;
  }

  // Assembles the coupling of two groups in their directions, Q^T B T^{-1} Q.
  //
  // @param  basis   Q of the target
  // @param  felt    felt_expansions() of the target
  // @param  solved  T^{-1} Q of the source
  MatrixXf coupling(Index target, Index source, const MatrixXf& basis, const MatrixXf& felt,
                    const MatrixXf& solved) const {
    std::vector<MatrixXf> sent;
    for (std::size_t j = first_child(source); j < last_child(source); ++j) {
      sent.push_back(below_[j].outgoing * rows(solved, source, j));
    }
    MatrixXf result = MatrixXf::Zero(basis.cols(), solved.cols());
    for (std::size_t i = first_child(target); i < last_child(target); ++i) {
      const MatrixXf near = near_sum(i, source, solved);
      if (near.rows() > 0) result.noalias() += rows(basis, target, i).transpose() * near;
      MatrixXf far(0, solved.cols());  // local expansions about child i
      for (std::size_t j = first_child(source); j < last_child(source); ++j) {
        if (below_[i].coupling(static_cast<Index>(j)) != nullptr) continue;
        add(far_field_.multipole_to_local(below_[j].disk, below_[i].disk) *
                sent[j - first_child(source)],
            far);
      }
      if (far.rows() > 0) {
        const auto child = static_cast<Index>(i - first_child(target));
        result.noalias() += felt.middleCols(child * far.rows(), far.rows()) * far;
      }
    }
    return result;
  }

 private:
  bool is_single(Index a) const { return last_child(a) - first_child(a) == 1; }
  std::size_t first_child(Index a) const {
    return static_cast<std::size_t>(groups_[static_cast<std::size_t>(a)].first_child);
  }
  std::size_t last_child(Index a) const {
    return static_cast<std::size_t>(groups_[static_cast<std::size_t>(a)].last_child);
  }
  Index place(Index a, std::size_t child) const { return first_[child] - first_[first_child(a)]; }
  // Multiplies the blocks of a child from the near children of a source by columns. Without rows if
  // no child of the source is near.
  MatrixXf near_sum(std::size_t child, Index source, const MatrixXf& columns) const {
    MatrixXf sum(0, columns.cols());
    for (std::size_t j = first_child(source); j < last_child(source); ++j) {
      const MatrixXf* block = below_[child].coupling(static_cast<Index>(j));
      if (block != nullptr) add(*block * rows(columns, source, j), sum);
    }
    return sum;
  }
  MatrixXf::ConstRowsBlockXpr rows(const MatrixXf& columns, Index a, std::size_t child) const {
    return columns.middleRows(place(a, child), below_[child].width());
  }

  const std::vector<Box>& groups_;
  const std::vector<ReducedGroup>& below_;
  const FarField& far_field_;
  std::vector<Index> first_;  // first unknown of each child
};

}  // namespace

const MatrixXf* ReducedGroup::coupling(Index source) const {
  const auto found = std::ranges::lower_bound(near, source);
  if (found == near.end() || *found != source) return nullptr;
  return &couplings[static_cast<std::size_t>(found - near.begin())];
}

ReducedLevel reduce_groups(const std::vector<Box>& groups, std::vector<ReducedGroup>& children,
                           const FarField& far_field, const LevelSettings& settings) {
  const Level level(groups, children, far_field);
  const auto near = near_groups(groups, settings.reach);
  const Index count = std::ssize(groups);
  ReducedLevel result(groups.size());
  std::vector<MatrixXf> bases(groups.size()), solved(groups.size());  // Q, T^{-1} Q
  bool is_regular = true;  // an exception must not leave a parallel loop
  const auto trim_after = [&](Index group) {
    if ((group + 1) % std::max<Index>(1, count / 16) == 0) return_freed_memory(settings.is_large);
  };
  // First the directions V that other groups feel: B T^{-1} V is all that matters of B T^{-1}.
#pragma omp parallel for schedule(dynamic) reduction(&& : is_regular)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    const MatrixXf inverse = level.inverse(a);
    is_regular = is_regular && inverse.allFinite();
    if (!is_regular) continue;
    MatrixXf gram = MatrixXf::Zero(level.size(a), level.size(a));
    for (const Index b : near[own]) level.add_gram(b, a, gram);
    add_far_couplings(level.outgoing(groups[own], a).transpose(), far_field, gram);
    MatrixXf factor = factor_of(settings.tolerance, std::move(gram));
    if (inverse.rows() > 0) factor = inverse.transpose() * factor;
    bases[own] = basis_above(settings.tolerance, factor);
    solved[own] = inverse.rows() > 0 ? MatrixXf(inverse * bases[own]) : bases[own];
    result.inverses[own] = CompactMatrix(inverse);
    trim_after(a);
  }
  require<std::domain_error>(is_regular,
                             "a group of components has a matrix that is singular to rounding");
  // Then the directions, orthogonal to V, in which a group feels others.
  std::vector<MatrixXf> felt(groups.size());
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    MatrixXf gram = MatrixXf::Zero(level.size(a), level.size(a));
    for (const Index b : near[own]) {
      add_products(level.near_coupled(a, b, solved[static_cast<std::size_t>(b)]), gram);
    }
    add_far_couplings(level.incoming(groups[own], a), far_field, gram);
    felt[own] =
        basis_above(settings.tolerance, factor_of(settings.tolerance, std::move(gram)), bases[own]);
    trim_after(a);
  }
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    solved[own] = side_by_side(solved[own], level.solved(a, felt[own]));
    bases[own] = side_by_side(bases[own], felt[own]);
    felt[own].resize(0, 0);
    result.groups[own] = {groups[own],
                          level.outgoing(groups[own], a) * solved[own],
                          bases[own].transpose() * level.incoming(groups[own], a),
                          near[own],
                          {}};
    trim_after(a);
  }
  result.bases = rounded(std::move(bases), settings.is_large);
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    const MatrixXf basis = result.bases[own].unpacked();
    const MatrixXf felt_of_children = level.felt_expansions(a, basis);
    for (const Index b : near[own]) {
      result.groups[own].couplings.push_back(
          level.coupling(a, b, basis, felt_of_children, solved[static_cast<std::size_t>(b)]));
    }
    for (Index child = groups[own].first_child; child < groups[own].last_child; ++child) {
      std::vector<MatrixXf>().swap(children[static_cast<std::size_t>(child)].couplings);
    }
    trim_after(a);
  }
  return result;
}

MatrixXf coupled_system(const std::vector<ReducedGroup>& groups, const FarField& far_field) {
  Box all;
  all.last_child = std::ssize(groups);
  return Level({all}, groups, far_field).matrix(0);
}

std::vector<CompactMatrix> rounded(std::vector<MatrixXf>&& matrices, bool is_large) {
  std::vector<CompactMatrix> compact;
  for (MatrixXf& matrix : matrices) {
    compact.emplace_back(matrix);
    matrix.resize(0, 0);
  }
  return_freed_memory(is_large);
  return compact;
}

}  // namespace stokesbook
