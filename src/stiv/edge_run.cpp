// Computes the distances of a point or a chord from eight edges of a polygon side by side, in Eigen
// arrays of eight numbers.
#include "stiv/edge_run.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

using Lanes = Eigen::Array<double, EdgeRun::size, 1>;

// Eight plane vectors.
struct Vectors {
  Lanes x, y;
};

// Returns eight copies of a vector.
Vectors all(Complex z) {
  return {Lanes::Constant(z.real()), Lanes::Constant(z.imag())};
}

Vectors operator-(const Vectors& p, const Vectors& q) {
  return {p.x - q.x, p.y - q.y};
}

Lanes dots(const Vectors& p, const Vectors& q) {
  return p.x * q.x + p.y * q.y;
}

Lanes crosses(const Vectors& p, const Vectors& q) {
  return p.x * q.y - p.y * q.x;
}

// Eight segments from the origin, and the inverse squares of their lengths.
struct Segments {
  Vectors along;
  Lanes inverse;
};

// Returns t = min(max(p . v / |v|^2, 0), 1): the closest point to p of the segment v is t v.
Lanes closest_fractions(const Segments& segments, const Vectors& points) {
  return (dots(points, segments.along) * segments.inverse).max(0.0).min(1.0);
}

Lanes squared_distances(const Segments& segments, const Vectors& points, const Lanes& fractions) {
  const Vectors apart{points.x - fractions * segments.along.x,
                      points.y - fractions * segments.along.y};
  return dots(apart, apart);
}

Lanes squared_distances(const Segments& segments, const Vectors& points) {
  return squared_distances(segments, points, closest_fractions(segments, points));
}

}  // namespace

EdgeRun::EdgeRun(const std::array<Chord, size>& edges) {
  for (Index k = 0; k < size; ++k) {
    const auto [from, to] = edges[static_cast<std::size_t>(k)];
    x_[k] = from.real();
    y_[k] = from.imag();
    dx_[k] = (to - from).real();
    dy_[k] = (to - from).imag();
  }
  inverse_ = (dx_.square() + dy_.square()).inverse();
}

EdgeRun::Closest EdgeRun::closest(Complex z) const {
  const Segments edges{{dx_, dy_}, inverse_};
  const Vectors from_start = all(z) - Vectors{x_, y_};
  const Lanes fractions = closest_fractions(edges, from_start);
  Index edge = 0;
  const double least = squared_distances(edges, from_start, fractions).minCoeff(&edge);
  return {least, edge, fractions[edge]};
}

bool EdgeRun::is_clear_of(const Chord& chord, double distance) const {
  const Complex along = chord.to - chord.from;
  const double length2 = std::norm(along);
  const Segments edges{{dx_, dy_}, inverse_},
      chords{all(along), Lanes::Constant(length2 > 0.0 ? 1.0 / length2 : 0.0)};
  const Vectors starts{x_, y_},
      from_start = all(chord.from) - starts, to_start = starts - all(chord.from),
      to_end{to_start.x + dx_, to_start.y + dy_}, ends_from_start = all(chord.to) - starts;
  // Unless they cross, chord and edge are closest at an end of one of them.
  const Lanes least = squared_distances(edges, from_start)
                          .min(squared_distances(edges, ends_from_start))
                          .min(squared_distances(chords, to_start))
                          .min(squared_distances(chords, to_end));
  // Chord and edge cross if the ends of each lie on different sides of the other: both products are
  // negative.
  const Lanes sides = (crosses(edges.along, from_start) * crosses(edges.along, ends_from_start))
                          .max(crosses(chords.along, to_start) * crosses(chords.along, to_end));
  return least.minCoeff() > distance * distance && sides.minCoeff() >= 0.0;
}

}  // namespace stokesbook
