#pragma once

#include "trapezoid/plane.hpp"

namespace stokesbook {

/// @addtogroup stiv
/// @{

/// The rigid motion of a component in one step, linear in \f$ \tau \in [0, 1] \f$:
/// \f$ c(\tau) = c + \tau\Delta c,\ \theta(\tau) = \theta + \tau\Delta\theta \f$.
struct RigidPath {
  Pose start;             ///< c and theta
  Complex displacement;   ///< Delta c, length; 0 for what is held
  double rotation = 0.0;  ///< Delta theta, radians; more than a turn is allowed

  /// Returns where the component is at a time.
  /// @param  tau  from 0 to 1
  /// @return      its frame
  Pose at(double tau) const {
    return {start.position + tau * displacement, start.orientation + tau * rotation};
  }
};

/// A component's frame as another component sees it: a point X of the one is at
/// \f$ z = shift + turn\,X \f$ in the frame of the other.
struct RelativeFrame {
  Complex shift;  ///< length
  Complex turn;   ///< of modulus 1

  /// Returns where a point is in the other's frame.
  /// @param  x  in the component's own frame, length
  /// @return    z, length
  Complex operator()(Complex x) const { return shift + turn * x; }

  /// Returns which point of the component is at a place of the other's frame.
  /// @param  z  in the other's frame, length
  /// @return    X, length
  Complex inverse(Complex z) const { return std::conj(turn) * (z - shift); }
};

/// The motion of a component A in one step, in the frame of a component B that moves too:
/// \f[ z(\tau) = R(-\theta_B)(c_A - c_B) + R(\theta_A-\theta_B)X. \f]
///
/// It depends on the difference of the displacements only, and is the same for any observer.
class RelativePath {
 public:
  /// @param  of    path of A
  /// @param  from  path of B, in whose frame A is seen
  RelativePath(const RigidPath& of, const RigidPath& from);

  /// Returns where A is at a time.
  /// @param  tau  from 0 to 1
  /// @return      its frame, seen from B
  RelativeFrame at(double tau) const;

  /// Returns where A is at the start.
  /// @return at(0)
  const RelativeFrame& start() const { return start_; }

  /// Returns where A is at the end.
  /// @return at(1)
  const RelativeFrame& end() const { return end_; }

  /// Bounds the speed of a point of A: \f$ \max_{\tau=0,1}|\Delta c_A - \Delta c_B -
  /// \Delta\theta_B(c_A-c_B)^\perp| + |\Delta\theta_A-\Delta\theta_B||X| \f$.
  ///
  /// The first term is the modulus of a vector that is linear in tau.
  /// @param  radius  |X|, length
  /// @return         bound of |dz/dtau|, length
  double speed_bound(double radius) const { return speed_ + std::abs(spin_) * radius; }

  /// Bounds how far a point of A strays from the chord between two of its places:
  /// \f$ \frac{\Delta\tau^2}{8}(\max_{\tau=0,1}|2\Delta\theta_B(\Delta c_A-\Delta c_B)^\perp +
  /// \Delta\theta_B^2(c_A-c_B)| + (\Delta\theta_A-\Delta\theta_B)^2|X|) \f$.
  ///
  /// That is the modulus of the second derivative, in which the first term is linear in tau again.
  /// @param  radius  |X|, length
  /// @param  step    Delta tau between the places
  /// @return         distance, length
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

/// @}

}  // namespace stokesbook
