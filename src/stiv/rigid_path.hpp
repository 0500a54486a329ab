#pragma once

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// The rigid motion of a component in one step, linear in \f$ \tau \in [0, 1] \f$:
/// \f$ c(\tau) = c + \tau\Delta c,\ \theta(\tau) = \theta + \tau\Delta\theta \f$.
struct RigidPath {
  Pose start;             ///< c and theta
  Complex displacement;   ///< Delta c, length; 0 for a component that is held
  double rotation = 0.0;  ///< Delta theta, radians; more than a turn is allowed

  /// Returns the pose of the component at a time.
  Pose at(double tau) const {
    return {start.position + tau * displacement, start.orientation + tau * rotation};
  }
};

/// The frame of a component, seen from the frame of another component: a point X of the first is at
/// \f$ z = shift + turn\,X \f$ in the frame of the second.
struct RelativeFrame {
  Complex shift;  ///< place of the first frame's origin, length
  Complex turn;   ///< rotation, a number of modulus 1

  /// Returns the place z of a point X in the second frame.
  Complex operator()(Complex x) const { return shift + turn * x; }

  /// Returns the point X of the component that is at a place z of the second frame.
  Complex inverse(Complex z) const { return std::conj(turn) * (z - shift); }
};

/// The motion of a component A in one step, in the frame of a component B that moves too (10.2):
/// \f[ z(\tau) = R(-\theta_B)(c_A - c_B) + R(\theta_A-\theta_B)X. \f]
///
/// The relative path depends only on the difference of the displacements, and is the same for any
/// observer.
class RelativePath {
 public:
  /// Makes the relative path of A from the paths of A and B.
  RelativePath(const RigidPath& a, const RigidPath& b);

  /// Returns the frame of A at a time from 0 to 1, seen from B.
  RelativeFrame at(double tau) const;

  const RelativeFrame& start() const { return start_; }  ///< returns the frame of A at the start
  const RelativeFrame& end() const { return end_; }      ///< returns the frame of A at the end

  /// Bounds the speed of a point of A with the radius |X|: \f$ \max_{\tau=0,1}|\Delta c_A -
  /// \Delta c_B - \Delta\theta_B(c_A-c_B)^\perp| + |\Delta\theta_A-\Delta\theta_B||X| \f$ (10.4).
  double speed_bound(double radius) const { return speed_ + std::abs(spin_) * radius; }

  /// Bounds the distance of a point of A from the chord between two places of its path:
  /// \f$ \frac{\Delta\tau^2}{8}(\max_{\tau=0,1}|2\Delta\theta_B(\Delta c_A-\Delta c_B)^\perp +
  /// \Delta\theta_B^2(c_A-c_B)| + (\Delta\theta_A-\Delta\theta_B)^2|X|) \f$.
  ///
  /// The radius is |X|, the step is the time \f$ \Delta\tau \f$ between the two places. The
  /// expression in parentheses bounds the second derivative of the path.
  double stray_bound(double radius, double step) const {
    return 0.125 * step * step * (bend_ + spin_ * spin_ * radius);
  }

 private:
  Complex offset_, drift_;           // c_A - c_B at the start, and its change
  double orientation_, spin_;        // theta_A - theta_B at the start, and its change
  double observer_, observer_spin_;  // theta_B at the start, and its change
  double speed_, bend_;              // bounds for the centre of A
  RelativeFrame start_, end_;
};

}  // namespace stokesbook
