#pragma once

#include <functional>

#include "trapezoid/fourier.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// @addtogroup trapezoid
/// @{

/// A curve as a function of its parameter, of period \f$ 2\pi \f$: x(t), x'(t) and x''(t), length.
using Parametrisation = std::function<TrigonometricPolynomial::Jet(double)>;

/// Parametrises a shape in its own frame, counter-clockwise; a NodalCurve by its trigonometric
/// interpolant.
///
/// @param  shape  in its own frame
/// @return        evaluates points and derivatives, exact to rounding
/// @par Cost      O(1) a point; for a NodalCurve with p points O(p)
Parametrisation parametrisation(const Shape& shape);

/// Orders the points of a NodalCurve counter-clockwise.
///
/// @param  shape  points in either sense
/// @return        its points, length
ComplexVector counter_clockwise(const NodalCurve& shape);

/// @}

}  // namespace stokesbook
