#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "time_stepping/stepping_method.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup scene
/// @{

/// @name Background flows, in units of the user; x = (x, y)
/// @{

/// u = 0
struct QuiescentFlow {
  /// @return true when all members are equal
  bool operator==(const QuiescentFlow&) const = default;
};

/// u = velocity
struct UniformFlow {
  Complex velocity{};  ///< length / time

  /// @return true when all members are equal
  bool operator==(const UniformFlow&) const = default;
};

/// u = (rate y, 0)
struct ShearFlow {
  double rate = 0.0;  ///< 1 / time

  /// @return true when all members are equal
  bool operator==(const ShearFlow&) const = default;
};

/// u = rate (x, -y)
struct ExtensionalFlow {
  double rate = 0.0;  ///< 1 / time

  /// @return true when all members are equal
  bool operator==(const ExtensionalFlow&) const = default;
};

/// u = rate (cos x sin y, -sin x cos y), lengths in the user's unit
struct TaylorGreenFlow {
  double rate = 0.0;  ///< largest velocity, length / time

  /// @return true when all members are equal
  bool operator==(const TaylorGreenFlow&) const = default;
};

/// u = gradient x, with a trace-free gradient
struct LinearFlow {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  ///< 2 x 2, 1 / time

  /// @return true when all members are equal
  bool operator==(const LinearFlow&) const = default;
};
/// @}

/// Flow far from the bodies, in a scene without an outer wall.
using BackgroundFlow = std::variant<QuiescentFlow, UniformFlow, ShearFlow, ExtensionalFlow,
                                    TaylorGreenFlow, LinearFlow>;

/// @name Motions of a wall
/// @{

/// u = 0 on the wall
struct FixedWall {
  /// @return true when all members are equal
  bool operator==(const FixedWall&) const = default;
};

/// Rigid rotation about the wall's position
struct RotatingWall {
  double omega = 0.0;  ///< counter-clockwise, 1 / time

  /// @return true when all members are equal
  bool operator==(const RotatingWall&) const = default;
};

/// u = velocity on the wall
struct TranslatingWall {
  Complex velocity{};  ///< length / time

  /// @return true when all members are equal
  bool operator==(const TranslatingWall&) const = default;
};

/// u = gradient x on the wall, x in the laboratory frame; the curve itself stays
struct LinearWall {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  ///< 2 x 2, 1 / time

  /// @return true when all members are equal
  bool operator==(const LinearWall&) const = default;
};

/// Normal velocity `speed` into the fluid, on circles; the curve itself stays
struct RadialWall {
  double speed = 0.0;  ///< length / time

  /// @return true when all members are equal
  bool operator==(const RadialWall&) const = default;
};
/// @}

/// Velocity of the fluid on a wall.
using WallMotion = std::variant<FixedWall, RotatingWall, TranslatingWall, LinearWall, RadialWall>;

/// The side of a wall on which the fluid lies.
enum class WallRole {
  outer,  ///< encloses the fluid
  inner   ///< lies in the fluid
};

/// Stands for a number of collocation nodes that the solver chooses, `n_nodes = "auto"`.
inline constexpr int automatic_nodes = 0;

/// Curve with a given velocity.
struct Wall {
  WallRole role = WallRole::inner;  ///< where the fluid lies
  Shape shape{};                    ///< in its own frame
  Complex position{};               ///< of the frame's origin, length
  double orientation = 0.0;         ///< radians, counter-clockwise
  int n_nodes = automatic_nodes;    ///< collocation nodes, even, >= 8, or automatic
  WallMotion motion{};              ///< velocity on the curve

  /// @return true when all members are equal
  bool operator==(const Wall&) const = default;
};

/// Rigid body: free under a load, or held at a given velocity.
struct Body {
  Shape shape{};             ///< in its own frame
  Complex position{};        ///< of the frame's origin, length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force{};           ///< external load, force / length
  double torque = 0.0;       ///< external load about position, counter-clockwise, force
  bool held = false;         ///< true: velocity and omega prescribed, force and torque come out
  Complex velocity{};        ///< of a held body, length / time
  double omega = 0.0;        ///< of a held body, counter-clockwise, 1 / time
  int n_nodes = automatic_nodes;  ///< collocation nodes, even, >= 8, or automatic

