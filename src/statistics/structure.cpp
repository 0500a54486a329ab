// Measures how the bodies of a run are arranged: distances, gaps, directions, and profiles.
#include "statistics/structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "near_singular/closest_points.hpp"
#include "record/atomic_file.hpp"
#include "suspension/solver/rheology.hpp"
#include "text/number_text.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr Index body_nodes = 128, nodes_of_walls = 512;

// Bins of one width.
struct Bins {
  double from, width;
  Index count;

  Bins(double begin, double end, int number)
      : from(begin), width((end - begin) / number), count(number) {}

  // Adds a weight to the bin of a value; values outside all bins are left out.
  void add(auto&& row, double value, double weight) const {
    const double place = std::floor((value - from) / width);
    if (place >= 0.0 && place < static_cast<double>(count))
      row[static_cast<Index>(place)] += weight;
  }
  std::vector<double> centres() const {
    std::vector<double> at;
    for (Index i = 0; i < count; ++i) at.push_back(from + width * (static_cast<double>(i) + 0.5));
    return at;
  }
};

Curve sampled(const Body& body) {
  return sample(body.shape, body_nodes, Side::fluid_outside);
}

MatrixXd zeros(const BodyFrames& frames, Index bins) {
  return MatrixXd::Zero(std::ssize(frames.t), bins);
}

void add_pairs(const Bins& bins, auto&& row, const auto& points) {
  for (Index i = 0; i < std::ssize(points); ++i) {
    for (Index j = 0; j < i; ++j) {
      bins.add(row,
               std::abs(points[static_cast<std::size_t>(i)] - points[static_cast<std::size_t>(j)]),
               1.0);
    }
  }
}

double pairs_of(std::size_t points) {
  const auto n = static_cast<double>(points);
  return 0.5 * n * (n - 1.0);
}

// Returns e^{2 i theta} of the long axis of each body that has one.
std::vector<Complex> doubled_axes(const Scene& scene, const std::vector<BodyState>& bodies) {
  std::vector<Complex> axes;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto axis = long_axis(sampled(scene.bodies[k]));
    if (axis) axes.push_back(std::polar(1.0, 2.0 * (*axis + bodies[k].orientation)));
  }
  return axes;
}

SmoothCurve placed_curve(const Shape& shape, Index nodes, Side side, const auto& pose) {
  return {place(sample(shape, nodes, side), pose.position, pose.orientation),
          std::make_shared<const Parametrisation>(parametrisation(shape)), pose.position,
          pose.orientation};
}

}  // namespace

BodyFrames read_frames(const Run& run, double from, double to) {
  const NumberTable& table = run.bodies;
  const std::size_t count = run.scene.bodies.size();
  BodyFrames frames;
  for (std::size_t k = 0; k < run.times().size(); ++k) {
    if (run.times()[k] < from || run.times()[k] > to) continue;
    frames.t.push_back(run.times()[k]);
    frames.bodies.emplace_back();
    for (std::size_t row = k * count; row < (k + 1) * count; ++row) {
      frames.bodies.back().push_back(body_state(table, row));
    }
  }
  if (!frames.t.empty()) return frames;
  throw RecordError(table.path, "has no written time from " + short_number(from) + " to " +
                                    short_number(to) + ": change --from or --to");
}

Measurement pair_correlation(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                             double longest, int number) {
  constexpr Index samples = 5000;
  const Bins bins(0.0, longest, number);
  double clearance = longest;
  for (const Body& body : scene.bodies) {
    clearance = std::min(clearance, sampled(body).x.cwiseAbs().minCoeff());
  }
  const Region region = region_of(scene, box, clearance, samples);
  Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(number);
  add_pairs(bins, expected, std::vector<Complex>(region.points.begin(), region.points.end()));
  expected /= pairs_of(samples);
  MatrixXd g = zeros(frames, number);
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    std::vector<Complex> inside;
    for (const BodyState& body : frames.bodies[f]) {
      if (region.is_in_box(body.position)) inside.push_back(body.position);
    }
    auto row = g.row(static_cast<Index>(f));
    add_pairs(bins, row, inside);
    row = row.cwiseQuotient(expected * pairs_of(inside.size())).eval();
  }
  Measurement result{"pair_correlation", "r", bins.centres()};
  result.add("g", frames.t, g);
  return result;
}

Measurement neighbours(const Scene& scene, const BodyFrames& frames) {
  const std::size_t count = scene.bodies.size();
  std::vector<double> radii, limits;
  for (const Body& body : scene.bodies) radii.push_back(outer_radius(sampled(body), 0.0));
  double mean_radius = 0.0;
  for (const double radius : radii) mean_radius += radius / static_cast<double>(count);
  for (int k = -16; k <= 0; ++k) limits.push_back(mean_radius * std::pow(10.0, 0.25 * k));
  std::vector<SmoothCurve> walls;
  for (const Wall& wall : scene.walls) {
    const Side side = wall.role == WallRole::outer ? Side::fluid_inside : Side::fluid_outside;
    walls.push_back(placed_curve(wall.shape, nodes_of_walls, side, wall));
  }
  MatrixXd bodies = zeros(frames, std::ssize(limits)), at_walls = bodies;
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    const auto add = [&](MatrixXd& numbers, const SmoothCurve& a, const SmoothCurve& b,
                         double weight) {
      const double gap = closest_points(a, b).gap;
      for (std::size_t k = 0; k < limits.size(); ++k) {
        if (gap < limits[k])
          numbers(static_cast<Index>(f), static_cast<Index>(k)) +=
              weight / static_cast<double>(count);
      }
    };
    std::vector<SmoothCurve> curves;
    for (std::size_t a = 0; a < count; ++a) {
      const BodyState& body = frames.bodies[f][a];
      curves.push_back(placed_curve(scene.bodies[a].shape, body_nodes, Side::fluid_outside, body));
      for (std::size_t b = 0; b < a; ++b) {
        const double distance = std::abs(body.position - frames.bodies[f][b].position);
        if (distance - radii[a] - radii[b] < limits.back()) add(bodies, curves[a], curves[b], 2.0);
      }
      for (const SmoothCurve& wall : walls) {
        const double distance = (wall.nodes.x.array() - body.position).abs().minCoeff();
        if (distance - radii[a] < 2.0 * limits.back()) add(at_walls, curves[a], wall, 1.0);
      }
    }
  }
  Measurement result{"neighbours", "h", limits};
  result.add("bodies", frames.t, bodies);
  if (!walls.empty()) result.add("walls", frames.t, at_walls);
  return result;
}

