// Computes gaps of curves from their formulas alone, as an independent check of the solver's
// geometry: samples both curves, then refines each close pair of samples by Newton's method.
#include "support/exact_gaps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <variant>

namespace stokesbook::test {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;

constexpr const char* known_shapes = "exact_gap: only circles, ellipses, stars and superellipses";

struct Jet {
  Complex x, dx, ddx;
};

Jet jet(const Circle& circle, double t) {
  const Complex x = std::polar(circle.radius, t);
  return {x, Complex(0.0, 1.0) * x, -x};
}

Jet jet(const Ellipse& ellipse, double t) {
  const Complex x(ellipse.a * std::cos(t), ellipse.b * std::sin(t));
  return {x, {-ellipse.a * std::sin(t), ellipse.b * std::cos(t)}, -x};
}

Jet polar(double t, double r, double dr, double ddr) {
  const Complex e = std::polar(1.0, t), i(0.0, 1.0);
  return {r * e, (dr + i * r) * e, (ddr - r + 2.0 * i * dr) * e};
}

Jet jet(const Star& star, double t) {
  const double k = star.arms, wave = star.radius * star.amplitude;
  return polar(t, star.radius + wave * std::cos(k * t), -k * wave * std::sin(k * t),
               -k * k * wave * std::cos(k * t));
}

// The superellipse in polar coordinates is r = g^{-1/p} with g = c^p + s^p, c = cos(t) / a,
// s = sin(t) / b.
Jet jet(const Superellipse& shape, double t) {
  const int p = shape.power;
  const double c = std::cos(t) / shape.a, dc = -std::sin(t) / shape.a, s = std::sin(t) / shape.b,
               ds = std::cos(t) / shape.b;
  const double g = std::pow(c, p) + std::pow(s, p),
               dg = p * (std::pow(c, p - 1) * dc + std::pow(s, p - 1) * ds),
               ddg = p *
                     ((p - 1) * (std::pow(c, p - 2) * dc * dc + std::pow(s, p - 2) * ds * ds) - g);
  const double r = std::pow(g, -1.0 / p), slope = -dg / (p * g),
               bend = slope * slope - (ddg * g - dg * dg) / (p * g * g);
  return polar(t, r, r * slope, r * bend);
}

template <class Other>
Jet jet(const Other&, double) {
  throw std::invalid_argument(known_shapes);
}

Jet at(const PlacedShape& placed, double t) {
  const auto [x, dx, ddx] =
      std::visit([t](const auto& shape) { return jet(shape, t); }, placed.shape);
  const Complex turned = std::polar(1.0, placed.orientation);
  return {placed.position + turned * x, turned * dx, turned * ddx};
}

std::vector<Complex> sampled(const PlacedShape& placed, int samples) {
  const Complex turned = std::polar(1.0, placed.orientation);
  const auto sample = [&](const auto& shape) {
    std::vector<Complex> points;
    for (int i = 0; i < samples; ++i) {
      points.push_back(placed.position + turned * jet(shape, turn * i / samples).x);
    }
    return points;
  };
  return std::visit(sample, placed.shape);
}

double dot(Complex a, Complex b) {
  return a.real() * b.real() + a.imag() * b.imag();
}

double distance(const PlacedShape& a, const PlacedShape& b, double s, double t) {
  return std::abs(at(a, s).x - at(b, t).x);
}

// Minimises the distance, starting at a pair of parameters, by Newton's method. If the Hessian is
// not positive definite, the step uses the Gauss-Newton matrix with its diagonal enlarged by a
// tenth. Steps are halved until the distance decreases.
double descended(const PlacedShape& a, const PlacedShape& b, double s, double t) {
  double found = distance(a, b, s, t);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Jet p = at(a, s), q = at(b, t);
    const Complex d = p.x - q.x;
    const double gs = dot(d, p.dx), gt = -dot(d, q.dx), hst = -dot(p.dx, q.dx);
    double hss = std::norm(p.dx) + dot(d, p.ddx), htt = std::norm(q.dx) - dot(d, q.ddx);
    if (hss <= 0.0 || hss * htt - hst * hst <= 1e-12 * std::norm(p.dx) * std::norm(q.dx)) {
      hss = 1.1 * std::norm(p.dx);
      htt = 1.1 * std::norm(q.dx);
    }
    const double determinant = hss * htt - hst * hst;
    const double ds = -(htt * gs - hst * gt) / determinant;
    const double dt = -(hss * gt - hst * gs) / determinant;
    double factor = 1.0;
    while (factor > 1e-6 && distance(a, b, s + factor * ds, t + factor * dt) >= found) {
      factor *= 0.5;
    }
    if (factor <= 1e-6) break;
    s += factor * ds;
    t += factor * dt;
    found = distance(a, b, s, t);
  }
  return found;
}

