#pragma once

#include <vector>

#include "closure/problem.hpp"
#include "closure/rigid_modes.hpp"
#include "double_layer/flow_derivatives.hpp"
#include "scene/scene.hpp"
#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Evaluates an undisturbed flow at points of the plane.
///
/// @param  flow    kind and strength
/// @param  points  m points, length
/// @return         m velocities, length / time
ComplexVector background_velocity(const BackgroundFlow& flow, const ComplexVector& points);

/// Evaluates the velocity of an undisturbed flow near a point, minus the velocity at this point:
/// \f$ u_\infty(c + d) - u_\infty(c) \f$.
///
/// For linear flows the difference is computed from the offsets d alone: no digits cancel, however
/// fast the flow is at the point.
/// @param  flow     kind and strength
/// @param  centre   the point c, length
/// @param  offsets  d, m vectors, length
/// @return          m differences of velocity, length / time
ComplexVector background_about(const BackgroundFlow& flow, Complex centre,
                               const ComplexVector& offsets);

/// Evaluates vorticity and strain of an undisturbed flow.
///
/// The pressure of an undisturbed flow is zero: linear flows have no pressure gradient, and the
/// Taylor-Green flow is driven by the body force 2 mu u per unit of area.
/// @param  flow    kind and strength
/// @param  points  m points, length
/// @return         m values, 1 / time
std::vector<FlowDerivatives> background_derivatives(const BackgroundFlow& flow,
                                                    const ComplexVector& points);

/// Returns the rigid motion with which an undisturbed flow carries a body: the velocity and half
/// the vorticity of the flow, at the centre of the body.
///
/// @param  flow    kind and strength
/// @param  centre  of the body, length
/// @return         velocity, length / time, and angular velocity, 1 / time
RigidMotion carried_by(const BackgroundFlow& flow, Complex centre);

/// Evaluates an undisturbed flow on a free body, without the rigid motion carried_by().
///
/// The solver solves for the disturbance by this remainder. The accuracy of the solution therefore
/// does not depend on how fast the flow carries the body.
/// @param  flow  kind and strength
/// @param  body  body with its curve of N nodes and its centre
/// @return       velocities at the N nodes, length / time
ComplexVector strain_on(const BackgroundFlow& flow, const Component& body);

/// @}

}  // namespace stokesbook