  /// @return true when all members are equal
  bool operator==(const Body&) const = default;
};

/// Random, non-overlapping, reproducible placement of equal bodies.
struct Fill {
  Shape shape{};                               ///< of each body, in its own frame
  std::optional<double> area_fraction{};       ///< of the region, > 0 and < 1; or count is given
  std::optional<int> count{};                  ///< bodies, >= 1; or area_fraction is given
  std::optional<std::array<double, 4>> box{};  ///< xmin, ymin, xmax, ymax, length; none: the fluid
  double clearance = 0.0;                      ///< least gap between any two curves, length
  int n_nodes = automatic_nodes;               ///< collocation nodes of each body, or automatic

  /// @return true when all members are equal
  bool operator==(const Fill&) const = default;
};

/// How the sums over all nodes are evaluated.
enum class Summation {
  automatic,  ///< the plan decides
  direct,     ///< every pair of nodes
  fmm         ///< the fast multipole method
};

/// How integrals are corrected where a target is near a curve.
enum class NearSingular {
  automatic,      ///< the plan decides
  cauchy,         ///< spectral Cauchy scheme, see CauchyCurve
  interpolation,  ///< the scheme of the literature, see InterpolationCurve
  off             ///< not at all: gaps that need it are refused
};

/// Preconditioner of GMRES.
enum class PreconditionerKind {
  automatic,       ///< the plan decides
  none,            ///< none
  block_diagonal,  ///< every component alone, see BlockDiagonalPreconditioner
  clusters,        ///< every component among its neighbours, see ClusterPreconditioner
  direct           ///< the whole system, factorised, see DirectPreconditioner
};

/// How components see each other at one instant.
enum class Coupling {
  global,  ///< all at once, as they are
  local    ///< each sees the others' densities of the instant before, see
           ///< SuspensionSolver::solve_lagged(); for comparison
};

/// What a run writes.
enum class OutputFormat {
  csv,  ///< tables of bodies and walls
  vtk,  ///< polygons with data, for ParaView
  svg,  ///< pictures of the latest configuration and its fields
  html  ///< an animation, for browsers
};

/// A quantity of the flow that is written at the points of a grid.
enum class FieldQuantity {
  velocity,      ///< u, length / time
  pressure,      ///< p, force / length^2
  vorticity,     ///< d_1 u_2 - d_2 u_1, 1 / time
  shear_stress,  ///< sigma_12, force / length^2
  dissipation    ///< 2 mu e : e, force / (length time)
};

/// How one instant is solved.
struct SolverSettings {
  double tolerance = 1e-8;  ///< accuracy asked of velocities, see Solution::velocity_scale
  std::optional<double> gmres_tol{};           ///< relative residual; none: follows from tolerance
  int gmres_max_iterations = 500;              ///< the solve is refused if they do not do
  Summation summation = Summation::automatic;  ///< of the double layer
  NearSingular near_singular = NearSingular::automatic;               ///< corrections
  PreconditionerKind preconditioner = PreconditionerKind::automatic;  ///< of GMRES
  Coupling coupling = Coupling::global;                               ///< of components

  /// @return true when all members are equal
  bool operator==(const SolverSettings&) const = default;
};

/// Steps that grow and shrink with the effort of their solves, the heuristic of the literature.
struct EffortBounds {
  int few = 0;   ///< dt doubles after a step of fewer GMRES iterations
  int many = 0;  ///< dt halves after a step of more, > few

  /// @return true when all members are equal
  bool operator==(const EffortBounds&) const = default;
};

/// The error to which steps are adapted where none is given.
inline constexpr double default_step_tolerance = 1e-6;

/// The same in scenes with contact: by Heun's method, and past the jumps of contact.
inline constexpr double default_contact_step_tolerance = 1e-3;

