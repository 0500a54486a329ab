#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "closure/bordered_system.hpp"
#include "closure/closure.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "krylov/block_diagonal.hpp"
#include "krylov/gmres.hpp"
#include "near_singular/near_correction.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook::verification {

/// Describes a free body without load.
struct PlacedBody {
  Shape shape;
  Complex position;
  double orientation = 0.0;
};

/// Returns the undisturbed velocity at a point.
using Flow = std::function<Complex(Complex)>;

/// Returns the velocity (y, 0) of the shear flow.
inline Complex shear(Complex z) {
  return z.imag();
}

/// Returns the velocity of a flow without the symmetries of the arrangements.
inline Complex generic_flow(Complex z) {
  return z.imag() + 0.7 * std::conj(z) + 0.3 * std::exp(0.4 * z) * imaginary;
}

/// Selects how the double layer of one body is evaluated on another body.
enum class Between {
  trapezoid,  ///< by the trapezoid rule: an error of order 1 if the gap is below a spacing
  resolved    ///< with near corrections, exact for the densities that the nodes resolve
};

/// Discretises bodies in a flow.
StokesProblem problem_of(const std::vector<PlacedBody>& bodies, Eigen::Index nodes,
                         const Flow& flow);

/// Discretises one free body of the given shape in its own frame.
Component alone(const Shape& shape, Eigen::Index nodes);

/// Returns the inverse of the diagonal blocks of all bodies. Bodies of equal shape use the same
/// inverse.
BlockDiagonalPreconditioner block_diagonal(const std::vector<PlacedBody>& bodies,
                                           Eigen::Index nodes);

/// Returns the near corrections between bodies.
NearCorrection near_correction(const std::vector<PlacedBody>& bodies, Eigen::Index nodes);

/// Holds the reduced system of bodies in a flow.
class BodySystem {
 public:
  BodySystem(std::vector<PlacedBody> bodies, Eigen::Index nodes, const Flow& flow,
             Between between = Between::resolved);

  /// Returns the operator, which refers to this object.
  LinearMap map() const {
    return [this](const Eigen::VectorXd& v) { return apply(v); };
  }
  Eigen::VectorXd apply(const Eigen::VectorXd& density) const;
  Eigen::VectorXd rhs() const;
  Eigen::MatrixXd matrix() const;
  std::vector<RigidMotion> motions(const Eigen::VectorXd& density) const;
  Eigen::Index size() const { return 2 * nodes_ * static_cast<Eigen::Index>(bodies_.size()); }

 private:
  std::vector<PlacedBody> bodies_;
  Eigen::Index nodes_;
  std::vector<Curve> curves_;
  Closure closure_;
  StressletSum sum_;
  std::optional<NearCorrection> near_;
};

/// Holds a bordered form of the same system. The matrix is dense, but the near corrections are not
/// dense.
class BorderedSystem {
 public:
  BorderedSystem(const std::vector<PlacedBody>& bodies, Eigen::Index nodes, const Flow& flow,
                 Between between, ClosureForm form);

  /// The first function returns the operator; the second function returns the inverse of its
  /// diagonal blocks, each with its border. Both results refer to this object.
  LinearMap map() const {
    return [this](const Eigen::VectorXd& v) { return apply(v); };
  }
  LinearMap preconditioner() const {
    return [this](const Eigen::VectorXd& v) { return solve_blocks(v); };
  }
  const Eigen::VectorXd& rhs() const { return system_.rhs; }

 private:
  Eigen::VectorXd apply(const Eigen::VectorXd& v) const;
  Eigen::VectorXd solve_blocks(const Eigen::VectorXd& v) const;
  std::vector<Eigen::Index> block_rows(Eigen::Index body) const;

  Eigen::Index count_, nodes_;
  DenseSystem system_;
  std::optional<NearCorrection> near_;
  std::vector<Eigen::MatrixXd> inverses_;
};

/// @name Arrangements
/// @{

/// Returns nine circles of radius .5 at the pitch 1.25, with gaps of .25.
std::vector<PlacedBody> nine_circles();

/// Returns a woven lattice of ellipses. Neighbours are perpendicular to each other, and the tip of
/// each ellipse is at a distance of .0555 from the long side of the next ellipse.
std::vector<PlacedBody> woven_ellipses(int columns, int rows, double aspect);

/// Returns two unit circles.
std::vector<PlacedBody> circle_pair(double gap);

/// Returns a number of nodes that resolves densities with modes e^{-alpha |k|} on two unit circles,
/// in which cosh alpha = 1 + gap / 2.
Eigen::Index nodes_at_gap(double gap);

/// Returns a unit circle and six circles around this circle. Each circle nearly touches its
/// neighbours.
std::vector<PlacedBody> hexagon(double gap);

/// @}

}  // namespace stokesbook::verification
