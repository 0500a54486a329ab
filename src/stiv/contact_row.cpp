// Makes a row of constraints from a vertex event: gap (10.5), its derivative (10.9), and the
// balanced force (section "Forces" of chapter 10).
#include "stiv/contact_row.hpp"

namespace stokesbook {

namespace {

// Turns a vector x of a component's frame into the plane, at a time tau.
Complex turned(const RigidPath& path, double tau, Complex x) {
  return std::polar(1.0, path.at(tau).orientation) * x;
}

// Returns the wrenches of the force n on one component and -n on the other: (n, arm x n) and
// (-n, -other_arm x n), both at the same point.
PairWrench opposite(Complex n, Complex arm, Complex other_arm, bool of_a) {
  const Wrench mine{n, cross(arm, n)}, others{-n, -cross(other_arm, n)};
  return of_a ? PairWrench{mine, others} : PairWrench{others, mine};
}

}  // namespace

ContactRow contact_row(const VertexEvent& event, Complex vertex, bool of_a, const PathPair& paths) {
  const RigidPath& mine = of_a ? paths.path_a : paths.path_b;
  const RigidPath& other = of_a ? paths.path_b : paths.path_a;
  //! [row]
  // Arms use only the vector between the centres: places far from the origin would lose digits.
  const Complex apart = other.start.position - mine.start.position;
  const Complex apart_at_end = apart + (other.displacement - mine.displacement);
  const Complex normal = turned(other, event.time, event.normal);
  // The force acts half-way between the vertex and the point that it touches.
  const Complex arm =
      0.5 * (turned(mine, event.time, vertex) + apart + turned(other, event.time, event.point));
  const Complex arm_at_end = turned(mine, 1.0, vertex);
  //! [row]
  const RowKey key =
      of_a ? RowKey{paths.a, paths.b, event.vertex} : RowKey{paths.b, paths.a, event.vertex};
  // Force with the centres at the start, derivative (10.9) with the centres at the end of the step.
  return {key,
          event.gap,
          event.time,
          mine.start.position + arm,
          of_a ? normal : -normal,
          opposite(normal, arm, arm - apart, of_a),
          opposite(turned(other, 1.0, event.normal), arm_at_end, arm_at_end - apart_at_end, of_a)};
}

}  // namespace stokesbook
