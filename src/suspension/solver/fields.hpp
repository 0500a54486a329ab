#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "record/field.hpp"
#include "record/run_data.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// Places the points of a grid in its box.
///
/// The longer side of the box has `resolution` points, the first and the last of them at its ends.
/// Cells are square. The shorter side has the number of cells that fits best, at least one. The
/// grid is centred in the box.
FieldGrid field_grid(const FieldSettings& settings);

/// A component that covers a point, or whose image covers it.
struct Covering {
  std::size_t component;  ///< number of the component
  Complex shift;          ///< lattice vector from the component to the image, length; else 0
};

/// Finds the component that covers each point: a body or inner wall about the point, or an
/// enclosing wall with the point outside; by Barycentric::side().
///
/// @param  part   points are first moved towards the fluid, by this part of their distance from the
///                position of the component
/// @param  cell   all components repeat with its lattice; none: nothing repeats
/// @return        one per point: a component that covers the point; none in the fluid
/// @par Accuracy  if shapes are resolved, points farther from the boundary than 1e-12 of a
/// component's size are assigned correctly, also between nodes: @ref claim_06_25
/// @par Cost      a search in a RectangleIndex per point, O(N) for a point inside a bounding circle
std::vector<std::optional<Covering>> covering_components(
    const Configuration& configuration, const Discretisation& discretisation,
    const ComplexVector& points, double part = 0.0, const std::optional<PeriodicCell>& cell = {});

/// Returns 1 for each point in the fluid, and 0 for each point that covering_components() assigns
/// to a component.
std::vector<std::uint8_t> in_fluid(const Configuration& configuration,
                                   const Discretisation& discretisation,
                                   const ComplexVector& points,
                                   const std::optional<PeriodicCell>& cell = {});

/// Evaluates the quantities that a scene requests, on the grid of the scene.
///
/// In an unbounded fluid the pressure is zero far away. In an enclosed fluid the pressure is known
/// up to a constant only, and its mean over the outer wall is set to zero. In a periodic cell the
/// pressure is that of SuspensionSolver::derivatives().
/// @throws std::invalid_argument when the scene requests no fields
/// @par Accuracy  at any distance from the boundary: velocity as @ref claim_06_1, all others as
/// @ref claim_06_8
/// @par Cost      that of in_fluid(); two sums, one for the velocity and one for all others
Field evaluate_field(const SuspensionSolver& solver, const Solution& solution);

/// Evaluates tractions and densities at all nodes, components in order.
///
/// The pressure in the tractions is that of evaluate_field(). There is no estimate of the errors:
/// the values of SuspensionSolver::solve_refined() show them.
/// @par Cost  that of SuspensionSolver::derivatives()
std::vector<NodeValues> node_values(const SuspensionSolver& solver, const Solution& solution);

/// Errors by quantity. The keys are "velocity" and the names in field_scalars.
using FieldErrors = std::map<std::string, double, std::less<>>;

/// Compares two fields with the same quantities on one grid.
/// @return largest difference of each quantity at a point, over the largest value in q
FieldErrors field_differences(const Field& p, const Field& q);

/// A field with its estimated errors.
struct EstimatedField {
  Field field;         ///< the result of evaluate_field()
  FieldErrors errors;  ///< estimates, relative to the largest value of each quantity
  int solves = 0;      ///< number of solves on more nodes
  SolveCost cost{};    ///< cost of these solves
};

/// Evaluates the quantities that a scene requests, and estimates their errors.
///
/// Derivatives of the velocity require more nodes than the velocities of bodies. The estimate of a
/// quantity is twice its largest change, at a point of the grid, by a quarter more nodes and a
/// smaller residual, see SuspensionSolver::solve_refined(). If nodes are automatic, their number is
/// increased, at most six times, until all estimates meet the tolerance; the field is then that of
/// the solution with the most nodes.
/// @param  solution  with or without contact forces
/// @return           the field and its errors; infinite errors if they cannot be estimated
/// @throws std::invalid_argument when the scene requests no fields
/// @par Accuracy  errors are at most twice their estimates, @ref claim_12_60
/// @par Cost      that of solve_refined() and evaluate_field() per estimate
EstimatedField estimated_field(const SuspensionSolver& solver, const Solution& solution);

}  // namespace stokesbook
