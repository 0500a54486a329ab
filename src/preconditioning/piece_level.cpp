// Reduces single pieces of the boundary, the lowest level of a tree, to few directions (chapter 13,
// section "A tree of groups"). Nothing has been left out of a piece: all of its unknowns are
// coupled to other pieces, and A_0^{-1} is applied to what it sends.
#include <algorithm>
#include <set>

#include <Eigen/Geometry>

#include "double_layer/stresslet_sum.hpp"
#include "preconditioning/component_tree.hpp"
#include "preconditioning/directions.hpp"
#include "preconditioning/tree_level.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXf;

namespace {

// Returns the inverse of a piece's own block in the frame of the plane.
MatrixXf inverse_in_plane(const BoundaryPiece& piece) {
  MatrixXf inverse = *piece.inverse;
  const Eigen::Matrix2f turn =
      Eigen::Rotation2Df(static_cast<float>(piece.orientation)).toRotationMatrix();
  for (Index j = 0; j < inverse.cols(); j += 2) {
    const Eigen::MatrixX2f pair = inverse.middleCols<2>(j) * turn.transpose();
    inverse.middleCols<2>(j).reshaped(2, inverse.rows()).noalias() =
        turn * pair.reshaped(2, inverse.rows());
  }
  return inverse;
}

// The blocks of B A_0^{-1} from a piece to all near pieces, one below another.
class NearBlocks {
 public:
  NearBlocks(const CouplingBlocks& of_bodies, const std::vector<BoundaryPiece>& pieces,
             const LayerBlock& layer, const std::vector<std::vector<Index>>& near)
      : of_bodies_(of_bodies), pieces_(pieces), near_(near), of_arcs_(pieces.size()) {
    std::set<std::size_t> walls;
    for (std::size_t a = 0; a < pieces.size(); ++a) {
      starts_.push_back({0});
      for (const Index b : near[a]) starts_[a].push_back(starts_[a].back() + width(b));
      if (!pieces[a].is_arc()) continue;
      of_arcs_[a].resize(starts_[a].back(), width(static_cast<Index>(a)));
      walls.insert(pieces[a].component);
    }
    couple_arcs();
    for (const std::size_t wall : walls) couple_wall_to_bodies(wall, layer);
  }

  // Returns the number of unknowns of a piece.
  Index width(Index a) const { return 2 * pieces_[static_cast<std::size_t>(a)].curve.size(); }

  // Returns the rows of a target among those of all pieces near to a source.
  auto rows(Index target, Index source) const {
    const auto own = static_cast<std::size_t>(source);
    const auto place = std::ranges::lower_bound(near_[own], target) - near_[own].begin();
    return Eigen::seqN(starts_[own][static_cast<std::size_t>(place)], width(target));
  }

  // Assembles the blocks of a source; those of arcs have been assembled before.
  MatrixXf operator()(Index source) const {
    const auto own = static_cast<std::size_t>(source);
    if (pieces_[own].is_arc()) return of_arcs_[own];
    std::vector<Curve> targets;
    for (const Index b : near_[own]) targets.push_back(pieces_[static_cast<std::size_t>(b)].curve);
    return of_bodies_(all_nodes(targets), pieces_[own].component).cast<float>() *
           inverse_in_plane(pieces_[own]);
  }

 private:
  // Assembles the blocks between near arcs.
  void couple_arcs() {
#pragma omp parallel for schedule(dynamic)
    for (std::size_t source = 0; source < pieces_.size(); ++source) {
      const BoundaryPiece& arc = pieces_[source];
      if (!arc.is_arc()) continue;
      for (const Index near : near_[source]) {
        const BoundaryPiece& felt = pieces_[static_cast<std::size_t>(near)];
        if (!felt.is_arc()) continue;
        MatrixXf block = StressletSum({arc.curve}).matrix(felt.curve.x).cast<float>();
        block += felt.flow_of_flux * arc.flux_of_density.transpose();
        of_arcs_[source](rows(near, static_cast<Index>(source)), Eigen::all) = block * *arc.inverse;
      }
    }
  }

  // Assembles the blocks from the arcs of a wall to bodies.
  void couple_wall_to_bodies(std::size_t wall, const LayerBlock& layer) {
    const auto is_arc = [&](Index k) {
      const BoundaryPiece& piece = pieces_[static_cast<std::size_t>(k)];
      return piece.is_arc() && piece.component == wall;
    };
    std::vector<std::size_t> targets;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (!pieces_[k].is_arc() && std::ranges::any_of(near_[k], is_arc)) targets.push_back(k);
    }
    // The scheme of close evaluation assembles matrices of the whole wall in every call.
    constexpr std::size_t targets_at_once = 24;
#pragma omp parallel for schedule(dynamic)
    for (std::size_t first = 0; first < targets.size(); first += targets_at_once) {
      const std::size_t last = std::min(first + targets_at_once, targets.size());
      std::vector<Curve> curves;
      for (std::size_t k = first; k < last; ++k) curves.push_back(pieces_[targets[k]].curve);
      const MatrixXf of_wall = layer(all_nodes(curves), wall).cast<float>();
      Index row = 0;
      for (std::size_t k = first; k < last; ++k) {
        const auto target = static_cast<Index>(targets[k]);
        for (const Index source : near_[targets[k]]) {
          if (!is_arc(source)) continue;
          const BoundaryPiece& arc = pieces_[static_cast<std::size_t>(source)];
          of_arcs_[static_cast<std::size_t>(source)](rows(target, source), Eigen::all) =
              of_wall.block(row, 2 * arc.first, width(target), width(source)) * *arc.inverse;
        }
        row += width(target);
      }
    }
  }

