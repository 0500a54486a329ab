// Solves clusters of neighbours as a restricted additive Schwarz preconditioner, in compressed
// bases (13.7). In the resistance form, clusters of held bodies replace A_h of (13.4), and a
// sparse resistance matrix releases the free bodies (13.5).
#include "preconditioning/cluster_preconditioner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Member = BlockDiagonalPreconditioner::Member;
using Pair = std::pair<std::size_t, std::size_t>;  // target, source

// Returns the tolerance tau of a basis, for a gap relative to the radii of gyration: in tight gaps
// large components of the densities cancel, so that small ones matter.
double basis_tolerance(double gap) {
  return std::min(0.1, 0.3 * std::sqrt(gap));
}

// Returns the directions Q of a component that couple it to its neighbours: eigenvectors of the
// sum of B^T B and B B^T over the neighbours with eigenvalues above tau^2, where the operator is
// (I + B) A_0.
MatrixXd basis_of(std::size_t own, const std::vector<Neighbour>& neighbours,
                  const CouplingBlocks& coupling_blocks, const std::vector<Member>& alone) {
  const Index size = alone[own].inverse->rows();
  MatrixXd gram = MatrixXd::Zero(size, size);
  auto products = gram.selfadjointView<Eigen::Upper>();
  double least_gap = std::numeric_limits<double>::infinity();
  for (const auto& [other, gap] : neighbours) {
    products.rankUpdate(times_inverse(coupling_blocks(other, own), alone[own]).transpose());
    products.rankUpdate(times_inverse(coupling_blocks(own, other), alone[other]));
    least_gap = std::min(least_gap, gap);
  }
  const double tolerance = basis_tolerance(least_gap);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver{MatrixXd(products)};
  const Index count = (solver.eigenvalues().array() > tolerance * tolerance).count();
  return solver.eigenvectors().rightCols(count);
}

// Assembles the blocks Q^T B Q of all pairs of components that share a cluster.
std::map<Pair, MatrixXd> reduced_blocks(const CouplingBlocks& system,
                                        const std::vector<Member>& alone,
                                        const std::vector<std::vector<std::size_t>>& clusters,
                                        const std::vector<MatrixXd>& bases) {
  std::map<Pair, MatrixXd> blocks;
  for (const std::vector<std::size_t>& cluster : clusters) {
    for (const std::size_t target : cluster) {
      for (const std::size_t source : cluster) {
        if (target != source) blocks[{target, source}];
      }
    }
  }
  std::vector<MatrixXd> solved(bases.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < bases.size(); ++k) solved[k] = solved_alone(alone[k], bases[k]);
  std::vector<std::pair<const Pair, MatrixXd>*> entries;  // random access for the threads
  for (auto& entry : blocks) entries.push_back(&entry);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t p = 0; p < entries.size(); ++p) {
    auto& [pair, block] = *entries[p];
    block = bases[pair.first].transpose() * (system(pair.first, pair.second) * solved[pair.second]);
  }
  return blocks;
}

// Returns (I + Q^T B Q)^{-1} - I of a cluster, in the rows of the cluster's first component.
MatrixXd coupling(const std::map<Pair, MatrixXd>& blocks, const std::vector<std::size_t>& cluster,
                  const std::vector<MatrixXd>& bases) {
  std::vector<Index> first{0};
  for (const std::size_t k : cluster) first.push_back(first.back() + bases[k].cols());
  MatrixXd transposed = MatrixXd::Identity(first.back(), first.back());
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    for (std::size_t j = 0; j < cluster.size(); ++j) {
      if (i == j) continue;
      const MatrixXd& block = blocks.at({cluster[i], cluster[j]});
      transposed.block(first[j], first[i], block.cols(), block.rows()) = block.transpose();
    }
  }
  const MatrixXd own = MatrixXd::Identity(first.back(), first[1]);
  return (transposed.partialPivLu().solve(own) - own).transpose();
}

}  // namespace

