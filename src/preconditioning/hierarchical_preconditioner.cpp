// Eliminates components, then groups of components in a tree, each up to the few directions in
// which it is coupled to all others (13.7), (13.8). Couplings are blocks between near groups, and
// multipole expansions between all others.
#include "preconditioning/hierarchical_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "double_layer/stresslet_sum.hpp"
#include "preconditioning/boundary_pieces.hpp"
#include "preconditioning/component_tree.hpp"
#include "preconditioning/coupling_blocks.hpp"
#include "preconditioning/far_field.hpp"
#include "trapezoid/rectangle_index.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;
using Eigen::VectorXf;

namespace {

using Member = BlockDiagonalPreconditioner::Member;

// The tolerance of groups falls by this factor from level to level: the larger a group is, the
// softer are the motions in which its errors show.
constexpr double tolerance_fall = 0.6;
// Where it ends: below, rounding in single precision costs more iterations than it saves.
constexpr double least_tolerance = 0.06;
// Weight of expansions beside near blocks when directions are chosen, where all far groups count
// together.
constexpr float far_weight = 3.0F;

// A group of one level without its interior: what the level above needs to know of it.
struct Reduced {
  Box disk;
  MatrixXf outgoing;                // multipole expansions of the directions
  MatrixXf incoming;                // components of local expansions along the directions
  std::vector<Index> near;          // groups of the same level, ascending
  std::vector<MatrixXf> couplings;  // the blocks Q^T B Q with these groups, as targets of this one

  Index width() const { return incoming.rows(); }

