#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "time_stepping/stepping_method.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// A scene that cannot be used. The message names the place, the wrong value and a right one:
/// `couette.toml:12:11: bodies[0].n_nodes = 31: must be an even integer >= 8 (try 32)`.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;  ///< takes the message
};

/// Amplitude in time that is always 1.
struct ConstantAmplitude {
  bool operator==(const ConstantAmplitude&) const = default;  ///< compares all members
};

/// Amplitude that jumps: has the value k from time k on, until the next time.
struct SteppedAmplitude {
  std::vector<double> times{};                               ///< ascending, the first is 0
  std::vector<double> values{};                              ///< as many as times
  bool operator==(const SteppedAmplitude&) const = default;  ///< compares all members
};

/// Amplitude that is linear between the values at given times, and constant before and after them.
struct RampedAmplitude {
  std::vector<double> times{};                              ///< ascending, >= 0, at least one
  std::vector<double> values{};                             ///< as many as times
  bool operator==(const RampedAmplitude&) const = default;  ///< compares all members
};

/// Amplitude \f$ m + a \cos(2\pi t / T + \phi) \f$.
struct OscillatingAmplitude {
  double mean = 0.0;                                             ///< m
  double swing = 1.0;                                            ///< a
  double period = 1.0;                                           ///< T > 0, time
  double phase = 0.0;                                            ///< phi, radians
  bool operator==(const OscillatingAmplitude&) const = default;  ///< compares all members
};

/// Factor of a flow, motion or load that depends on time.
using Amplitude =
    std::variant<ConstantAmplitude, SteppedAmplitude, RampedAmplitude, OscillatingAmplitude>;

/// Background flow of a fluid at rest: u = 0.
struct QuiescentFlow {
  bool operator==(const QuiescentFlow&) const = default;  ///< compares all members
};

/// Uniform flow: u = velocity.
struct UniformFlow {
  Complex velocity{};                                   ///< length / time
  bool operator==(const UniformFlow&) const = default;  ///< compares all members
};

/// Simple shear: u = (rate (y - c_2), 0) with the centre c.
struct ShearFlow {
  double rate = 0.0;                                  ///< 1 / time
  Complex centre{};                                   ///< point where u = 0, length
  bool operator==(const ShearFlow&) const = default;  ///< compares all members
};

/// Planar extension: u = rate (x - c_1, c_2 - y) with the centre c.
struct ExtensionalFlow {
  double rate = 0.0;                                        ///< 1 / time
  Complex centre{};                                         ///< point where u = 0, length
  bool operator==(const ExtensionalFlow&) const = default;  ///< compares all members
};

/// Taylor-Green vortices: u = rate (cos x sin y, -sin x cos y), with x and y in the user's unit.
struct TaylorGreenFlow {
  double rate = 0.0;                                        ///< largest velocity, length / time
  bool operator==(const TaylorGreenFlow&) const = default;  ///< compares all members
};

/// Linear flow: u = gradient (x - centre), where the gradient has trace zero.
struct LinearFlow {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  ///< 2 x 2, 1 / time
  Complex centre{};                                    ///< point where u = 0, length
  bool operator==(const LinearFlow&) const = default;  ///< compares all members
};

struct SumFlow;

/// Flow far from the bodies, in a scene without an outer wall.
using BackgroundFlow = std::variant<QuiescentFlow, UniformFlow, ShearFlow, ExtensionalFlow,
                                    TaylorGreenFlow, LinearFlow, SumFlow>;

/// Sum of flows: u is the sum of the velocities of all terms.
struct SumFlow {
  std::vector<BackgroundFlow> terms{};              ///< at least one
  bool operator==(const SumFlow&) const = default;  ///< compares all members
};

/// Velocities at points of a closed curve, in the frame of the curve, which are interpolated in the
/// parameter t of the shape; see boundary_velocity().
struct VelocityData {
  /// Rows (t, u, v): t ascending, >= 0 and < 2 pi, and the velocity, length / time; at least 4
  std::vector<std::array<double, 3>> rows{};
  bool operator==(const VelocityData&) const = default;  ///< compares all members
};

/// Tangential slip of a squirmer: the sum over k of B_k sin k t along the curve, counter-clockwise,
/// with the parameter t of the shape, which is the polar angle on a circle.
struct Squirmer {
  std::vector<double> modes{};                       ///< B_1, B_2, ..., length / time
  bool operator==(const Squirmer&) const = default;  ///< compares all members
};

/// Velocity of the fluid on a free body, relative to the rigid motion of the body.
using Slip = std::variant<Squirmer, VelocityData>;

/// Wall at rest: u = 0 on the wall.
struct FixedWall {
  bool operator==(const FixedWall&) const = default;  ///< compares all members
};

