// Describes the motion of a component in the frame of another one (10.2), with bounds of its speed
// (10.4) and of its distance from chords.
#include "stiv/rigid_path.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

RelativePath::RelativePath(const RigidPath& a, const RigidPath& b)
    : offset_(a.start.position - b.start.position),
      drift_(a.displacement - b.displacement),
      orientation_(a.start.orientation - b.start.orientation),
      spin_(a.rotation - b.rotation),
      observer_(b.start.orientation),
      observer_spin_(b.rotation) {
  // centre_speed is the first term of (10.4), centre_bend the first term of |d^2 z / dtau^2|. Both
  // are moduli of vectors linear in tau, so that their maxima lie at tau = 0 or 1.
  const auto centre_speed = [&](Complex offset) {
    return std::abs(drift_ - observer_spin_ * perp(offset));
  };
  const Complex last = offset_ + drift_;
  speed_ = std::max(centre_speed(offset_), centre_speed(last));
  const auto centre_bend = [&](Complex offset) {
    return std::abs(observer_spin_ * (2.0 * perp(drift_) + observer_spin_ * offset));
  };
  bend_ = std::max(centre_bend(offset_), centre_bend(last));
  start_ = at(0.0);
  end_ = at(1.0);
}

// Evaluates (10.2).
RelativeFrame RelativePath::at(double tau) const {
  return {std::polar(1.0, -observer_ - tau * observer_spin_) * (offset_ + tau * drift_),
          std::polar(1.0, orientation_ + tau * spin_)};
}

}  // namespace stokesbook