  const CouplingBlocks& of_bodies_;
  const std::vector<BoundaryPiece>& pieces_;
  const std::vector<std::vector<Index>>& near_;
  std::vector<std::vector<Index>> starts_;  // first row of each near piece, and the end
  std::vector<MatrixXf> of_arcs_;           // the blocks of each arc
};

// Assembles the multipole expansions of a piece's unknowns.
MatrixXf outgoing_expansions(const BoundaryPiece& piece, const Box& disk,
                             const CouplingBlocks& bodies, const FarField& far_field) {
  MatrixXf outgoing = far_field.of_densities(disk, piece.curve);
  if (piece.is_arc()) {
    outgoing.bottomRows<1>() = piece.flux_of_density.transpose();
  } else {
    const RigidModeMatrices& rigid = bodies.modes(piece.component);
    MatrixXf of_motions = -outgoing * rigid.modes.cast<float>();
    if (bodies.is_held(piece.component)) {
      of_motions += far_field.of_loads(disk, disk.centre, rigid.radius);
    }
    outgoing += of_motions * rigid.projection.cast<float>();
  }
  return outgoing * inverse_in_plane(piece);
}

// Assembles the components of local expansions along a piece's unknowns.
MatrixXf incoming_expansions(const BoundaryPiece& piece, const Box& disk,
                             const FarField& far_field) {
  MatrixXf incoming = far_field.at_points(disk, piece.curve.x);
  if (piece.is_arc()) incoming.rightCols<1>() = piece.flow_of_flux;
  return incoming;
}

}  // namespace

ReducedLevel reduce_pieces(const StokesProblem& problem, const std::vector<BoundaryPiece>& pieces,
                           const std::vector<Box>& disks, const LayerBlock& layer,
                           const FarField& far_field, const LevelSettings& settings) {
  const CouplingBlocks of_bodies(problem, ClusterForm::mobility, layer);
  const auto near = near_groups(disks, settings.reach);
  const NearBlocks near_blocks(of_bodies, pieces, layer, near);
  const Index count = std::ssize(pieces);
  ReducedLevel result(pieces.size());
  std::vector<MatrixXf> bases(pieces.size());   // Q
  std::vector<MatrixXf> blocks(pieces.size());  // B A_0^{-1}, unless the problem is large
  std::vector<MatrixXf> sent(pieces.size());    // its product with Q
  // First the directions V that other pieces feel.
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    ReducedGroup& group = result.groups[own];
    group = {disks[own],
             outgoing_expansions(pieces[own], disks[own], of_bodies, far_field),
             incoming_expansions(pieces[own], disks[own], far_field),
             near[own],
             {}};
    MatrixXf block = near_blocks(a);
    MatrixXf gram = MatrixXf::Zero(group.width(), group.width());
    add_products(block.transpose(), gram);
    add_far_couplings(group.outgoing.transpose(), far_field, gram);
    bases[own] = basis_above(settings.tolerance, factor_of(settings.tolerance, std::move(gram)));
    sent[own] = block * bases[own];
    if (!settings.is_large) blocks[own] = std::move(block);
  }
  // Then the directions, orthogonal to V, in which a piece feels others.
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    ReducedGroup& group = result.groups[own];
    MatrixXf gram = MatrixXf::Zero(group.width(), group.width());
    for (const Index b : near[own]) {
      add_products(sent[static_cast<std::size_t>(b)](near_blocks.rows(a, b), Eigen::all), gram);
    }
    add_far_couplings(group.incoming, far_field, gram);
    const MatrixXf factor = factor_of(settings.tolerance, std::move(gram));
    bases[own] = side_by_side(bases[own], basis_above(settings.tolerance, factor, bases[own]));
  }
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    ReducedGroup& group = result.groups[own];
    const MatrixXf felt = bases[own].rightCols(bases[own].cols() - sent[own].cols());
    sent[own] = side_by_side(sent[own], (settings.is_large ? near_blocks(a) : blocks[own]) * felt);
    blocks[own].resize(0, 0);
    group.outgoing *= bases[own];
    group.incoming = bases[own].transpose() * group.incoming;
  }
  result.bases = rounded(std::move(bases), settings.is_large);
#pragma omp parallel for schedule(dynamic)
  for (Index a = 0; a < count; ++a) {
    const auto own = static_cast<std::size_t>(a);
    const MatrixXf basis = result.bases[own].unpacked();
    for (const Index b : near[own]) {
      const auto& coupled = sent[static_cast<std::size_t>(b)](near_blocks.rows(a, b), Eigen::all);
      result.groups[own].couplings.push_back(basis.transpose() * coupled);
    }
  }
  return result;
}

}  // namespace stokesbook
