#pragma once

#include <array>
#include <compare>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "periodic/lattice.hpp"
#include "record/field.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// A body at one time, in the user's units.
struct BodyState {
  Complex position;          ///< length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex velocity;          ///< length / time
  double omega = 0.0;        ///< counter-clockwise, 1 / time
  Complex force;             ///< force of the body on the fluid, force / length
  double torque = 0.0;       ///< torque on the fluid about position, counter-clockwise, force
};

/// A wall at one time, in the user's units.
struct WallLoad {
  Complex position;          ///< length
  double orientation = 0.0;  ///< radians, counter-clockwise
  Complex force;             ///< force of the wall on the fluid, force / length
  double torque = 0.0;       ///< torque on the fluid about position, counter-clockwise, force
};

/// The rheology of a periodic cell.
struct CellRheology {
  /// Mean stress; rows: the direction of the force, columns: that of the normal; force / length^2.
  Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
  /// Share of the forces of contact and repulsion themselves in the mean stress, force / length^2.
  Eigen::Matrix2d contact_stress = Eigen::Matrix2d::Zero();
  double viscosity = 0.0;          ///< not a number in a flow without strain; force time / length^2
  double particle_pressure = 0.0;  ///< beside the fluid's mean pressure, force / length^2
  double dissipation_by_traction = 0.0;  ///< Rheology::dissipation, from the tractions

  /// Returns the first normal stress difference, force / length^2.
  double normal_stress_difference() const { return stress(0, 0) - stress(1, 1); }
};

/// Properties of the whole suspension; a property that the scene does not define is not a number.
struct Rheology {
  static constexpr double undefined = std::numeric_limits<double>::quiet_NaN();  ///< not a number

  double dissipation = undefined;           ///< power per unit length, force / time
  double torque_ratio = undefined;          ///< Couette cells: torque with over without bodies
  double order_parameter = undefined;       ///< 1: long axes along the flow, -1: across it
  Complex stresslet{undefined, undefined};  ///< S_11 + i S_12, sum over all components, force
  Complex uniform_velocity{undefined, undefined};  ///< velocity of the fluid at infinity beside the
                                                   ///< background, if it is solved for
  std::optional<CellRheology> cell{};              ///< none in scenes without a periodic cell
};

/// A body or wall in contact.
struct ContactParty {
  bool is_wall = false;    ///< true for a wall, false for a body
  std::size_t number = 0;  ///< index in the scene's list of bodies or walls
  /// Compares kinds, then numbers.
  friend auto operator<=>(const ContactParty&, const ContactParty&) = default;

  /// Returns the component's number in files: 0, 1, ... for bodies, and -1, -2, ... for walls.
  long id() const { return is_wall ? -1 - static_cast<long>(number) : static_cast<long>(number); }
};

/// A contact force, which keeps two components apart. In a periodic cell, it may act between the
/// first component and an image of the second one, or of the first one.
struct ContactForce {
  ContactParty a;        ///< the first component
  ContactParty b;        ///< the second component
  Complex point;         ///< point where the force acts, length
  Complex normal;        ///< direction of the force on a, unit vector
  double force = 0.0;    ///< >= 0, force / length
  double gap = 0.0;      ///< gap of the curves at the end of the step with this force, length
  LatticeIndex image{};  ///< of the image of b, relative to the path of b
  Complex shift{};       ///< lattice vector from b to this image when the force acts, length
};

/// The flow at a node of a component.
struct NodeValues {
  ContactParty component;  ///< body or wall
  Complex position;        ///< length
  Complex normal;          ///< unit vector out of the fluid
  double weight = 0.0;     ///< weight of the node in integrals over the arclength, length
  Complex traction;        ///< force per length of the component on the fluid, force / length^2
  Complex density;         ///< density of the double layer, length / time
};

/// The periodic cell at one time.
struct FrameCell {
  Lattice lattice;                ///< in the basis of the scene, which the flow carries along
  Complex centre;                 ///< centre of the cell, length
  std::vector<BodyState> bodies;  ///< images, in the cell, of the bodies, which lie on their paths
};

/// The configuration at a written time, with its velocities, loads and other results.
struct Frame {
  double t = 0.0;                        ///< time
  std::vector<BodyState> bodies;         ///< in the scene's order
  std::vector<WallLoad> walls;           ///< in the scene's order
  Rheology rheology{};                   ///< rheology of the whole suspension
  std::vector<ContactForce> contacts{};  ///< contact forces of the step that begins at t
  std::optional<Field> field{};          ///< none unless the scene requests fields
  std::vector<Complex> tracers{};        ///< positions of the tracers, length
  std::vector<NodeValues> nodes{};       ///< none unless the scene requests them
  std::optional<FrameCell> cell{};       ///< none: nothing repeats
};

/// Replaces bodies, tracers and contacts by their images in the periodic cell, for pictures.
/// @throws std::bad_optional_access when the frame has no cell
Frame in_cell(Frame frame);

/// Returns where the lines of a contact end: at the position of a, and at that of b or of its image
/// in contact; at walls, the end is the contact point.
std::array<Complex, 2> contact_ends(const Frame& frame, const ContactForce& contact);

/// A closed curve in its own frame, for pictures.
struct Outline {
  ComplexVector points;   ///< in order, without a repetition of the first point, length
  bool encloses = false;  ///< true: the fluid lies inside (outer wall)
};

/// The outlines of all components.
struct Outlines {
  std::vector<Outline> bodies{};  ///< in the order of Frame::bodies
  std::vector<Outline> walls{};   ///< in the order of Frame::walls
};

/// Returns the points of an outline in the laboratory frame, \f$ c + e^{i\theta} x \f$, with the
/// position c and the orientation theta of a BodyState or WallLoad.
ComplexVector placed(const Outline& outline, const auto& state) {
  return (outline.points.array() * std::polar(1.0, state.orientation) + state.position).matrix();
}

/// Throws std::invalid_argument unless every body and wall of a frame has its outline, and the
/// components of every contact exist.
void require_outlines(const Frame& frame, const Outlines& outlines);

/// Results and cost of one time step; @ref record defines the errors and the numbers on contact.
struct StepInfo {
  double t = 0.0;                 ///< time at the end of the step
  double dt = 0.0;                ///< length of the step, time
  int gmres_iterations = 0;       ///< GMRES iterations of all solves of the step
  int matvecs = 0;                ///< applications of the operator
  int ncp_iterations = 0;         ///< iterations of the contact solver; 0 without contact
  int contacts = 0;               ///< number of pairs in contact
  double min_gap = 0.0;           ///< least distance of two curves, length; infinite for one curve
  double residual = 0.0;          ///< largest relative residual of the linear solves
  double velocity_error = 0.0;    ///< estimated error of velocities, relative to their scale
  double step_error = 0.0;        ///< estimated error of this step, in radii and radians
  double seconds = 0.0;           ///< wall time of the solves
  double kkt_residual = 0.0;      ///< error of complementarity, in minimum separations
  double force_imbalance = 0.0;   ///< net contact force over the largest force on a component
  double torque_imbalance = 0.0;  ///< net torque over this force and a lever, see imbalance()
  double contact_power = 0.0;     ///< power of the contact forces, force / time
  double energy_injected = 0.0;   ///< work of contact forces, positive part only, force
};

}  // namespace stokesbook
