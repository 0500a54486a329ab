// Assembles the blocks D(I - P) + S Pi between different components (13.4), and multiplies by the
// inverses of own blocks in the frame of the plane.
#include "preconditioning/coupling_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "double_layer/kernels.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

bool is_held(const Component& component, ClusterForm form) {
  return form == ClusterForm::resistance ? is_inner(component)
                                         : component.kind == ComponentKind::prescribed;
}

// Evaluates at points the flows of the loads F = -4 pi mu U and L = -4 pi mu a^2 omega, for the
// unit motions U_1, U_2 and a omega. The viscosity cancels.
MatrixXd load_flows(const ComplexVector& points, Complex centre, double a, double gauge) {
  MatrixXd flows(2 * points.size(), 3);
  const double scale = -4.0 * std::numbers::pi;
  for (Index k = 0; k < 3; ++k) {
    ComplexVector velocity(points.size());
    for (Index i = 0; i < points.size(); ++i) {
      const Complex r = points[i] - centre;
      velocity[i] = k == 2 ? rotlet(r, scale * a, 1.0)
                           : stokeslet(r, scale * (k == 0 ? Complex{1.0} : imaginary), 1.0, gauge);
    }
    flows.col(k) = interleaved(velocity);
  }
  return flows;
}

// Multiplies interleaved plane vectors, one per column, by e^{i angle}.
MatrixXd turned(const MatrixXd& columns, double angle) {
  MatrixXd result(columns.rows(), columns.cols());
  const double c = std::cos(angle), s = std::sin(angle);
  const auto x = Eigen::seq(0, columns.rows() - 2, 2), y = Eigen::seq(1, columns.rows() - 1, 2);
  result(x, Eigen::all) = c * columns(x, Eigen::all) - s * columns(y, Eigen::all);
  result(y, Eigen::all) = s * columns(x, Eigen::all) + c * columns(y, Eigen::all);
  return result;
}

}  // namespace

double held_gauge(const StokesProblem& problem) {
  double largest = 0.0;
  for (const Component& component : problem.components) {
    if (!is_inner(component)) continue;
    largest = std::max(largest, RigidModes(component.curve, component.centre).gyration_radius());
  }
  return 100.0 * largest;
}

MatrixXd cluster_block(Component component, ClusterForm form, double gauge) {
  if (!is_held(component, form)) return self_block(component);
  component.kind = ComponentKind::prescribed;
  return self_block(component, gauge);
}

CouplingBlocks::CouplingBlocks(const StokesProblem& problem, ClusterForm form, LayerBlock layer)
    : problem_(problem), form_(form), gauge_(held_gauge(problem)), layer_(std::move(layer)) {
  for (const Component& component : problem.components) {
    modes_.push_back(is_inner(component) ? rigid_mode_matrices(component.curve, component.centre)
                                         : RigidModeMatrices{});
  }
}

bool CouplingBlocks::is_held(std::size_t component) const {
  return stokesbook::is_held(problem_.components[component], form_);
}

MatrixXd CouplingBlocks::operator()(const ComplexVector& targets, std::size_t source) const {
  const RigidModeMatrices& rigid = modes_[source];
  MatrixXd block = layer_(targets, source);
  MatrixXd of_motions = -block * rigid.modes;
  if (is_held(source)) {
    of_motions += load_flows(targets, problem_.components[source].centre, rigid.radius, gauge_);
  }
  block += of_motions * rigid.projection;
  return block;
}

MatrixXd solved_alone(const BlockDiagonalPreconditioner::Member& member, const MatrixXd& columns) {
  const double angle = member.orientation;
  return turned(*member.inverse * turned(columns, -angle), angle);
}

MatrixXd times_inverse(const MatrixXd& rows, const BlockDiagonalPreconditioner::Member& member) {
  const double angle = member.orientation;
  const MatrixXd own_frame = turned(rows.transpose(), -angle).transpose() * *member.inverse;
  return turned(own_frame.transpose(), angle).transpose();
}

}  // namespace stokesbook