// Returns how many times a polygon winds about a point.
int winding_number(const std::vector<Complex>& polygon, Complex point) {
  int winding = 0;
  Complex from = polygon.back() - point;
  for (const Complex& vertex : polygon) {
    const Complex to = vertex - point;
    const double side = from.real() * to.imag() - from.imag() * to.real();
    if (from.imag() <= 0.0 && to.imag() > 0.0 && side > 0.0) ++winding;
    if (from.imag() > 0.0 && to.imag() <= 0.0 && side < 0.0) --winding;
    from = to;
  }
  return winding;
}

// Returns whether a curve lies inside a polygon that the curve does not cross. The function tests
// nine points and returns the result of the majority, because a single point may be so near the
// polygon that rounding errors determine its result.
bool lies_inside(const std::vector<Complex>& curve, const std::vector<Complex>& polygon) {
  int inside = 0;
  constexpr std::size_t asked = 9;
  for (std::size_t i = 0; i < asked; ++i) {
    inside += winding_number(polygon, curve[i * curve.size() / asked]) != 0 ? 1 : 0;
  }
  return 2 * inside > static_cast<int>(asked);
}

// Bounds of the distance of a curve from its centre.
double reach(const Circle& circle) {
  return circle.radius;
}
double reach(const Ellipse& ellipse) {
  return std::max(ellipse.a, ellipse.b);
}
double reach(const Star& star) {
  return star.radius * (1.0 + std::abs(star.amplitude));
}
double reach(const Superellipse& shape) {
  return std::hypot(shape.a, shape.b);
}
template <class Other>
double reach(const Other&) {
  throw std::invalid_argument(known_shapes);
}

}  // namespace

double exact_gap(const PlacedShape& a, const PlacedShape& b, int samples) {
  const std::vector<Complex> on_a = sampled(a, samples), on_b = sampled(b, samples);
  struct Nearest {
    double distance2 = std::numeric_limits<double>::infinity();
    int on_b = 0;
  };
  std::vector<Nearest> nearest(on_a.size());
  double least2 = std::numeric_limits<double>::infinity(), longest2 = 0.0;
  for (std::size_t i = 0; i < on_a.size(); ++i) {
    for (std::size_t j = 0; j < on_b.size(); ++j) {
      const double distance2 = std::norm(on_a[i] - on_b[j]);
      if (distance2 < nearest[i].distance2) nearest[i] = {distance2, static_cast<int>(j)};
    }
    least2 = std::min(least2, nearest[i].distance2);
    longest2 = std::max({longest2, std::norm(on_a[i] - on_a[(i + 1) % on_a.size()]),
                         std::norm(on_b[i] - on_b[(i + 1) % on_b.size()])});
  }
  // Refines every local minimum of the sampled distances that may be near the global minimum of the
  // distance.
  double gap = std::sqrt(least2);
  const double bound = gap + std::sqrt(longest2);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const double before = nearest[(i + nearest.size() - 1) % nearest.size()].distance2,
                 after = nearest[(i + 1) % nearest.size()].distance2, own = nearest[i].distance2;
    if (own > before || own > after || own > bound * bound) continue;
    gap = std::min(gap, descended(a, b, turn * static_cast<double>(i) / samples,
                                  turn * nearest[i].on_b / samples));
  }
  const bool wrong_side = a.encloses   ? !lies_inside(on_b, on_a)
                          : b.encloses ? !lies_inside(on_a, on_b)
                                       : lies_inside(on_a, on_b) || lies_inside(on_b, on_a);
  return wrong_side ? -gap : gap;
}

std::vector<PlacedShape> placed_shapes(const Scene& scene, const Frame& frame) {
  std::vector<PlacedShape> placed;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    placed.push_back(
        {scene.bodies[k].shape, frame.bodies[k].position, frame.bodies[k].orientation});
  }
  for (std::size_t k = 0; k < scene.walls.size(); ++k) {
    placed.push_back({scene.walls[k].shape, frame.walls[k].position, frame.walls[k].orientation,
                      scene.walls[k].role == WallRole::outer});
  }
  return placed;
}

double least_exact_gap(const std::vector<PlacedShape>& shapes, double limit, int samples) {
  std::vector<double> radii;
  for (const PlacedShape& placed : shapes) {
    radii.push_back(std::visit([](const auto& shape) { return reach(shape); }, placed.shape));
  }
  double least = limit;
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const double apart = std::abs(shapes[a].position - shapes[b].position);
      const bool enclosed = shapes[a].encloses || shapes[b].encloses;
      if (!enclosed && apart > radii[a] + radii[b] + limit) continue;
      least = std::min(least, exact_gap(shapes[a], shapes[b], samples));
    }
  }
  return least;
}

double least_exact_gap(const Scene& scene, const std::vector<Frame>& frames, double limit) {
  double least = limit;
  for (const Frame& frame : frames) {
    least = std::min(least, least_exact_gap(placed_shapes(scene, frame), least));
  }
  return least;
}

}  // namespace stokesbook::test