/// Rigid rotation of a wall about its position.
struct RotatingWall {
  double omega = 0.0;                                    ///< counter-clockwise, 1 / time
  bool operator==(const RotatingWall&) const = default;  ///< compares all members
};

/// Translation of a wall: u = velocity on the wall.
struct TranslatingWall {
  Complex velocity{};                                       ///< length / time
  bool operator==(const TranslatingWall&) const = default;  ///< compares all members
};

/// Linear velocity: u = gradient x on the wall, x in the laboratory frame; the curve does not move.
struct LinearWall {
  Eigen::Matrix2d gradient = Eigen::Matrix2d::Zero();  ///< 2 x 2, 1 / time
  bool operator==(const LinearWall&) const = default;  ///< compares all members
};

/// Normal velocity `speed` into the fluid, on circles only; the curve does not move.
struct RadialWall {
  double speed = 0.0;                                  ///< length / time
  bool operator==(const RadialWall&) const = default;  ///< compares all members
};

/// Velocity of a channel flow, u = speed (1 - (y / b)^2) along x in the frame of the wall, on
/// superellipses only, whose second semi-axis is b; the curve does not move.
struct ParabolicWall {
  double speed = 0.0;                                     ///< length / time
  bool operator==(const ParabolicWall&) const = default;  ///< compares all members
};

/// Velocity of the fluid on a wall. The curve of a wall with VelocityData does not move.
using WallMotion = std::variant<FixedWall, RotatingWall, TranslatingWall, LinearWall, RadialWall,
                                ParabolicWall, VelocityData>;

/// The side of a wall on which the fluid lies.
enum class WallRole {
  outer,  ///< encloses the fluid
  inner   ///< lies in the fluid
};

/// Value of `n_nodes`, `"auto"` in scene files, for which the solver chooses the number of nodes.
inline constexpr int automatic_nodes = 0;

/// A closed curve on which the velocity of the fluid is given.
struct Wall {
  WallRole role = WallRole::inner;               ///< the side on which the fluid lies
  Shape shape{};                                 ///< in its own frame
  Complex position{};                            ///< position of the frame's origin, length
  double orientation = 0.0;                      ///< radians, counter-clockwise
  int n_nodes = automatic_nodes;                 ///< collocation nodes, even, >= 8, or automatic
  WallMotion motion{};                           ///< velocity on the curve
  Amplitude amplitude{};                         ///< factor of the motion
  bool operator==(const Wall&) const = default;  ///< compares all members
};

/// A spring that pulls the position of a body to a centre: the force stiffness (centre - position).
struct Trap {
  double stiffness = 0.0;                        ///< > 0, force / length^2
  std::optional<Complex> centre{};               ///< length; none: the position at the start
  bool operator==(const Trap&) const = default;  ///< compares all members
};

/// Loads on a body that depend on its place or on time.
struct LoadLaws {
  Amplitude amplitude{};  ///< factor of force and torque, or of a held body's velocity and omega
  std::optional<double> density{};  ///< mass / length^2 of the plane; none: no weight
  std::optional<Trap> trap{};       ///< none: no trap
  Complex magnetic_moment{};        ///< in the frame of the shape, torque / MagneticField::field
  bool operator==(const LoadLaws&) const = default;  ///< compares all members
};

/// A rigid body: free under a given load, or held at a given velocity.
struct Body {
  Shape shape{};             ///< in its own frame
  Complex position{};        ///< position of the frame's origin, length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force{};           ///< external load, force / length
  double torque = 0.0;       ///< external load about position, counter-clockwise, force
  bool held = false;         ///< true: velocity and omega are given, force and torque are results
  Complex velocity{};        ///< velocity of a held body, length / time
  double omega = 0.0;        ///< rotation of a held body, counter-clockwise, 1 / time
  int n_nodes = automatic_nodes;                 ///< collocation nodes, even, >= 8, or automatic
  std::optional<Slip> slip{};                    ///< slip of a free body; none: no slip
  LoadLaws loads{};                              ///< loads beside force and torque
  bool operator==(const Body&) const = default;  ///< compares all members
};

/// A request for equal bodies at random places without overlap, reproducible by the seed.
struct Fill {
  Body body{};                            ///< each body, free, without its place
  std::optional<double> area_fraction{};  ///< part of the region, in (0, 1); none: count is given
  std::optional<int> count{};             ///< number of bodies, >= 1; none: area_fraction is given
  std::optional<std::array<double, 4>> box{};  ///< xmin, ymin, xmax, ymax, length; none: the fluid
  double clearance = 0.0;                      ///< least gap between any two curves, length
  bool operator==(const Fill&) const = default;  ///< compares all members
};