  // Returns the coupling with a near group, or a null pointer for other groups.
  const MatrixXf* coupling(Index source) const {
    const auto found = std::ranges::lower_bound(near, source);
    if (found == near.end() || *found != source) return nullptr;
    return &couplings[static_cast<std::size_t>(found - near.begin())];
  }
};

// Finds the groups of a level that are coupled to each group by blocks.
std::vector<std::vector<Index>> near_groups(const std::vector<Box>& groups, double reach) {
  std::vector<Rectangle> squares;
  for (const Box& group : groups) squares.push_back(square_about(group.centre, group.radius));
  const RectangleIndex index(squares);
  double largest = 0.0;
  for (const Box& group : groups) largest = std::max(largest, group.radius);
  std::vector<std::vector<Index>> near(groups.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < groups.size(); ++a) {
    const double farthest = reach * (groups[a].radius + largest);
    for (const std::size_t b : index.meeting(square_about(groups[a].centre, farthest))) {
      if (b != a && std::abs(groups[a].centre - groups[b].centre) <
                        reach * (groups[a].radius + groups[b].radius)) {
        near[a].push_back(static_cast<Index>(b));
      }
    }
  }
  return near;
}

// Returns an orthonormal basis of the eigenvectors of a Gram matrix with eigenvalues above tau^2.
// A pivoted Cholesky factorisation L L^T finds the range of the matrix first, so that only L^T L is
// diagonalised.
MatrixXf basis_above(double tau, MatrixXf gram) {
  const Index n = gram.rows();
  const auto bound = static_cast<float>(tau * tau);
  constexpr float remainder = 0.16F;  // largest diagonal entry that is left, over tau^2
  VectorXf diagonal = gram.diagonal();
  MatrixXf factor(n, n);
  Index rank = 0;
  for (; rank < n; ++rank) {
    Index pivot = 0;
    const float largest = diagonal.maxCoeff(&pivot);
    if (!(largest > remainder * bound)) break;
    auto column = factor.col(rank);
    column = gram.col(pivot);
    column.noalias() -= factor.leftCols(rank) * factor.row(pivot).head(rank).transpose();
    column /= std::sqrt(largest);
    diagonal -= column.cwiseAbs2();
    diagonal[pivot] = 0.0F;
  }
  gram.resize(0, 0);  // frees the memory, which matters in the largest groups
  if (rank == 0) return {n, 0};
  const auto range = factor.leftCols(rank);
  const MatrixXf inner = range.transpose() * range;
  const Eigen::SelfAdjointEigenSolver<MatrixXf> solver(inner);
  const Index count = (solver.eigenvalues().array() > bound).count();
  if (count == 0) return {n, 0};
  const MatrixXf directions = range * solver.eigenvectors().rightCols(count);
  const Eigen::HouseholderQR<MatrixXf> orthogonal(directions);
  return orthogonal.householderQ() * MatrixXf::Identity(n, count);
}

// Adds the products of columns with themselves to the lower triangle of a Gram matrix.
void add_products(const MatrixXf& columns, MatrixXf& gram) {
  if (columns.cols() > 0) gram.selfadjointView<Eigen::Lower>().rankUpdate(columns);
}

Eigen::Matrix2f rotation(double angle) {
  return Eigen::Rotation2Df(static_cast<float>(angle)).toRotationMatrix();
}

// Returns the inverse of a piece's own block in the frame of the plane.
MatrixXf inverse_in_plane(const BoundaryPiece& piece) {
  MatrixXf inverse = *piece.inverse;
  const Eigen::Matrix2f turn = rotation(piece.orientation);
  for (Index j = 0; j < inverse.cols(); j += 2) {
    const Eigen::MatrixX2f pair = inverse.middleCols<2>(j) * turn.transpose();
    inverse.middleCols<2>(j).reshaped(2, inverse.rows()).noalias() =
        turn * pair.reshaped(2, inverse.rows());
  }
  return inverse;
}

// Returns freed memory of a large tree to the system. The library of C keeps much of it, since
// blocks of many sizes come and go. Small trees are built in every time step, and use it again.
void return_freed_memory([[maybe_unused]] bool is_large) {
#ifdef __GLIBC__
  if (is_large) malloc_trim(0);
#endif
}

// Returns the block with a near source, where the blocks are sought.
MatrixXf& coupling_with(Index source, Reduced& target) {
  const auto place = std::ranges::lower_bound(target.near, source);
  return target.couplings[static_cast<std::size_t>(place - target.near.begin())];
}

// Assembles the blocks whose source is an inner component, and frees the component's inverse.
void couple_bodies(const std::vector<BoundaryPiece>& pieces, const CouplingBlocks& blocks,
                   std::vector<MatrixXf>& inverses, std::vector<Reduced>& singles) {
#pragma omp parallel for schedule(dynamic)
  for (std::size_t source = 0; source < pieces.size(); ++source) {
    if (pieces[source].is_arc()) continue;
    std::vector<Curve> targets;
    for (const Index target : singles[source].near) {
      targets.push_back(pieces[static_cast<std::size_t>(target)].curve);
    }
    const MatrixXf block =
        blocks(all_nodes(targets), pieces[source].component).cast<float>() * inverses[source];
    inverses[source].resize(0, 0);
    Index row = 0;
    for (const Index target : singles[source].near) {
      Reduced& felt = singles[static_cast<std::size_t>(target)];
      coupling_with(static_cast<Index>(source), felt) = block.middleRows(row, felt.width());
      row += felt.width();
    }
  }
}

// Assembles the blocks whose source is an arc of an enclosing wall, and whose target is an inner
// component.
void couple_arcs_to_bodies(std::size_t wall, const std::vector<BoundaryPiece>& pieces,
                           const LayerBlock& layer, const std::vector<MatrixXf>& inverses,
                           std::vector<Reduced>& singles) {
  const auto is_arc = [&](Index k) {
    const BoundaryPiece& piece = pieces[static_cast<std::size_t>(k)];
    return piece.is_arc() && piece.component == wall;
  };
  std::vector<std::size_t> targets;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (!pieces[k].is_arc() && std::ranges::any_of(singles[k].near, is_arc)) {
      targets.push_back(k);
    }
  }
  // The scheme of close evaluation assembles matrices of the whole wall in every call.
  constexpr std::size_t targets_at_once = 24;
#pragma omp parallel for schedule(dynamic)
  for (std::size_t first = 0; first < targets.size(); first += targets_at_once) {
    const std::size_t last = std::min(first + targets_at_once, targets.size());
    std::vector<Curve> curves;
    for (std::size_t k = first; k < last; ++k) curves.push_back(pieces[targets[k]].curve);
    const MatrixXf of_wall = layer(all_nodes(curves), wall).cast<float>();
    Index row = 0;
    for (std::size_t k = first; k < last; ++k) {
      Reduced& felt = singles[targets[k]];
      for (const Index source : felt.near) {
        if (!is_arc(source)) continue;
        const auto arc = static_cast<std::size_t>(source);
        coupling_with(source, felt) =
            of_wall.block(row, 2 * pieces[arc].first, felt.width(), inverses[arc].rows()) *
            inverses[arc];
      }
      row += felt.width();
    }
  }
}

