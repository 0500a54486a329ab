// Compares all preconditioners that were tried for bodies that nearly touch, on one dense system.
#include <cmath>

#include "closure/rigid_modes.hpp"
#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/dense.hpp"
#include "support/once.hpp"
#include "support/touching.hpp"
#include "suspension/system/preconditioner.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double node_tolerance = 1e-4;
constexpr int most_applications = 40;

using BodyIndices = std::vector<std::size_t>;

MatrixXd dense(const SuspensionOperator& system) {
  const Index n = system.offsets().back();
  MatrixXd matrix(2 * n, 2 * n);
  ComplexVector unit = ComplexVector::Zero(n);
  for (Index column = 0; column < 2 * n; ++column) {
    unit[column / 2] = column % 2 == 0 ? Complex{1.0} : imaginary;
    const ComplexVector velocity = system(unit);
    matrix.col(column) = interleaved(velocity);
    unit[column / 2] = 0.0;
  }
  return matrix;
}

/// Returns the scene with all bodies held. The Stokeslets have the gauge length of the clusters.
Scene held(Scene scene) {
  for (Body& body : scene.bodies) body.held = true;
  scene.gauge_length = 100.0;
  return scene;
}

/// Describes a hexagon of seven disks by the operators of free and held bodies, the rigid motions
/// and the neighbours.
class Hexagon {
 public:
  explicit Hexagon(double gap)
      : free_(test::disk_hexagon(1, gap, node_tolerance), ClusterForm::resistance),
        held_(test::with_preconditioner(held(test::disk_hexagon(1, gap, node_tolerance)),
                                        PreconditionerKind::none)),
        free_matrix(dense(free_.discrete.system)),
        held_matrix(dense(held_.discrete.system)) {
    const auto& components = free_.discrete.problem().components;
    const auto neighbours = cluster_neighbours(free_.configuration, free_.discretisation);
    const Index unknowns = free_matrix.rows(), count = static_cast<Index>(components.size());
    modes = MatrixXd::Zero(unknowns, 3 * count);
    projection = MatrixXd::Zero(3 * count, unknowns);
    for (Index k = 0; k < count; ++k) {
      const auto body = static_cast<std::size_t>(k);
      clusters.push_back({body});
      for (const Neighbour& other : neighbours[body]) clusters.back().push_back(other.component);
      set_modes(k, RigidModes(components[body].curve, components[body].centre));
    }
  }

  /// Returns the rows of the matrix that belong to some bodies.
  std::vector<Index> rows(const BodyIndices& bodies) const {
    std::vector<Index> rows;
    for (const std::size_t k : bodies) {
      for (Index i = 2 * first(k); i < 2 * first(k + 1); ++i) rows.push_back(i);
    }
    return rows;
  }

  GmresResult solve(const LinearMap& precondition) const {
    const ComplexVector rhs = free_.discrete.system.right_hand_side();
    return gmres([this](const VectorXd& v) -> VectorXd { return free_matrix * v; }, precondition,
                 interleaved(rhs), {1e-8, most_applications});
  }

  const LinearMap& shipped() const { return free_.discrete.precondition; }

 private:
  Index first(std::size_t body) const { return free_.discrete.system.offsets()[body]; }

  void set_modes(Index body, const RigidModes& rigid) {
    const Index begin = 2 * first(static_cast<std::size_t>(body)), n = rigid_size(body);
    const RigidMotion motions[] = {{1.0, 0.0}, {imaginary, 0.0}, {0.0, 1.0}};
    for (Index k = 0; k < 3; ++k) {
      const ComplexVector velocity = rigid.at_nodes(motions[k]);
      modes.block(begin, 3 * body + k, 2 * n, 1) = interleaved(velocity);
    }
    ComplexVector unit = ComplexVector::Zero(n);
    for (Index k = 0; k < 2 * n; ++k) {
      unit[k / 2] = k % 2 == 0 ? Complex{1.0} : imaginary;
      const RigidMotion motion = rigid.project(unit);
      projection.block(3 * body, begin + k, 3, 1) << motion.velocity.real(), motion.velocity.imag(),
          motion.omega;
      unit[k / 2] = 0.0;
    }
  }

  Index rigid_size(Index body) const {
    const auto k = static_cast<std::size_t>(body);
    return first(k + 1) - first(k);
  }

  test::Discretised free_, held_;

 public:
  MatrixXd free_matrix, held_matrix;  // A, A_h (13.4)
  MatrixXd modes, projection;         // K, Pi
  std::vector<BodyIndices> clusters;  // each body and its neighbours
};

using Approximate = MatrixXd (*)(const Hexagon& hexagon, const MatrixXd& matrix);

MatrixXd inverse_among(const Hexagon& hexagon, const MatrixXd& matrix, const BodyIndices& bodies) {
  const std::vector<Index> rows = hexagon.rows(bodies);
  return test::inverse(matrix(rows, rows));
}

MatrixXd blocks(const Hexagon& hexagon, const MatrixXd& matrix) {
  MatrixXd result = MatrixXd::Zero(matrix.rows(), matrix.cols());
  for (std::size_t k = 0; k < hexagon.clusters.size(); ++k) {
    const std::vector<Index> own = hexagon.rows({k});
    result(own, own) = inverse_among(hexagon, matrix, {k});
  }
  return result;
}

