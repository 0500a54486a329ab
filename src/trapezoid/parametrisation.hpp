#pragma once

#include <functional>

#include "trapezoid/fourier.hpp"
#include "trapezoid/shape.hpp"

namespace stokesbook {

/// A closed curve as a function of its parameter t, of period \f$ 2\pi \f$. The function returns
/// x(t), x'(t) and x''(t), length.
using Parametrisation = std::function<TrigonometricPolynomial::Jet(double)>;

/// Parametrises a shape counter-clockwise, in the frame of the shape.
///
/// The parametrisation of a NodalCurve is its trigonometric interpolant. Points and derivatives are
/// exact to rounding.
/// @par Cost  O(1) per point; for a NodalCurve with p points O(p)
Parametrisation parametrisation(const Shape& shape);

/// Returns the points of a NodalCurve in counter-clockwise order.
ComplexVector counter_clockwise(const NodalCurve& shape);

}  // namespace stokesbook
