#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "krylov/block_diagonal.hpp"
#include "near_singular/cauchy.hpp"
#include "near_singular/closest_points.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// What all components of one shape, node count and kind share, in the shape's own frame. Built
/// once.
struct Reference {
  Shape shape;
  ComponentKind kind;
  Curve curve;
  std::shared_ptr<const TrigonometricPolynomial> interpolant;
  double rigid_motion_residual;               ///< see rigid_motion_residual()
  std::shared_ptr<const CauchyCurve> cauchy;  ///< none unless near corrections are planned
  std::shared_ptr<const Eigen::MatrixXd>
      inverse_block;  ///< none unless a preconditioner is planned
};

/// What a reference is to hold beside its nodes.
struct ReferenceNeeds {
  bool cauchy = false;
  bool inverse_block = false;
  std::optional<double> gauge_length;  ///< of Stokeslets in an unbounded fluid, see self_block()
};

/// The shared reference of each component.
using References = std::vector<std::shared_ptr<const Reference>>;

/// Builds the distinct references of a scene, each once.
class ReferenceShelf {
 public:
  explicit ReferenceShelf(const ReferenceNeeds& needs) : needs_(needs) {}

  /// Returns the reference of that shape, node count and kind.
  ///
  /// @throws std::domain_error  when its own block is singular
  /// @par Cost  O(N^3) for a new one
  std::shared_ptr<const Reference> get(const Shape& shape, int n_nodes, ComponentKind kind);

 private:
  ReferenceNeeds needs_;
  References built_;
};

/// @}

}  // namespace stokesbook
