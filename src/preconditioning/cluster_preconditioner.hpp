#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseLU>

#include "krylov/block_diagonal.hpp"
#include "preconditioning/coupling_blocks.hpp"

namespace stokesbook {

/// A component in the cluster of another component.
struct Neighbour {
  std::size_t component = 0;  ///< number of the component
  double gap = 0.0;           ///< between the two components, over their mean radius of gyration
};

/// Preconditions by solving for clusters of neighbours, in one of two forms.
///
/// The cluster of a component consists of the component and its neighbours, with all pairs among
/// them. A restricted additive Schwarz method replaces \f$ A^{-1} \f$: the rows of each component
/// are those of the inverse of its cluster.
///
/// The mobility form applies this method to A itself. Contacts that form a rigid network have
/// collective modes, which clusters of free bodies do not contain. The resistance form contains
/// these modes. With all inner components held, the operator is
/// \f$ A_h = (-\frac12 + D)(I-P) + S\Pi \f$ (13.4), where \f$ \Pi\eta \f$ are the rigid motions
/// in \f$ P = K\Pi \f$, and S are the flows of their loads. With the free bodies f, exactly (13.5)
/// \f[ A^{-1}r = A_h^{-1}(r - K_f V) - K_f V, \qquad
///     \Pi_f A_h^{-1} K_f\, V = \Pi_f A_h^{-1} r: \f]
/// the motions -V balance the loads of the held bodies under the data r. Held bodies screen the
/// flow, so that \f$ A_h^{-1} \f$ is nearly local, and the Schwarz method replaces this inverse.
/// The resistance matrix \f$ \Pi_f A_h^{-1} K_f \f$ is then sparse, with three unknowns per body.
///
/// Let the operator, A or A_h, be \f$ (I + B)A_0 \f$, where \f$ A_0 \f$ consists of the own blocks.
/// The clusters are solved only in the few directions Q that couple a component to its neighbours
/// (13.7): \f$ (I+B)^{-1} \approx I - QQ^T + Q(I + Q^T B Q)^{-1}Q^T \f$.
/// @par Accuracy  residuals fall by a digit or more per iteration on seven disks at gaps of 0.01,
/// @ref claim_13_9; iterations for bodies that nearly touch, @ref claim_13_6; the forces that
/// clusters leave out fall with the square of the distance, @ref claim_13_7
/// @par Not for   problems with held bodies only whose gaps, a few hundredths or less, close pores:
/// GMRES may break down by rounding
class ClusterPreconditioner {
 public:
  /// Factorises all clusters and the resistance matrix.
  ///
  /// @param  problem     components in the order of the densities, n nodes in all
  /// @param  alone       inverse of the cluster_block() of each component, and its orientation
  /// @param  neighbours  neighbours of each component, without itself; an enclosing wall has none,
  ///                     and is solved alone
  /// @param  layer       double layer between any two components of a cluster
  /// @throws std::domain_error when the resistance matrix is singular
  /// @par Cost  per component, for clusters of m components with N nodes each: some 3 m matrix
  /// products and an eigenvalue problem of size 2N, and a factorisation of size m q for q
  /// directions
  ClusterPreconditioner(const StokesProblem& problem, ClusterForm form,
                        std::vector<BlockDiagonalPreconditioner::Member> alone,
                        const std::vector<std::vector<Neighbour>>& neighbours,
                        const LayerBlock& layer);

  /// Applies the approximate inverse, a linear map, to 2n interleaved numbers (x_0, y_0, ...). The
  /// result is the same for any number of threads.
  ///
  /// @par Cost  4 N^2 + 4 N q + m q^2 multiplications per component, twice in the resistance form
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

  /// Returns the mean number q of directions in which a component is coupled to its cluster, at
  /// most 2N; 0 without neighbours.
  double mean_rank() const;

 private:
  struct ReleasedBody {
    std::size_t component;
    RigidModeMatrices rigid;
  };
  using Resistance = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

  void factorise_resistance(const std::vector<BlockDiagonalPreconditioner::Member>& alone);
  Eigen::VectorXd solve_clusters(const Eigen::VectorXd& v) const;

  std::vector<Eigen::Index> offsets_;  // first entry of each component, then 2n
  BlockDiagonalPreconditioner alone_;
  std::vector<std::vector<std::size_t>> clusters_;  // cluster of each component, itself first
  std::vector<Eigen::MatrixXd> bases_;              // Q of each component
  std::vector<Eigen::MatrixXd> couplings_;        // own rows of (I + Q^T B Q)^{-1} - I per cluster
  std::vector<ReleasedBody> released_;            // free bodies in the resistance form
  std::shared_ptr<const Resistance> resistance_;  // R of these bodies, 3 unknowns each
};

}  // namespace stokesbook