ClusterPreconditioner::ClusterPreconditioner(const StokesProblem& problem, ClusterForm form,
                                             std::vector<Member> alone,
                                             const std::vector<std::vector<Neighbour>>& neighbours,
                                             const LayerBlock& layer)
    : alone_(alone), clusters_(alone.size()), bases_(alone.size()), couplings_(alone.size()) {
  const CouplingBlocks system(problem, form, layer);
  for (const Index offset : node_offsets(problem)) offsets_.push_back(2 * offset);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    clusters_[k].push_back(k);
    for (const Neighbour& other : neighbours[k]) clusters_[k].push_back(other.component);
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < alone.size(); ++k) {
    bases_[k] = basis_of(k, neighbours[k], system, alone);
  }
  const std::map<Pair, MatrixXd> blocks = reduced_blocks(system, alone, clusters_, bases_);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < alone.size(); ++k) {
    couplings_[k] = coupling(blocks, clusters_[k], bases_);
  }
  for (std::size_t k = 0; k < alone.size(); ++k) {
    const bool is_free = problem.components[k].kind == ComponentKind::free_body;
    if (!is_free || form == ClusterForm::mobility) continue;
    released_.push_back({k, system.modes(k)});
  }
  if (!released_.empty()) factorise_resistance(alone);
}

void ClusterPreconditioner::factorise_resistance(const std::vector<Member>& alone) {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> place(alone.size(), none);
  for (std::size_t f = 0; f < released_.size(); ++f) place[released_[f].component] = f;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t f = 0; f < released_.size(); ++f) {
    const std::size_t own = released_[f].component;
    // R = Pi A_h^{-1} K (13.5), A_h^{-1} = A_0^{-1} (I + Q X Q^T) with the coupling X of a
    // cluster.
    const MatrixXd weights = times_inverse(released_[f].rigid.projection, alone[own]);
    const MatrixXd coupled = weights * bases_[own] * couplings_[own];
    Index first = 0;
    for (const std::size_t k : clusters_[own]) {
      const MatrixXd& basis = bases_[k];
      if (place[k] != none) {
        Eigen::Matrix3d block = coupled.middleCols(first, basis.cols()) *
                                (basis.transpose() * released_[place[k]].rigid.modes);
        if (k == own) block += weights * released_[f].rigid.modes;
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            entries.emplace_back(3 * static_cast<int>(f) + i, 3 * static_cast<int>(place[k]) + j,
                                 block(i, j));
          }
        }
      }
      first += basis.cols();
    }
  }
  const auto unknowns = static_cast<Index>(3 * released_.size());
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const auto resistance = std::make_shared<Resistance>();
  resistance->compute(matrix);
  require<std::domain_error>(
      resistance->info() == Eigen::Success,
      "the resistance matrix of the clusters is singular: use another preconditioner");
  resistance_ = resistance;
}

VectorXd ClusterPreconditioner::solve_clusters(const VectorXd& v) const {
  const auto own = [&](std::size_t k) {
    return Eigen::seqN(offsets_[k], offsets_[k + 1] - offsets_[k]);
  };
  // A_0^{-1} (v + Q X Q^T v) with the coupling X of each component's cluster (13.7).
  std::vector<VectorXd> along(bases_.size());  // Q^T v
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < bases_.size(); ++k) along[k] = bases_[k].transpose() * v(own(k));
  VectorXd coupled = v;
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < bases_.size(); ++k) {
    VectorXd gathered(couplings_[k].cols());
    Index first = 0;
    for (const std::size_t other : clusters_[k]) {
      gathered.segment(first, along[other].size()) = along[other];
      first += along[other].size();
    }
    coupled(own(k)) += bases_[k] * (couplings_[k] * gathered);
  }
  return alone_(coupled);
}

VectorXd ClusterPreconditioner::operator()(const VectorXd& v) const {
  const VectorXd solved = solve_clusters(v);
  if (released_.empty()) return solved;
  // V from R V = Pi A_h^{-1} v, and then A_h^{-1} (v - K V) - K V (13.5).
  VectorXd loads(static_cast<Index>(3 * released_.size()));
  for (std::size_t f = 0; f < released_.size(); ++f) {
    const MatrixXd& projection = released_[f].rigid.projection;
    loads.segment<3>(static_cast<Index>(3 * f)) =
        projection * solved.segment(offsets_[released_[f].component], projection.cols());
  }
  const VectorXd motions = resistance_->solve(loads);
  VectorXd velocity = VectorXd::Zero(v.size());
  for (std::size_t f = 0; f < released_.size(); ++f) {
    const MatrixXd& modes = released_[f].rigid.modes;
    velocity.segment(offsets_[released_[f].component], modes.rows()) =
        modes * motions.segment<3>(static_cast<Index>(3 * f));
  }
  return solve_clusters(v - velocity) - velocity;
}

double ClusterPreconditioner::mean_rank() const {
  Index sum = 0;
  for (const MatrixXd& basis : bases_) sum += basis.cols();
  return static_cast<double>(sum) / static_cast<double>(bases_.size());
}

}  // namespace stokesbook