Measurement orientations(const Scene& scene, const BodyFrames& frames, int number) {
  const Bins bins(0.0, std::numbers::pi, number);
  MatrixXd density = zeros(frames, number);
  bool any = false;
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    const std::vector<Complex> axes = doubled_axes(scene, frames.bodies[f]);
    for (const Complex axis : axes) {
      const double doubled = std::arg(axis);  // in (-pi, pi]
      const double angle = 0.5 * (doubled < 0.0 ? doubled + 2.0 * std::numbers::pi : doubled);
      bins.add(density.row(static_cast<Index>(f)), angle,
               1.0 / (static_cast<double>(axes.size()) * bins.width));
      any = true;
    }
  }
  if (!any) return {"orientations", "theta", {}};
  Measurement result{"orientations", "theta", bins.centres()};
  result.add("density", frames.t, density);
  return result;
}

std::vector<double> nematic_order(const Scene& scene, const BodyFrames& frames) {
  std::vector<double> order;
  for (const std::vector<BodyState>& bodies : frames.bodies) {
    Complex sum = 0.0;
    const std::vector<Complex> axes = doubled_axes(scene, bodies);
    for (const Complex axis : axes) sum += axis;
    order.push_back(std::abs(sum) / static_cast<double>(axes.size()));
  }
  return order;
}

Measurement profile(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                    Across across, int number) {
  constexpr Index rings = 32, samples = 40000;
  const Region region = region_of(scene, box, 0.0, samples);
  const auto [left, bottom, right, top] = region.box;
  const Complex centre{0.5 * (left + right), 0.5 * (bottom + top)};
  const auto variable = [&](Complex x) {
    return across == Across::x ? x.real() : across == Across::y ? x.imag() : std::abs(x - centre);
  };
  const Eigen::VectorXd values = region.points.unaryExpr(variable);
  const Bins bins(values.minCoeff(), values.maxCoeff(), number);
  Eigen::RowVectorXd area = Eigen::RowVectorXd::Zero(number);
  for (const double value : values) bins.add(area, value, region.area / samples);
  MatrixXd covered = zeros(frames, number), first = covered, second = covered;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Curve curve = sampled(scene.bodies[k]);
    for (std::size_t f = 0; f < frames.t.size(); ++f) {
      const auto& [position, orientation, velocity, omega, force, torque] = frames.bodies[f][k];
      const auto row = static_cast<Index>(f);
      for (Index j = 0; j < rings * body_nodes; ++j) {
        // The points c + s e^{i theta} X(t) have the area element s X x X' ds dt.
        const Index node = j / rings;
        const double s = (static_cast<double>(j % rings) + 0.5) / rings;
        const double weight =
            s / rings * cross(curve.x[node], curve.dx[node]) * 2.0 * std::numbers::pi / body_nodes;
        const Complex arm = s * std::polar(1.0, orientation) * curve.x[node];
        const Complex at = position + arm;
        // Bodies do not meet walls: only a box cuts them.
        if (!region.is_in_box(at)) continue;
        Complex moved = velocity + imaginary * omega * arm;
        if (across == Across::radius) moved *= std::conj(at - centre) / std::abs(at - centre);
        bins.add(covered.row(row), variable(at), weight);
        bins.add(first.row(row), variable(at), weight * moved.real());
        bins.add(second.row(row), variable(at), weight * moved.imag());
      }
    }
  }
  Measurement result{"profile",
                     across == Across::x   ? "x"
                     : across == Across::y ? "y"
                                           : "radius",
                     bins.centres()};
  // A mean velocity is a quotient of two means. Its error is that of the linearised quotient
  // (p - v a) / <a> of momentum p and area a, added to v.
  const Eigen::RowVectorXd mean_area = covered.colwise().mean();
  const auto velocity_of = [&](const MatrixXd& momentum) -> MatrixXd {
    const Eigen::RowVectorXd v = momentum.colwise().mean().cwiseQuotient(mean_area);
    return ((momentum - covered * v.asDiagonal()) * mean_area.cwiseInverse().asDiagonal())
               .eval()
               .rowwise() +
           v;
  };
  result.add("area_fraction", frames.t, covered * area.cwiseInverse().asDiagonal());
  result.add(across == Across::radius ? "radial_velocity" : "ux", frames.t, velocity_of(first));
  result.add(across == Across::radius ? "azimuthal_velocity" : "uy", frames.t, velocity_of(second));
  return result;
}

}  // namespace stokesbook
