#include "stiv/contact_row.hpp"

namespace stokesbook {

namespace {

Complex turned(const RigidPath& path, double tau, Complex x) {
  return std::polar(1.0, path.at(tau).orientation) * x;
}

// A unit force along n on one component and against it on the other, with arms to one point.
PairWrench opposite(Complex n, Complex arm, Complex other_arm, bool of_a) {
  const Wrench mine{n, cross(arm, n)}, others{-n, -cross(other_arm, n)};
  return of_a ? PairWrench{mine, others} : PairWrench{others, mine};
}

}  // namespace

ContactRow contact_row(const VertexEvent& event, Complex vertex, bool of_a, const PathPair& paths) {
  const RigidPath& mine = of_a ? paths.path_a : paths.path_b;
  const RigidPath& other = of_a ? paths.path_b : paths.path_a;
  //! [row]
  // Between the centres: no arm is a difference of two places far from both.
  const Complex apart = other.start.position - mine.start.position;
  const Complex apart_at_end = apart + (other.displacement - mine.displacement);
  const Complex normal = turned(other, event.time, event.normal);
  const Complex arm =
      0.5 * (turned(mine, event.time, vertex) + apart + turned(other, event.time, event.point));
  const Complex arm_at_end = turned(mine, 1.0, vertex);
  //! [row]
  const RowKey key =
      of_a ? RowKey{paths.a, paths.b, event.vertex} : RowKey{paths.b, paths.a, event.vertex};
  return {key,
          event.gap,
          event.time,
          mine.start.position + arm,
          of_a ? normal : -normal,
          opposite(normal, arm, arm - apart, of_a),
          opposite(turned(other, 1.0, event.normal), arm_at_end, arm_at_end - apart_at_end, of_a)};
}

}  // namespace stokesbook
