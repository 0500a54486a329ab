#pragma once

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "double_layer/flow_derivatives.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// Returns the undisturbed flow of a scene: in a periodic cell, with the mean velocity of the cell.
BackgroundFlow undisturbed_flow(const Scene& scene);

/// Evaluates the velocity of an undisturbed flow at m points.
ComplexVector background_velocity(const BackgroundFlow& flow, const ComplexVector& points);

/// Evaluates vorticity and strain of an undisturbed flow at a point, 1 / time.
///
/// The pressure of an undisturbed flow is zero: linear flows have no pressure gradient, and the
/// Taylor-Green flow is driven by the body force 2 mu u per unit of area.
FlowDerivatives background_derivatives(const BackgroundFlow& flow, Complex point);

/// Returns the rigid motion with which an undisturbed flow carries a body: the velocity and half
/// the vorticity of the flow at the centre of the body.
RigidMotion background_rigid_motion(const BackgroundFlow& flow, Complex centre);

/// Evaluates the straining part of an undisturbed flow at the nodes of a free body: the velocity
/// \f$ u_\infty(c+d) - u_\infty(c) - \Omega_\infty d^\perp \f$ without background_rigid_motion().
///
/// The solver solves for the disturbance by this remainder. For sums of linear flows it depends
/// on the offsets d from the centre c alone, so that the accuracy of the solution does not depend
/// on how fast the flow carries the body.
ComplexVector straining_velocity(const BackgroundFlow& flow, const Component& body);

}  // namespace stokesbook
