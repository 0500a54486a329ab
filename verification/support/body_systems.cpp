// Builds systems for studies: reduced and bordered systems of free bodies in a flow with near
// corrections, block-diagonal preconditioners, and arrangements of bodies.
#include "support/body_systems.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "support/dense.hpp"

namespace stokesbook::verification {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double near_tolerance = 1e-14;

/// Makes one object for each shape. Bodies of equal shape use the same object.
template <class Object, class Make>
std::vector<std::shared_ptr<const Object>> shared_by_shape(const std::vector<PlacedBody>& bodies,
                                                           const Make& make) {
  std::vector<std::shared_ptr<const Object>> objects;
  for (const PlacedBody& body : bodies) {
    const auto first = std::ranges::find(bodies, body.shape, &PlacedBody::shape);
    const auto k = static_cast<std::size_t>(first - bodies.begin());
    objects.push_back(k < objects.size() ? objects[k]
                                         : std::make_shared<const Object>(make(body.shape)));
  }
  return objects;
}

std::vector<PlacedCurve> placed_curves(const std::vector<PlacedBody>& bodies, Index nodes) {
  const auto references = shared_by_shape<CauchyCurve>(bodies, [&](const Shape& shape) {
    return CauchyCurve(sample(shape, nodes, Side::fluid_outside));
  });
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    placed.push_back({references[k], bodies[k].position, bodies[k].orientation});
  }
  return placed;
}

std::vector<Curve> curves_of(const std::vector<PlacedBody>& bodies, Index nodes) {
  std::vector<Curve> curves;
  for (const PlacedBody& body : bodies) {
    const Curve reference = sample(body.shape, nodes, Side::fluid_outside);
    curves.push_back(place(reference, body.position, body.orientation));
  }
  return curves;
}

}  // namespace

Component alone(const Shape& shape, Index nodes) {
  return {ComponentKind::free_body, sample(shape, nodes, Side::fluid_outside), {}, {}, 0.0, {}};
}

StokesProblem problem_of(const std::vector<PlacedBody>& bodies, Index nodes, const Flow& flow) {
  const std::vector<Curve> curves = curves_of(bodies, nodes);
  StokesProblem problem;
  problem.background = all_nodes(curves).unaryExpr(flow);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    problem.components.push_back(
        {ComponentKind::free_body, curves[k], bodies[k].position, {}, 0.0, {}});
  }
  return problem;
}

NearCorrection near_correction(const std::vector<PlacedBody>& bodies, Index nodes) {
  return {placed_curves(bodies, nodes),
          all_nodes(curves_of(bodies, nodes)),
          Targets::own_nodes,
          {near_tolerance}};
}

BlockDiagonalPreconditioner block_diagonal(const std::vector<PlacedBody>& bodies, Index nodes) {
  const auto inverses = shared_by_shape<MatrixXd>(
      bodies, [&](const Shape& shape) { return invert_block(self_block(alone(shape, nodes))); });
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    members.push_back({inverses[k], bodies[k].orientation});
  }
  return BlockDiagonalPreconditioner(std::move(members));
}

BodySystem::BodySystem(std::vector<PlacedBody> bodies, Index nodes, const Flow& flow,
                       Between between)
    : bodies_(std::move(bodies)),
      nodes_(nodes),
      curves_(curves_of(bodies_, nodes)),
      closure_(problem_of(bodies_, nodes, flow)),
      sum_(curves_, KernelStorage::stored) {
  if (between == Between::resolved) near_.emplace(near_correction(bodies_, nodes));
}

VectorXd BodySystem::apply(const VectorXd& v) const {
  const ComplexVector density = deinterleaved(v);
  const ComplexVector rest = closure_.without_rigid_part(density);
  ComplexVector velocity = sum_(rest) - 0.5 * rest + closure_.velocity(density);
  if (near_) velocity += (*near_)(rest);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const Index first = nodes_ * static_cast<Index>(k);
    velocity.segment(first, nodes_) += diagonal_velocity(curves_[k], rest.segment(first, nodes_));
  }
  return interleaved(velocity);
}

VectorXd BodySystem::rhs() const {
  const ComplexVector rhs = closure_.right_hand_side();
  return interleaved(rhs);
}

MatrixXd BodySystem::matrix() const {
  MatrixXd matrix(size(), size());
  for (Index column = 0; column < size(); ++column) {
    matrix.col(column) = apply(VectorXd::Unit(size(), column));
  }
  return matrix;
}

std::vector<RigidMotion> BodySystem::motions(const VectorXd& density) const {
  return closure_.complete(deinterleaved(density)).motions;
}

BorderedSystem::BorderedSystem(const std::vector<PlacedBody>& bodies, Index nodes, const Flow& flow,
                               Between between, ClosureForm form)
    : count_(static_cast<Index>(bodies.size())),
      nodes_(nodes),
      system_(assemble(problem_of(bodies, nodes, flow), form)) {
  if (between == Between::resolved) near_.emplace(near_correction(bodies, nodes));
  for (Index body = 0; body < count_; ++body) {
    const std::vector<Index> rows = block_rows(body);
    inverses_.push_back(test::inverse(system_.matrix(rows, rows)));
  }
}

std::vector<Index> BorderedSystem::block_rows(Index body) const {
  std::vector<Index> rows;
  for (Index i = 0; i < 2 * nodes_; ++i) rows.push_back(2 * nodes_ * body + i);
  for (Index i = 0; i < 3; ++i) rows.push_back(2 * nodes_ * count_ + 3 * body + i);
  return rows;
}

VectorXd BorderedSystem::apply(const VectorXd& v) const {
  VectorXd result = system_.matrix * v;
  if (near_) {
    const Index size = 2 * nodes_ * count_;
    const ComplexVector correction = (*near_)(deinterleaved(v.head(size)));
    result.head(size) += interleaved(correction);
  }
  return result;
}

VectorXd BorderedSystem::solve_blocks(const VectorXd& v) const {
  VectorXd result(v.size());
  for (Index body = 0; body < count_; ++body) {
    const std::vector<Index> rows = block_rows(body);
    result(rows) = inverses_[static_cast<std::size_t>(body)] * v(rows);
  }
  return result;
}

std::vector<PlacedBody> nine_circles() {
  std::vector<PlacedBody> bodies;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) bodies.push_back({Circle{0.5}, 1.25 * Complex(i, j)});
  }
  return bodies;
}

std::vector<PlacedBody> woven_ellipses(int columns, int rows, double aspect) {
  const double pitch = 1.0 + 1.0 / aspect + 0.0555;
  std::vector<PlacedBody> bodies;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      bodies.push_back({Ellipse{1.0, 1.0 / aspect}, pitch * Complex(column, row),
                        (column + row) % 2 == 0 ? 0.0 : 0.5 * std::numbers::pi});
    }
  }
  return bodies;
}

std::vector<PlacedBody> circle_pair(double gap) {
  return {{Circle{1.0}, -1.0 - 0.5 * gap}, {Circle{1.0}, 1.0 + 0.5 * gap}};
}

Index nodes_at_gap(double gap) {
  return 2 * static_cast<Index>(std::ceil(8.0 + 9.0 / std::acosh(1.0 + 0.5 * gap)));
}

std::vector<PlacedBody> hexagon(double gap) {
  std::vector<PlacedBody> bodies{{Circle{1.0}, 0.0}};
  for (int k = 0; k < 6; ++k) {
    bodies.push_back({Circle{1.0}, std::polar(2.0 + gap, std::numbers::pi / 3.0 * k)});
  }
  return bodies;
}

}  // namespace stokesbook::verification
