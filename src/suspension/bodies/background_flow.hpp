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

/// Evaluates how an undisturbed flow differs around a point from its velocity there. For flows that
/// are linear no digit is lost, however fast the flow is at the point.
///
/// @param  flow     kind and strength
/// @param  centre   the point, length
/// @param  offsets  from it, m vectors, length
/// @return          m differences of velocity, length / time
ComplexVector background_about(const BackgroundFlow& flow, Complex centre,
                               const ComplexVector& offsets);

/// Evaluates vorticity and strain of an undisturbed flow. Its pressure is zero: the linear flows
/// have none, and the Taylor-Green flow is driven by the force 2 mu u on every area of the fluid.
///
/// @param  flow    kind and strength
/// @param  points  m points, length
/// @return         m values, 1 / time
std::vector<FlowDerivatives> background_derivatives(const BackgroundFlow& flow,
                                                    const ComplexVector& points);

/// Returns how an undisturbed flow carries a body.
///
/// @param  flow    kind and strength
/// @param  centre  of the body, length
/// @return         velocity and rotation of the flow at the centre
RigidMotion carried_by(const BackgroundFlow& flow, Complex centre);

/// Evaluates an undisturbed flow on a free body without its rigid part, carried_by(). The solver
/// solves for the disturbance of this rest, so that its accuracy does not depend on how fast the
/// flow carries the body.
///
/// @param  flow  kind and strength
/// @param  body  its curve of N nodes and its centre
/// @return       velocities at the N nodes, length / time
ComplexVector strain_on(const BackgroundFlow& flow, const Component& body);

/// @}

}  // namespace stokesbook