/// How a run advances in time.
struct TimeSettings {
  double t_final = 0.0;        ///< end of the run, > 0; it starts at 0
  std::optional<double> dt{};  ///< longest step, > 0, time; of methods that adapt steps the first,
                               ///< none: chosen
  SteppingMethod method = SteppingMethod::dormand_prince54;  ///< that advances the bodies
  /// Error of positions in units of the largest body's radius, and of angles, radians, to which
  /// steps are adapted; none: the default for methods that adapt them, and steps stay as they are
  /// for Heun's, which adapts them in scenes with contact.
  std::optional<double> tolerance{};
  std::optional<double> dt_min{};        ///< least step, > 0; none: a millionth of the least of
                                         ///< t_final, dt and dt_max
  std::optional<double> dt_max{};        ///< longest step of methods that adapt, and by effort
  std::optional<EffortBounds> effort{};  ///< of methods of fixed steps; none: dt stays

  /// @return true when all members are equal
  bool operator==(const TimeSettings&) const = default;
};

/// Tells whether steps are adapted to their error.
///
/// @param  time  settings
/// @return       whether the method is an embedded one, or there is a tolerance for Heun's
constexpr bool adapts_steps(const TimeSettings& time) {
  return is_embedded(time.method) || time.tolerance.has_value();
}

/// How components are kept apart.
struct ContactSettings {
  double minimum_separation = 0.0;  ///< of all pairs, > 0: a length, or node spacings
  bool in_spacings =
      false;  ///< minimum_separation is in units of the bodies' mean node spacing, "0.05h"
  bool allow_close = false;  ///< starts with narrower gaps are taken, and these kept from narrowing

  /// @return true when all members are equal
  bool operator==(const ContactSettings&) const = default;
};

/// Which fields are written, and where; field_grid() says which points these are.
struct FieldSettings {
  std::array<double, 4> box{};  ///< xmin, ymin, xmax, ymax, length
  int resolution = 200;         ///< points along the longer side, 2 to 2000
  std::vector<FieldQuantity> quantities = {FieldQuantity::velocity,
                                           FieldQuantity::pressure};  ///< distinct, at least one

  /// @return true when all members are equal
  bool operator==(const FieldSettings&) const = default;
};

/// What a run writes, and when.
struct OutputSettings {
  std::optional<double> dt_write{};  ///< time between frames; none: every step
  std::vector<OutputFormat> formats = {OutputFormat::csv};  ///< distinct, at least one
  std::optional<FieldSettings> fields{};                    ///< none: no fields

  /// @return true when all members are equal
  bool operator==(const OutputSettings&) const = default;
};

/// A scene: all that a solver requires.
struct Scene {
  std::string title{};                   ///< for people
  std::uint64_t seed = 0;                ///< of all randomness
  double viscosity = 1.0;                ///< mu, > 0, force time / length^2
  BackgroundFlow flow{};                 ///< quiescent where a wall encloses the fluid
  std::optional<double> gauge_length{};  ///< Stokeslets are -log(r / gauge_length), length
  std::vector<double> reverse_at{};      ///< ascending times > 0 at which all driving changes sign
  std::vector<Wall> walls{};             ///< in file order
  std::vector<Body> bodies{};  ///< [[bodies]] first, then [[body_lists]], both in file order
  SolverSettings solver{};     ///< how one instant is solved
  std::optional<TimeSettings> time{};        ///< none: one solve at t = 0
  std::optional<ContactSettings> contact{};  ///< none: an overlap stops the run
  OutputSettings output{};                   ///< what is written

  /// @return true when all members are equal
  bool operator==(const Scene&) const = default;
};

/// Everything that a scene file contains, checked, with defaults filled in. place_fills() makes a
/// scene of it.
struct SceneFile {
  Scene scene{};              ///< without the bodies of the fills
  std::vector<Fill> fills{};  ///< in file order

  /// @return true when all members are equal
  bool operator==(const SceneFile&) const = default;
};

/// @}

}  // namespace stokesbook