/// Gravity: each free body bears its weight minus its buoyancy.
struct Gravity {
  Complex acceleration{};                           ///< length / time^2
  double fluid_density = 0.0;                       ///< >= 0, mass / length^2 of the plane
  Amplitude amplitude{};                            ///< factor of the acceleration
  bool operator==(const Gravity&) const = default;  ///< compares all members
};

/// A uniform magnetic field: the torque on a body is (magnetic moment) x (field).
struct MagneticField {
  Complex field{};         ///< at the start, torque / LoadLaws::magnetic_moment
  double frequency = 0.0;  ///< turns of the field per time, counter-clockwise
  Amplitude amplitude{};   ///< factor of the field
  bool operator==(const MagneticField&) const = default;  ///< compares all members
};

/// Repulsion of all bodies from each other and from walls: the force strength exp(-gap / range) at
/// the closest points of two components.
struct Repulsion {
  double strength = 0.0;                              ///< force where curves touch, force / length
  double range = 0.0;                                 ///< > 0, length
  bool operator==(const Repulsion&) const = default;  ///< compares all members
};

/// Method that evaluates the sums over all nodes.
enum class Summation {
  automatic,  ///< the plan decides
  direct,     ///< all pairs of nodes
  fmm         ///< the fast multipole method
};

/// Method that corrects the integrals at targets near a curve.
enum class NearSingular {
  automatic,      ///< the plan decides
  cauchy,         ///< spectral Cauchy scheme, see CauchyCurve
  interpolation,  ///< the scheme of the literature, see InterpolationCurve
  off             ///< no correction: gaps that require one are refused
};

/// Preconditioner of GMRES.
enum class PreconditionerKind {
  automatic,       ///< the plan decides
  none,            ///< no preconditioner
  block_diagonal,  ///< the block of each component, see BlockDiagonalPreconditioner
  clusters,        ///< each component with its neighbours, see ClusterPreconditioner
  hierarchical,    ///< elimination in a tree of groups, see HierarchicalPreconditioner
  direct           ///< the factorised matrix of the system, see DirectPreconditioner
};

/// Coupling of the components at one instant.
enum class Coupling {
  global,  ///< one system for the densities of all components
  local    ///< each density by itself, see SuspensionSolver::solve_lagged(); for comparison
};

/// Kind of files that a run writes.
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

/// Settings for the solve at one instant.
struct SolverSettings {
  double tolerance = 1e-8;  ///< error allowed in velocities, relative to Solution::velocity_scale
  std::optional<double> gmres_tol{};           ///< relative residual; none: follows from tolerance
  int gmres_max_iterations = 500;              ///< a solve that needs more is refused
  Summation summation = Summation::automatic;  ///< method of the double-layer sums
  NearSingular near_singular = NearSingular::automatic;               ///< corrections near curves
  PreconditionerKind preconditioner = PreconditionerKind::automatic;  ///< preconditioner of GMRES
  Coupling coupling = Coupling::global;                               ///< coupling of components
  bool operator==(const SolverSettings&) const = default;             ///< compares all members
};

/// Bounds on the GMRES iterations of a step, by which the step length is adapted: the heuristic of
/// the literature.
struct EffortBounds {
  int few = 0;   ///< dt doubles after a step with fewer iterations
  int many = 0;  ///< dt halves after a step with more iterations; > few
  bool operator==(const EffortBounds&) const = default;  ///< compares all members
};

/// Default of TimeSettings::tolerance for embedded methods.
inline constexpr double default_step_tolerance = 1e-6;

/// Default of TimeSettings::tolerance for Heun's method in scenes with contact, where velocities
/// jump when contacts begin or end.
inline constexpr double default_contact_step_tolerance = 1e-3;

/// Largest ratio of solver.tolerance to time.tolerance. With larger ratios, the errors of
/// velocities would determine the estimated errors of steps, and shorten the steps until a run
/// takes a hundred times the work.
inline constexpr double most_solver_over_step = 100.0;

/// Settings for the time steps of a run.
struct TimeSettings {
  double t_final = 0.0;  ///< end of the run, > 0; the run starts at 0
  /// Longest step, > 0; the first step if steps are adapted; none, for embedded methods alone:
  /// chosen by the method
  std::optional<double> dt{};
  SteppingMethod method = SteppingMethod::dormand_prince54;  ///< method that advances the bodies
  /// Error of positions, in units of the largest body's radius, and of angles, in radians, to which
  /// steps are adapted; none: default_step_tolerance for embedded methods, else fixed steps
  std::optional<double> tolerance{};
  /// Shortest step, > 0; none: a millionth of the smallest of t_final, dt and dt_max
  std::optional<double> dt_min{};
  std::optional<double> dt_max{};        ///< longest step where steps are adapted
  std::optional<EffortBounds> effort{};  ///< for methods of fixed steps; none: dt is not adapted
  bool operator==(const TimeSettings&) const = default;  ///< compares all members
};

