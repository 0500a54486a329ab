#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/block_diagonal.hpp"
#include "near_singular/closest_points.hpp"
#include "near_singular/near_targets.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What all components of one shape, node count and kind share, in the shape's own frame. Built
/// once.
struct Reference {
  Shape shape;                                                 ///< what was sampled
  ComponentKind kind;                                          ///< sets the side of the curve
  Curve curve;                                                 ///< nodes
  std::shared_ptr<const TrigonometricPolynomial> interpolant;  ///< of the nodes
  double rigid_motion_residual;               ///< of the curve, by the function of this name
  std::shared_ptr<const CauchyCurve> cauchy;  ///< none unless near corrections are planned
  std::shared_ptr<const InterpolationCurve>
      interpolation;  ///< none unless velocities are to be interpolated
  std::shared_ptr<const Eigen::MatrixXd>
      inverse_block;  ///< none unless a preconditioner is planned
};

/// What a reference is to hold beside its nodes.
struct ReferenceNeeds {
  bool cauchy = false;                            ///< matrices of the near corrections
  std::optional<double> interpolation_tolerance;  ///< of velocities by interpolation, if wanted
  bool inverse_block = false;                     ///< of the preconditioner
  std::optional<double> gauge_length;  ///< of Stokeslets in an unbounded fluid, see self_block()
};

/// The shared reference of each component.
using References = std::vector<std::shared_ptr<const Reference>>;

/// Builds the distinct references of a scene, each once.
class ReferenceShelf {
 public:
  /// Starts with an empty shelf.
  /// @param  needs  what each reference is to hold
  explicit ReferenceShelf(const ReferenceNeeds& needs) : needs_(needs) {}

  /// Returns the reference of a shape, node count and kind; builds it when it is not there yet.
  ///
  /// @param  shape    in its own frame
  /// @param  n_nodes  N, even, >= 4
  /// @param  kind     of the component
  /// @return          the one that all such components share
  /// @throws std::invalid_argument when N is odd or too small
  /// @throws std::domain_error when its own block is singular
  /// @par Cost        O(N^3) for a new one, O(N^2) without near corrections and preconditioner
  std::shared_ptr<const Reference> get(const Shape& shape, int n_nodes, ComponentKind kind);

 private:
  ReferenceNeeds needs_;
  References built_;
};

/// @}

}  // namespace stokesbook
