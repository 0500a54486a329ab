#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseLU>

#include "closure/problem.hpp"
#include "krylov/block_diagonal.hpp"
#include "krylov/layer_block.hpp"

namespace stokesbook {

/// @addtogroup krylov
/// @{

/// Returns the gauge length of the Stokeslets with which bodies are held in clusters: a hundred
/// times the largest radius of gyration of all inner components.
///
/// A force of finite size then needs a cluster to move as a whole, as it does among others; at
/// their own gauge the components of a cluster would resist that.
/// @param  problem  with an inner component
/// @return          length
double held_gauge(const StokesProblem& problem);

/// How free bodies are taken in clusters.
enum class ClusterForm {
  mobility,   ///< free, as they are
  resistance  ///< held, and let go together by a resistance problem
};

/// Assembles a component's own block as it is in clusters: of a free body in the mobility form as
/// it is, of any other inner component that of a prescribed one at a gauge.
///
/// @param  component  of any kind, in any frame
/// @param  form       of the clusters
/// @param  gauge      from held_gauge(), length
/// @return            2N x 2N, dimensionless, interleaved
/// @par Cost          that of self_block()
Eigen::MatrixXd cluster_block(Component component, ClusterForm form, double gauge);

/// Another component that is solved for in a component's cluster.
struct Neighbour {
  std::size_t component = 0;  ///< which
  double gap = 0.0;           ///< between the two, over their mean radius of gyration
};

/// Solves clusters of neighbours, in one of two forms.
///
/// \f$ A^{-1} \f$ is replaced by a restricted additive Schwarz method: each component's rows are
/// those of the inverse of its cluster, itself and its neighbours with all pairs among them. In the
/// mobility form that is all. It leaves the far flow of the bodies' stresslets, which is weak, so
/// that iterations hardly grow with their number; but contacts that make a rigid network have
/// collective modes, which clusters do not see.
///
/// The resistance form sees them. With all inner components held, the operator is
/// \f$ A_h = (-\frac12 + D)(I-P) + S\Pi \f$, where \f$ \Pi\eta \f$ are the rigid motions of
/// \f$ P = K\Pi \f$ and S the flows of their loads. Free bodies have
/// \f$ A = A_h - (S_f + K_f)\Pi_f \f$; as \f$ A_h K_f = S_f \f$, exactly
/// \f[ A^{-1}r = A_h^{-1}(r - K_f V) - K_f V, \qquad
///     \Pi_f A_h^{-1} K_f\, V = \Pi_f A_h^{-1} r: \f]
/// the loads of held bodies under the data r are those that motions -V balance. Held bodies screen
/// the flow, so that \f$ A_h^{-1} \f$ is nearly local: it is what clusters replace here. The
/// resistance matrix \f$ \Pi_f A_h^{-1} K_f \f$ is sparse then, three unknowns a body. Motions as
/// long as the suspension meet little resistance, and what clusters leave out of it makes the
/// iterations grow with the number of bodies.
///
/// With \f$ (I + B)D \f$ for the operator in question, D the components alone, clusters are solved
/// in the few directions Q of each component that it feels its neighbours through or is felt by
/// them: \f$ (I+B)^{-1} \approx I - QQ^T + Q(I + Q^T B Q)^{-1}Q^T \f$.
/// @par Accuracy  residuals fall by a digit an iteration or more on seven disks at gaps of 0.01,
/// @ref claim_05_29; iterations of bodies that nearly touch, @ref claim_05_26; what clusters leave
/// out falls with the square of the distance, @ref claim_05_27
/// @par Not for   held bodies alone whose gaps of a few hundredths or less close pores: GMRES may
/// break down by rounding
class ClusterPreconditioner {
 public:
  /// Factorises all clusters and the resistance matrix.
  ///
  /// @param  problem     components in the order of the densities, n nodes in all
  /// @param  form        of the clusters
  /// @param  alone       inverses of their cluster_block() and how they are turned
  /// @param  neighbours  of each component, without itself; none of an enclosing wall, which is
  ///                     solved alone
  /// @param  layer       between any two components of a cluster
  /// @throws std::domain_error when the resistance matrix is singular
  /// @par Cost      for clusters of m components with N nodes each, a component: some 3 m matrix
  /// products of size 2N, an eigenvalue problem of size 2N, and a factorisation of size m q for q
  /// directions
  ClusterPreconditioner(const StokesProblem& problem, ClusterForm form,
                        std::vector<BlockDiagonalPreconditioner::Member> alone,
                        const std::vector<std::vector<Neighbour>>& neighbours,
                        const LayerBlock& layer);

  /// Applies the approximate inverse; linear, whatever the number of threads.
  ///
  /// @param  v  2n numbers, interleaved (x_0, y_0, x_1, y_1, ...)
  /// @return    2n numbers, ordered as v, unit of v
  /// @par Cost  4 N^2 + 4 N q + m q^2 multiplications a component, twice in the resistance form
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

  /// Returns the mean number of directions in which a component is coupled to its cluster.
  /// @return q, at most 2N; 0 without neighbours
  double mean_rank() const;

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
  /// @cond
  struct ReleasedBody {
    std::size_t component;
    Eigen::MatrixXd modes;       // K, 2N x 3
    Eigen::MatrixXd projection;  // Pi, 3 x 2N
  };
  using Resistance = Eigen::SparseLU<Eigen::SparseMatrix<double>>;
  /// @endcond

  void factorise_resistance(const std::vector<BlockDiagonalPreconditioner::Member>& alone);
  Eigen::VectorXd solve_clusters(const Eigen::VectorXd& v) const;

  std::vector<Eigen::Index> offsets_;  // first of each component's numbers, and 2n
  BlockDiagonalPreconditioner alone_;
  std::vector<std::vector<std::size_t>> clusters_;  // of each component, itself first
  std::vector<Eigen::MatrixXd> bases_;              // Q of each component
  std::vector<Eigen::MatrixXd> couplings_;  // own rows of (I + Q^T B Q)^{-1} - I of its cluster
  std::vector<ReleasedBody> released_;      // free ones of the resistance form
  std::shared_ptr<const Resistance> resistance_;  // of these, three unknowns each
};

/// @}

}  // namespace stokesbook