// Assembles the blocks between near arcs of an enclosing wall.
void couple_arcs(const std::vector<BoundaryPiece>& pieces, const std::vector<MatrixXf>& inverses,
                 std::vector<Reduced>& singles) {
#pragma omp parallel for schedule(dynamic)
  for (std::size_t target = 0; target < pieces.size(); ++target) {
    const BoundaryPiece& felt = pieces[target];
    if (!felt.is_arc()) continue;
    for (const Index near : singles[target].near) {
      const auto source = static_cast<std::size_t>(near);
      const BoundaryPiece& arc = pieces[source];
      if (!arc.is_arc()) continue;
      MatrixXf block = StressletSum({arc.curve}).matrix(felt.curve.x).cast<float>();
      block += felt.flow_of_flux * arc.flux_of_density.transpose();
      coupling_with(near, singles[target]) = block * inverses[source];
    }
  }
}

// Describes single pieces as groups of which nothing has been left out: their directions are all
// unknowns, and A_0^{-1} has been applied to what they send.
std::vector<Reduced> single_pieces(const StokesProblem& problem, std::vector<BoundaryPiece> pieces,
                                   const LayerBlock& layer, const std::vector<Box>& disks,
                                   double reach, const FarField& far_field) {
  const CouplingBlocks blocks(problem, ClusterForm::mobility, layer);
  const auto near = near_groups(disks, reach);
  std::vector<Reduced> singles(pieces.size());
  std::vector<MatrixXf> inverses(pieces.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t a = 0; a < pieces.size(); ++a) {
    const BoundaryPiece& piece = pieces[a];
    inverses[a] = inverse_in_plane(piece);
    pieces[a].inverse.reset();
    MatrixXf incoming = far_field.at_points(disks[a], piece.curve.x);
    MatrixXf outgoing = far_field.of_densities(disks[a], piece.curve);
    if (piece.is_arc()) {
      incoming.rightCols<1>() = piece.flow_of_flux;
      outgoing.bottomRows<1>() = piece.flux_of_density.transpose();
    } else {
      const RigidModeMatrices& rigid = blocks.modes(piece.component);
      MatrixXf of_motions = -outgoing * rigid.modes.cast<float>();
      if (blocks.is_held(piece.component)) {
        of_motions += far_field.of_loads(disks[a], piece.disk.centre, rigid.radius);
      }
      outgoing += of_motions * rigid.projection.cast<float>();
    }
    singles[a] = {disks[a], outgoing * inverses[a], incoming, near[a],
                  std::vector<MatrixXf>(near[a].size())};
  }
  couple_bodies(pieces, blocks, inverses, singles);
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    if (!is_inner(problem.components[k])) {
      couple_arcs_to_bodies(k, pieces, layer, inverses, singles);
    }
  }
  couple_arcs(pieces, inverses, singles);
  return singles;
}

// A level of groups whose children have been reduced.
class Level {
 public:
  Level(const std::vector<Box>& groups, std::vector<Reduced>& below, const FarField& far_field)
      : groups_(groups), below_(below), far_field_(far_field), first_{0} {
    for (const Reduced& child : below) first_.push_back(first_.back() + child.width());
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
    return matrix(a).partialPivLu().inverse();
  }

  // Multiplies T^{-1} of a group by columns. Another factorisation costs less than keeping the
  // inverses of all groups, which would take as much memory as their couplings.
  MatrixXf solved(Index a, const MatrixXf& columns) const {
    if (is_single(a)) return columns;
    return matrix(a).partialPivLu().solve(columns);
  }