/// Returns the block-diagonal inverse plus a correction for each pair of neighbours. The correction
/// is the inverse for the pair minus the block-diagonal inverse of its two bodies.
MatrixXd additive_pairs(const Hexagon& hexagon, const MatrixXd& matrix) {
  const MatrixXd alone = blocks(hexagon, matrix);
  MatrixXd result = alone;
  for (const BodyIndices& cluster : hexagon.clusters) {
    for (const std::size_t other : cluster) {
      if (other <= cluster.front()) continue;
      const BodyIndices pair{cluster.front(), other};
      const std::vector<Index> rows = hexagon.rows(pair);
      result(rows, rows) += inverse_among(hexagon, matrix, pair) - alone(rows, rows);
    }
  }
  return result;
}

/// Returns the approximate inverse of the restricted additive Schwarz method. The rows of each body
/// are taken from the inverse for its cluster.
MatrixXd schwarz(const Hexagon& hexagon, const MatrixXd& matrix) {
  MatrixXd result = MatrixXd::Zero(matrix.rows(), matrix.cols());
  for (const BodyIndices& cluster : hexagon.clusters) {
    const std::vector<Index> own = hexagon.rows({cluster.front()}), all = hexagon.rows(cluster);
    result(own, all) = inverse_among(hexagon, matrix, cluster).topRows(own.size());
  }
  return result;
}

/// Returns the inverse of the matrix without the blocks between bodies that are not neighbours.
MatrixXd near_field(const Hexagon& hexagon, const MatrixXd& matrix) {
  MatrixXd near = MatrixXd::Zero(matrix.rows(), matrix.cols());
  for (const BodyIndices& cluster : hexagon.clusters) {
    const std::vector<Index> own = hexagon.rows({cluster.front()}), all = hexagon.rows(cluster);
    near(own, all) = matrix(own, all);
  }
  return test::inverse(near);
}

/// Constructs a preconditioner for the hexagon.
using Idea = std::function<LinearMap(const Hexagon&)>;

LinearMap product_with(MatrixXd inverse) {
  return [inverse = std::move(inverse)](const VectorXd& v) -> VectorXd { return inverse * v; };
}

Idea free_bodies(Approximate approximate) {
  return [=](const Hexagon& hexagon) {
    return product_with(approximate(hexagon, hexagon.free_matrix));
  };
}

/// Returns the inverse for free bodies from the inverse H for held bodies and the resistances R:
/// A^{-1} = H - (H K + K) R^{-1} Pi H, see (13.5).
MatrixXd let_go(const Hexagon& hexagon, const MatrixXd& inverse, const MatrixXd& resistance) {
  const MatrixXd motions = test::inverse(resistance) * (hexagon.projection * inverse);
  return inverse - (inverse * hexagon.modes + hexagon.modes) * motions;
}

Idea held_bodies(Approximate approximate) {
  return [=](const Hexagon& hexagon) {
    const MatrixXd inverse = approximate(hexagon, hexagon.held_matrix);
    return product_with(let_go(hexagon, inverse, hexagon.projection * inverse * hexagon.modes));
  };
}

/// Uses, as a planted defect, the resistances of all bodies together instead of the resistances of
/// the clusters.
LinearMap true_resistances(const Hexagon& hexagon) {
  const MatrixXd exact = test::inverse(hexagon.held_matrix);
  return product_with(let_go(hexagon, schwarz(hexagon, hexagon.held_matrix),
                             hexagon.projection * exact * hexagon.modes));
}

LinearMap none(const Hexagon&) {
  return {};
}

LinearMap shipped(const Hexagon& hexagon) {
  return hexagon.shipped();
}

const Hexagon& hexagon_of(double gap) {
  static test::Once<double, Hexagon> hexagons;
  return hexagons(gap, [=] { return Hexagon(gap); });
}

Measure residuals(const Idea& idea) {
  return [=](Size) {
    const Hexagon& hexagon = hexagon_of(1e-2);
    const std::vector<double> history = hexagon.solve(idea(hexagon)).history;
    std::vector<Measurement> measurements;
    for (std::size_t k = 1; k < history.size(); ++k) {
      measurements.push_back({.x = static_cast<double>(k), .error = history[k]});
    }
    return measurements;
  };
}

struct NamedIdea {
  std::string key, label;
  Idea idea;
};

std::vector<NamedIdea> all_ideas() {
  return {{"clusters", "held clusters", shipped},
          {"none", "no preconditioner", none},
          {"blocks", "block-diagonal", free_bodies(blocks)},
          {"pairs", "free pairs, added", free_bodies(additive_pairs)},
          {"schwarz", "free clusters", free_bodies(schwarz)},
          {"near", "near-field factorisation", free_bodies(near_field)},
          {"held_pairs", "held pairs, added", held_bodies(additive_pairs)}};
}

}  // namespace

Experiment ideas() {
  std::vector<Line> lines;
  for (const auto& [key, label, idea] : all_ideas()) {
    lines.push_back({.key = key, .label = label, .measure = residuals(idea)});
  }
  lines.front().claim = Claim{
      .id = "13_9",
      .statement = "With held clusters the residual falls by a digit or more in each iteration.",
      .law = Geometric{2.9, 0.25},
      .reason =
          "the bases leave out directions that bodies feel by 0.03 or less at this gap, and "
          "by 0.1 at most: rates from -log 0.1 = 2.3 to -log 0.03 = 3.5",
      .api = {"stokesbook::ClusterPreconditioner"}};
  lines.front().control =
      Control{"the true resistances in place of the clusters'", residuals(true_resistances)};
  return {.key = "ideas",
          .title = "Several preconditioners for a hexagon of seven disks, gap 0.01",
          .x = "applications of the operator, k",
          .error = "residual, relative to the right-hand side",
          .axes = Axes::semi_log,
          .lines = std::move(lines)};
}

}  // namespace stokesbook::verification::preconditioning
