// Divides the boundary into the pieces that a HierarchicalPreconditioner eliminates first (chapter
// 13, section "A tree of groups"). A wall is much larger than the bodies inside, so it is cut into
// arcs.
#include "preconditioning/boundary_pieces.hpp"

#include <cmath>
#include <map>

#include "double_layer/double_layer.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::MatrixXf;

namespace {

// Returns n nodes of a curve, with derivatives by a parameter that runs from 0 to 2 pi along them.
Curve arc_of(const Curve& curve, Index first, Index n) {
  const double share = static_cast<double>(n) / static_cast<double>(curve.size());
  return {curve.x.segment(first, n), share * curve.dx.segment(first, n),
          share * share * curve.ddx.segment(first, n), curve.side};
}

// Cuts a wall into arcs with nearly equal numbers of nodes.
void add_arcs(std::size_t wall, const Curve& curve, std::vector<BoundaryPiece>& pieces) {
  constexpr Index most_nodes = 16;
  const Index n = curve.size(), count = (n + most_nodes - 1) / most_nodes;
  // N_0 = -n (w n)^T / |Gamma_0|, as the product of two vectors of similar size.
  const double root = std::sqrt(static_cast<double>(n)), length = perimeter(curve);
  for (Index k = 0; k < count; ++k) {
    BoundaryPiece arc;
    arc.component = wall;
    arc.first = n * k / count;
    arc.curve = arc_of(curve, arc.first, n * (k + 1) / count - arc.first);
    arc.disk.centre = 0.5 * (arc.curve.x[0] + arc.curve.x[arc.curve.size() - 1]);
    const ComplexVector normal = normals(arc.curve);
    arc.flow_of_flux = interleaved(normal / -root).cast<float>();
    arc.flux_of_density =
        interleaved((root / length) * normal.cwiseProduct(weights(arc.curve))).cast<float>();
    MatrixXd block = double_layer_matrix(arc.curve);
    block.diagonal().array() -= 0.5;
    block += (arc.flow_of_flux * arc.flux_of_density.transpose()).cast<double>();
    arc.inverse = std::make_shared<MatrixXf>(invert_block(block).cast<float>());
    pieces.push_back(std::move(arc));
  }
}

}  // namespace

std::vector<BoundaryPiece> boundary_pieces(
    const StokesProblem& problem, const std::vector<BlockDiagonalPreconditioner::Member>& alone) {
  std::vector<BoundaryPiece> pieces;
  std::map<const MatrixXd*, std::shared_ptr<const MatrixXf>> rounded;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    if (!is_inner(component)) {
      add_arcs(k, component.curve, pieces);
      continue;
    }
    auto& inverse = rounded[alone[k].inverse.get()];
    if (!inverse) inverse = std::make_shared<MatrixXf>(alone[k].inverse->cast<float>());
    BoundaryPiece body;
    body.component = k;
    body.curve = component.curve;
    body.disk.centre = component.centre;
    body.inverse = inverse;
    body.orientation = alone[k].orientation;
    pieces.push_back(std::move(body));
  }
  for (BoundaryPiece& piece : pieces) {
    piece.disk.radius = (piece.curve.x.array() - piece.disk.centre).abs().maxCoeff();
  }
  return pieces;
}

}  // namespace stokesbook