  MatrixXf outgoing(const Box& disk, Index a) const {
    MatrixXf outgoing(far_field_.weights().size(), size(a));
    for (std::size_t i = first_child(a); i < last_child(a); ++i) {
      outgoing.middleCols(place(a, i), below_[i].width()) =
          far_field_.multipole_to_multipole(below_[i].disk, disk) * below_[i].outgoing;
    }
    return outgoing;
  }

  MatrixXf incoming(const Box& disk, Index a) const {
    MatrixXf incoming(size(a), far_field_.weights().size());
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
      for (std::size_t j = first_child(source); j < last_child(source); ++j) {
        const MatrixXf* coupling = below_[i].coupling(static_cast<Index>(j));
        if (coupling == nullptr) continue;
        result.middleRows(place(target, i), coupling->rows()).noalias() +=
            *coupling * columns.middleRows(place(source, j), coupling->cols());
      }
    }
    return result;
  }

  // Multiplies all of the block by columns.
  MatrixXf coupled(Index target, Index source, const MatrixXf& columns) const {
    MatrixXf result = near_coupled(target, source, columns);
    for (std::size_t j = first_child(source); j < last_child(source); ++j) {
      const MatrixXf multipole =
          below_[j].outgoing * columns.middleRows(place(source, j), below_[j].width());
      for (std::size_t i = first_child(target); i < last_child(target); ++i) {
        if (below_[i].coupling(static_cast<Index>(j)) != nullptr) continue;
        const MatrixXf local =
            far_field_.multipole_to_local(below_[j].disk, below_[i].disk) * multipole;
        result.middleRows(place(target, i), below_[i].width()).noalias() +=
            below_[i].incoming * local;
      }
    }
    return result;
  }

  // Frees the couplings of a group's children as targets.
  void drop_couplings(Index target) {
    for (std::size_t i = first_child(target); i < last_child(target); ++i) {
      std::vector<MatrixXf>().swap(below_[i].couplings);
    }
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

  const std::vector<Box>& groups_;
  std::vector<Reduced>& below_;
  const FarField& far_field_;
  std::vector<Index> first_;  // first unknown of each child
};

MatrixXf symmetric(const MatrixXf& lower) {
  return lower.selfadjointView<Eigen::Lower>();
}

// Chooses the directions Q of all groups of a level. On return, `bases` are these directions,
// `inverses` are T^{-1}, and the result is what the level above needs of the groups. Frees the
// matrices of the level as soon as they have been used.
std::vector<Reduced> reduce(Level& level, const std::vector<Box>& groups, double tolerance,
                            double reach, const FarField& far_field, std::vector<MatrixXf>& bases,
                            std::vector<CompactMatrix>& inverses, bool is_large) {
  const auto near = near_groups(groups, reach);
  const VectorXf weights = far_weight * far_field.weights();
  const Index count = std::ssize(groups);
  std::vector<Reduced> reduced(groups.size());
  std::vector<MatrixXf> solved(groups.size());  // T^{-1} Q
  bases.resize(groups.size());
  inverses.resize(groups.size());
  bool is_regular = true;  // an exception must not leave a parallel loop
  // First the directions V that other groups feel: B T^{-1} V is all that matters of B T^{-1}.
#pragma omp parallel for schedule(dynamic) reduction(&& : is_regular)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    reduced[own].disk = groups[own];
    reduced[own].near = near[own];
    const MatrixXf inverse = level.inverse(a);
    is_regular = is_regular && inverse.allFinite();
    if (!is_regular) continue;
    MatrixXf gram = MatrixXf::Zero(level.size(a), level.size(a));
    for (const Index b : near[own]) level.add_gram(b, a, gram);
    add_products(level.outgoing(groups[own], a).transpose() * weights.asDiagonal(), gram);
    gram = symmetric(gram);
    if (inverse.size() > 0) {
      const MatrixXf right = gram * inverse;
      gram.noalias() = inverse.transpose() * right;
    }
    bases[own] = basis_above(tolerance, std::move(gram));
    solved[own] = inverse.size() > 0 ? MatrixXf(inverse * bases[own]) : bases[own];
    inverses[own] = CompactMatrix(inverse);
  }
  require<std::domain_error>(is_regular,
                             "a group of components has a matrix that is singular to rounding");
  return_freed_memory(is_large);
  // Then the directions, orthogonal to V, in which a group feels others.
  std::vector<MatrixXf> felt(groups.size());
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    MatrixXf gram = MatrixXf::Zero(level.size(a), level.size(a));
    for (const Index b : near[own]) {
      add_products(level.near_coupled(a, b, solved[static_cast<std::size_t>(b)]), gram);
    }
    add_products(level.incoming(groups[own], a) * weights.asDiagonal(), gram);
    const MatrixXf& v = bases[own];
    MatrixXf rest = symmetric(gram);
    rest -= v * (v.transpose() * rest);
    rest -= (rest * v) * v.transpose();
    felt[own] = basis_above(tolerance, std::move(rest));
  }
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    MatrixXf all(level.size(a), bases[own].cols() + felt[own].cols());
    all << bases[own], felt[own];
    MatrixXf all_solved(all.rows(), all.cols());
    all_solved << solved[own], level.solved(a, felt[own]);
    bases[own] = std::move(all);
    solved[own] = std::move(all_solved);
    felt[own].resize(0, 0);
    reduced[own].outgoing = level.outgoing(groups[own], a) * solved[own];
    reduced[own].incoming = bases[own].transpose() * level.incoming(groups[own], a);
  }
  return_freed_memory(is_large);
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    for (const Index b : near[own]) {
      const MatrixXf coupled = level.coupled(a, b, solved[static_cast<std::size_t>(b)]);
      reduced[own].couplings.push_back(bases[own].transpose() * coupled);
    }
    level.drop_couplings(a);
  }
  return reduced;
}