/// Returns whether steps are adapted to their error: by embedded methods, and by Heun's method with
/// a tolerance.
constexpr bool adapts_steps(const TimeSettings& time) {
  return is_embedded(time.method) || time.tolerance.has_value();
}

/// Settings for the forces that keep components apart.
struct ContactSettings {
  double minimum_separation = 0.0;  ///< least gap of all pairs, > 0: a length, or node spacings
  bool in_spacings = false;         ///< true: in units of the bodies' mean node spacing, "0.05h"
  bool allow_close = false;  ///< true: narrower gaps are accepted at the start and do not narrow
  bool operator==(const ContactSettings&) const = default;  ///< compares all members
};

/// Fields that a run writes, on the grid that field_grid() makes.
struct FieldSettings {
  std::array<double, 4> box{};  ///< xmin, ymin, xmax, ymax, length
  int resolution = 200;         ///< points along the longer side, 2 to 2000
  /// Distinct, at least one
  std::vector<FieldQuantity> quantities = {FieldQuantity::velocity, FieldQuantity::pressure};
  bool operator==(const FieldSettings&) const = default;  ///< compares all members
};

/// Settings for the files of a run.
struct OutputSettings {
  std::optional<double> dt_write{};  ///< time between frames; none: every step
  std::vector<OutputFormat> formats = {OutputFormat::csv};  ///< distinct, at least one
  std::optional<FieldSettings> fields{};                    ///< none: no fields
  bool nodes = false;                                       ///< true: also the values at nodes
  bool operator==(const OutputSettings&) const = default;   ///< compares all members
};

/// A periodic cell: all bodies repeat with the vectors of a lattice, which the flow carries along.
struct CellSettings {
  Eigen::Matrix2d vectors = Eigen::Matrix2d::Identity();  ///< rows: two vectors at t = 0, length
  Complex mean_velocity{};  ///< over the cell, bodies included, beside the flow; length / time
  std::optional<Complex> pressure_gradient{};  ///< mean over the cell, force / length^3; none: the
                                               ///< mean velocity is given
  bool operator==(const CellSettings&) const = default;  ///< compares all members
};

/// A scene: everything that a solver requires.
struct Scene {
  std::string title{};                   ///< title of pictures and animation
  std::uint64_t seed = 0;                ///< seed of all random numbers
  double viscosity = 1.0;                ///< mu, > 0, force time / length^2
  BackgroundFlow flow{};                 ///< quiescent if a wall encloses the fluid
  std::optional<double> gauge_length{};  ///< length in the Stokeslets' -log(r / gauge_length)
  Amplitude flow_amplitude{};            ///< factor of the flow
  std::optional<CellSettings> cell{};    ///< none: nothing repeats
  /// Ascending times > 0 at which flow, motions, gravity, given forces and torques change sign
  std::vector<double> reverse_at{};
  std::optional<Gravity> gravity{};               ///< none: no weight, no buoyancy
  std::optional<MagneticField> magnetic_field{};  ///< none: no field
  std::optional<Repulsion> repulsion{};           ///< none: no repulsion
  std::vector<Wall> walls{};                      ///< in file order
  std::vector<Body> bodies{};      ///< [[bodies]] first, then [[body_lists]], both in file order
  std::vector<Complex> tracers{};  ///< points that the fluid carries; without those outside it
  SolverSettings solver{};         ///< for the solve at one instant
  std::optional<TimeSettings> time{};             ///< none: one solve at t = 0
  std::optional<ContactSettings> contact{};       ///< none: an overlap stops the run
  OutputSettings output{};                        ///< for the files of the run
  bool operator==(const Scene&) const = default;  ///< compares all members
};

/// Contents of a scene file, checked, with defaults filled in; place_fills() makes it a Scene.
struct SceneFile {
  Scene scene{};                                      ///< without the bodies of the fills
  std::vector<Fill> fills{};                          ///< in file order
  bool operator==(const SceneFile&) const = default;  ///< compares all members
};

/// Returns whether a wall encloses the fluid.
bool is_enclosed(const Scene& scene);

/// Returns the only wall with a given role; null if there is none, or more than one.
const Wall* only_wall(const Scene& scene, WallRole role);

/// Returns whether velocities on a wall or body of a scene are interpolated from VelocityData.
bool has_velocity_data(const Scene& scene);

/// Returns whether a scene is a Couette cell, in which the torque on the inner wall measures an
/// effective viscosity: one outer and one inner wall, each fixed or rotating, at different rates
/// whose ratio does not change in time.
bool is_couette_cell(const Scene& scene);

}  // namespace stokesbook
