// Computes the resistance and the mobility matrix of the free bodies of a scene, column by column,
// by the two problems of chapter 03.
#include "suspension/solver/matrices.hpp"

#include <array>

#include "suspension/solver/solver.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Names = std::array<const char*, 3>;
constexpr Names motion_names{"ux", "uy", "omega"}, load_names{"fx", "fy", "torque"};

// Divides each entry by the roots of the diagonal entries of its row and column.
MatrixXd scaled(const MatrixXd& matrix) {
  const VectorXd unit = matrix.diagonal().cwiseSqrt().cwiseInverse();
  return unit.asDiagonal() * matrix * unit.asDiagonal();
}

double asymmetry(const MatrixXd& matrix) {
  const MatrixXd unit = scaled(matrix);
  return (unit - unit.transpose()).cwiseAbs().maxCoeff();
}

std::string table(const MatrixXd& matrix, const std::vector<std::size_t>& bodies, const Names& rows,
                  const Names& columns) {
  const auto name = [&](const Names& names, Index i) {
    return names[static_cast<std::size_t>(i % 3)] +
           std::to_string(bodies[static_cast<std::size_t>(i / 3)]);
  };
  std::string text = "row";
  for (Index j = 0; j < matrix.cols(); ++j) text += ',' + name(columns, j);
  for (Index i = 0; i < matrix.rows(); ++i) {
    text += '\n' + name(rows, i);
    for (const double entry : matrix.row(i)) text += ',' + exact_number(entry);
  }
  return text + '\n';
}

}  // namespace

HydrodynamicMatrices hydrodynamic_matrices(const Scene& scene) {
  std::vector<std::size_t> free;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (!scene.bodies[k].held) free.push_back(k);
  }
  if (free.empty()) {
    throw SolverError(
        "the matrices belong to free bodies, and the scene has none: set held = "
        "false for at least one body");
  }
  if (free.size() == scene.bodies.size() && scene.walls.empty() && !scene.gauge_length &&
      !scene.cell) {
    throw SolverError(
        "a mobility matrix requires forces that do not balance, which cause infinite velocities in "
        "an unbounded fluid (Stokes' paradox): give flow.gauge_length, a wall or a held body");
  }
  const auto size = static_cast<Index>(3 * free.size());
  HydrodynamicMatrices matrices{MatrixXd(size, size), MatrixXd(size, size), free};
  Scene loaded = scene;
  loaded.flow = {};
  loaded.contact.reset();
  if (scene.cell) loaded.cell = CellSettings{scene.cell->vectors};
  const SuspensionSolver mobility(loaded);
  const Instant start = mobility.start();
  const Forcing none = scaled(0.0, start.forcing);
  for (Index kind = 0; kind < 3; ++kind) {
    const Complex along = kind == 0 ? 1.0 : kind == 1 ? imaginary : 0.0;
    const double turn = kind == 2 ? 1.0 : 0.0;
    // All bodies have the unit motion of this kind; the forcing selects one of them.
    Scene moved = loaded;
    for (const std::size_t k : free) {
      moved.bodies[k].held = true;
      moved.bodies[k].velocity = along;
      moved.bodies[k].omega = turn;
    }
    const SuspensionSolver resistance(moved);
    for (Index j = kind; j < size; j += 3) {
      const std::size_t driven = free[static_cast<std::size_t>(j / 3)];
      Instant unit_load = start, unit_motion = start;
      unit_load.forcing = unit_motion.forcing = none;
      unit_load.forcing.loads[driven] = {along, turn};
      unit_motion.forcing.motions[driven] = 1.0;
      const Solution moving = mobility.solve(unit_load);
      const Solution loading = resistance.solve(unit_motion);
      for (Index k = 0; k < std::ssize(free); ++k) {
        const std::size_t body = free[static_cast<std::size_t>(k)];
        const auto& [velocity, omega] = moving.motions[body];
        const auto& [force, torque] = loading.loads[body];
        matrices.mobility.col(j).segment<3>(3 * k) << velocity.real(), velocity.imag(), omega;
        matrices.resistance.col(j).segment<3>(3 * k) << force.real(), force.imag(), torque;
      }
    }
  }
  return matrices;
}

MatrixErrors matrix_errors(const HydrodynamicMatrices& matrices) {
  const auto& [resistance, mobility, bodies] = matrices;
  // The product maps loads to loads: a row has the unit of its load, a column its inverse.
  const VectorXd unit = mobility.diagonal().cwiseSqrt();
  const MatrixXd product =
      unit.asDiagonal() * (resistance * mobility) * unit.cwiseInverse().asDiagonal();
  const MatrixXd identity = MatrixXd::Identity(product.rows(), product.cols());
  return {asymmetry(resistance), asymmetry(mobility), (product - identity).cwiseAbs().maxCoeff()};
}

std::string resistance_table(const HydrodynamicMatrices& matrices) {
  return table(matrices.resistance, matrices.bodies, load_names, motion_names);
}

std::string mobility_table(const HydrodynamicMatrices& matrices) {
  return table(matrices.mobility, matrices.bodies, motion_names, load_names);
}

}  // namespace stokesbook