Index unknowns_of(const std::vector<Reduced>& groups) {
  Index sum = 0;
  for (const Reduced& group : groups) sum += group.width();
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
  const bool is_large = offsets.back() > 100'000;
  std::map<const MatrixXf*, std::shared_ptr<const CompactMatrix>> compact;
  for (const BoundaryPiece& piece : pieces) {
    auto& inverse = compact[piece.inverse.get()];
    if (!inverse) inverse = std::make_shared<CompactMatrix>(*piece.inverse);
    singles_.push_back({2 * (offsets[piece.component] + piece.first), inverse, piece.orientation});
  }
  // All arcs together have one flux; the weight keeps the share of each.
  const FarField far_field(settings.order, held_gauge(problem),
                           std::sqrt(static_cast<double>(arcs)));
  double tolerance = settings.tolerance;

  std::vector<Reduced> below =
      single_pieces(problem, std::move(pieces), layer, tree.levels[0], settings.reach, far_field);
  return_freed_memory(is_large);
  const auto is_last = [&](std::size_t l) {
    return l > 0 && (l + 1 == tree.levels.size() || unknowns_of(below) <= settings.root);
  };
  for (std::size_t l = 0; l < tree.levels.size() && !is_last(l); ++l) {
    Level level(tree.levels[l], below, far_field);
    std::vector<MatrixXf> bases;
    std::vector<CompactMatrix> compact_inverses;
    std::vector<Reduced> reduced = reduce(level, tree.levels[l], tolerance, settings.reach,
                                          far_field, bases, compact_inverses, is_large);
    tolerance = std::max(tolerance_fall * tolerance, std::min(tolerance, least_tolerance));
    Index first = 0, direction = 0;
    levels_.emplace_back();
    for (std::size_t a = 0; a < bases.size(); ++a) {
      const Index size = bases[a].rows(), width = bases[a].cols();
      levels_.back().push_back(
          {first, direction, CompactMatrix(bases[a]), std::move(compact_inverses[a])});
      first += size;
      direction += width;
    }
    below = std::move(reduced);
    return_freed_memory(is_large);
  }
  Box root;
  root.last_child = std::ssize(below);
  const std::vector<Box> all{root};
  root_.compute(Level(all, below, far_field).matrix(0));
  below.clear();
  return_freed_memory(is_large);
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
  VectorXf solution = root_.solve(data.back());
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
  Index sum = 4 * root_.matrixLU().size();
  for (const std::vector<Group>& level : levels_) {
    for (const Group& group : level) sum += 2 * (group.basis.size() + group.inverse.size());
  }
  return sum;
}

}  // namespace stokesbook
