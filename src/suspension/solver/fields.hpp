#pragma once

#include <functional>
#include <map>
#include <string>

#include "record/field.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Evaluates the quantities that a scene asks for on its grid.
///
/// The pressure is zero far away in an unbounded fluid; in an enclosed one, where it is known up to
/// a constant, its mean over the outer wall is zero.
/// @param  solver    of a scene with output.fields
/// @param  solution  of any instant
/// @return           the field, not a number outside the fluid
/// @throws std::invalid_argument when the scene asks for no fields
/// @par Accuracy  at any distance from the boundary: velocity as @ref claim_06_1, all others as
/// @ref claim_06_8
/// @par Cost      that of in_fluid(), and m n kernel evaluations for m points in the fluid and n
/// nodes: once for the velocity, once for all others
Field evaluate_field(const SuspensionSolver& solver, const Solution& solution);

/// Errors by quantity: "velocity", or as field_scalars names them.
using FieldErrors = std::map<std::string, double, std::less<>>;

/// Compares two fields on one grid.
///
/// @param  p  one
/// @param  q  the other one, of the same quantities
/// @return    largest difference of each quantity at a point, over the largest value of q
FieldErrors field_differences(const Field& p, const Field& q);

/// A field, and how wrong it may be.
struct EstimatedField {
  Field field;         ///< as evaluate_field() returns it
  FieldErrors errors;  ///< estimates, relative to the largest value of each quantity
  int solves = 0;      ///< that it took
  SolveCost cost{};    ///< of these
};

/// Evaluates the quantities that a scene asks for, and estimates their errors.
///
/// Derivatives of the velocity ask for more nodes than velocities of bodies do. The estimate is
/// twice the largest change of a quantity at a point of the grid by a quarter more nodes and a
/// smaller residual, see SuspensionSolver::refined(). Where nodes are automatic, they are raised
/// until all estimates meet the tolerance, six times at most, and the field is that of the most
/// nodes.
/// @param  solver    of a scene with output.fields
/// @param  solution  with forces of contact or none
/// @return           the field and its errors, infinite where they cannot be estimated
/// @throws std::invalid_argument when the scene asks for no fields
/// @par Accuracy  errors are at most twice their estimates, @ref claim_12_60
/// @par Cost      of each estimate, refined() and evaluate_field()
EstimatedField estimated_field(const SuspensionSolver& solver, const Solution& solution);

/// @}

}  // namespace stokesbook
