#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

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
  Complex velocity{};
  /// @return true when all members are equal
  bool operator==(const UniformFlow&) const = default;
};
/// u = (rate y, 0)
struct ShearFlow {
  double rate = 0.0;
  /// @return true when all members are equal
  bool operator==(const ShearFlow&) const = default;
};
/// u = rate (x, -y)
struct ExtensionalFlow {
  double rate = 0.0;
  /// @return true when all members are equal
  bool operator==(const ExtensionalFlow&) const = default;
};
/// u = rate (cos x sin y, -sin x cos y)
struct TaylorGreenFlow {
  double rate = 0.0;
  /// @return true when all members are equal
  bool operator==(const TaylorGreenFlow&) const = default;
};
/// u = gradient x, with a trace-free gradient
struct LinearFlow {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
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
  Complex velocity{};
  /// @return true when all members are equal
  bool operator==(const TranslatingWall&) const = default;
};
/// u = gradient x on the wall, x in the laboratory frame; the curve itself stays
struct LinearWall {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();
  /// @return true when all members are equal
  bool operator==(const LinearWall&) const = default;
};
/// Normal velocity `speed` into the fluid, on circles; the curve itself stays
struct RadialWall {
  double speed = 0.0;
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

/// Curve with a given velocity.
struct Wall {
  WallRole role = WallRole::inner;
  Shape shape{};
  Complex position{};
  double orientation = 0.0;  ///< radians, counter-clockwise
  int n_nodes = 0;
  WallMotion motion{};
  /// @return true when all members are equal
  bool operator==(const Wall&) const = default;
};

/// Rigid body: free under a load, or held at a given velocity.
struct Body {
  Shape shape{};
  Complex position{};
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force{};           ///< external load, force / length
  double torque = 0.0;       ///< external load about position, counter-clockwise
  bool held = false;         ///< true: velocity and omega prescribed, force and torque come out
  Complex velocity{};        ///< of a held body
  double omega = 0.0;        ///< of a held body
  int n_nodes = 0;
  /// @return true when all members are equal
  bool operator==(const Body&) const = default;
};

/// Random, non-overlapping, reproducible placement of equal bodies.
struct Fill {
  Shape shape{};
  std::optional<double> area_fraction{};  ///< exactly one of area_fraction and count is given
  std::optional<int> count{};
  std::optional<std::array<double, 4>> box{};  ///< xmin, ymin, xmax, ymax; none: all of the fluid
  double clearance = 0.0;                      ///< least gap between any two curves, length
  int n_nodes = 0;
  /// @return true when all members are equal
  bool operator==(const Fill&) const = default;
};

/// How the sums over all nodes are evaluated.
enum class Summation { automatic, direct };
/// How integrals are corrected where a target is near a curve.
enum class NearSingular { automatic, cauchy, off };
/// Preconditioner of GMRES.
enum class PreconditionerKind { automatic, none, block_diagonal };
/// Method that advances the bodies in time.
enum class SteppingMethod { euler, adams_bashforth2, rk4 };
/// What a run writes; svg is a picture of the configuration.
enum class OutputFormat { csv, vtk, svg };

/// How one instant is solved.
struct SolverSettings {
  double tolerance = 1e-8;  ///< accuracy asked of velocities, relative to the scene's largest
  std::optional<double> gmres_tol{};  ///< relative residual; none: follows from tolerance
  int gmres_max_iterations = 500;
  Summation summation = Summation::automatic;
  NearSingular near_singular = NearSingular::automatic;
  PreconditionerKind preconditioner = PreconditionerKind::automatic;
  /// @return true when all members are equal
  bool operator==(const SolverSettings&) const = default;
};

/// How a run advances in time.
struct TimeSettings {
  double t_final = 0.0;
  double dt = 0.0;
  SteppingMethod method = SteppingMethod::euler;
  /// @return true when all members are equal
  bool operator==(const TimeSettings&) const = default;
};

/// What a run writes, and when.
struct OutputSettings {
  std::optional<double> dt_write{};  ///< none: every step
  std::vector<OutputFormat> formats = {OutputFormat::csv};
  /// @return true when all members are equal
  bool operator==(const OutputSettings&) const = default;
};

/// Everything a scene file says, checked, with defaults filled in.
struct Scene {
  std::string title{};
  std::uint64_t seed = 0;
  double viscosity = 1.0;
  BackgroundFlow flow{};
  std::optional<double> gauge_length{};  ///< Stokeslets are -log(r / gauge_length)
  std::vector<double> reverse_at{};      ///< ascending times > 0 at which all driving changes sign
  std::vector<Wall> walls{};
  std::vector<Body> bodies{};  ///< [[bodies]] first, then [[body_lists]], both in file order
  std::vector<Fill> fills{};
  SolverSettings solver{};
  std::optional<TimeSettings> time{};
  OutputSettings output{};
  /// @return true when all members are equal
  bool operator==(const Scene&) const = default;
};

/// @}

}  // namespace stokesbook
