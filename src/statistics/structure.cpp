// Measures how the bodies of a run are arranged: distances, gaps, directions, and profiles.
#include "statistics/structure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "record/atomic_file.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/gaps.hpp"
#include "suspension/solver/rheology.hpp"
#include "text/number_text.hpp"
#include "trapezoid/curve.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

namespace {

constexpr int body_nodes = 128;

// Bins of one width.
struct Bins {
  double from, width;
  Index count;

  Bins(double begin, double end, int number)
      : from(begin), width((end - begin) / number), count(number) {}

  // Adds a weight to the bin of a value; values outside all bins are left out.
  void add(auto&& row, double value, auto weight) const {
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

// Returns e^{2 i theta} of the long axis of each body that has one, at each time.
std::vector<std::vector<Complex>> doubled_axes(const Scene& scene, const BodyFrames& frames) {
  std::vector<std::vector<Complex>> axes(frames.t.size());
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const auto axis = long_axis(sampled(scene.bodies[k]));
    for (std::size_t f = 0; axis && f < axes.size(); ++f) {
      axes[f].push_back(std::polar(1.0, 2.0 * (*axis + frames.bodies[f][k].orientation)));
    }
  }
  return axes;
}

// Computes the stresslets of bodies, S = -mu oint n eta ds (07.14), from the nodes of a run.
void add_stresslets(BodyFrames& frames, const Run& run) {
  const NumberTable nodes = read_table(run.path / "nodes.csv");
  const std::size_t count = run.scene.bodies.size();
  frames.stresslets.assign(frames.t.size(), std::vector<Complex>(count));
  for (std::size_t row = 0; row < nodes["t"].size(); ++row) {
    const auto time = std::ranges::lower_bound(frames.t, nodes["t"][row]);
    const double body = nodes["component"][row];  // < 0 for walls
    if (time == frames.t.end() || *time != nodes["t"][row]) continue;
    if (body < 0.0 || body >= static_cast<double>(count)) continue;
    const Complex normal{nodes["nx"][row], nodes["ny"][row]};
    const Complex density{nodes["density_x"][row], nodes["density_y"][row]};
    const auto frame = static_cast<std::size_t>(time - frames.t.begin());
    frames.stresslets[frame][static_cast<std::size_t>(body)] -=
        run.scene.viscosity * nodes["weight"][row] * normal * density;
  }
}

MatrixXd correlation_in_region(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                               const Bins& bins, double longest) {
  constexpr Index samples = 5000;
  double clearance = longest;
  for (const Body& body : scene.bodies) {
    clearance = std::min(clearance, sampled(body).x.cwiseAbs().minCoeff());
  }
  const Region region = region_of(scene, box, clearance, samples);
  Eigen::RowVectorXd expected = Eigen::RowVectorXd::Zero(bins.count);
  add_pairs(bins, expected, std::vector<Complex>(region.points.begin(), region.points.end()));
  expected /= pairs_of(samples);
  MatrixXd g = zeros(frames, bins.count);
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    std::vector<Complex> inside;
    for (const BodyState& body : frames.bodies[f]) {
      if (region.is_in_box(body.position)) inside.push_back(body.position);
    }
    auto row = g.row(static_cast<Index>(f));
    add_pairs(bins, row, inside);
    row = row.cwiseQuotient(expected * pairs_of(inside.size())).eval();
  }
  return g;
}

// Counts each body and all images of each other one: uniform points have pi (r_2^2 - r_1^2) / V of
// the images of each other point at distances from r_1 to r_2.
MatrixXd correlation_in_cell(const Scene& scene, const BodyFrames& frames, const Bins& bins,
                             double longest) {
  MatrixXd g = zeros(frames, bins.count);
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    const Lattice lattice = *lattice_at(scene, frames.t[f]);
    const std::vector<BodyState>& bodies = frames.bodies[f];
    const double expected =
        std::numbers::pi * bins.width * bins.width / lattice.area() * pairs_of(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Complex apart = bodies[i].position - bodies[j].position;
        for (const Complex w : lattice.vectors_into_disk(apart, 0.0, longest)) {
          const double distance = std::abs(apart + w);
          // (r + width)^2 - r^2 in widths, at the beginning r of the bin
          const double rings = 2.0 * std::floor(distance / bins.width) + 1.0;
          bins.add(g.row(static_cast<Index>(f)), distance, 1.0 / (expected * rings));
        }
      }
    }
  }
  return g;
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
  if (frames.t.empty()) {
    throw RecordError(table.path, "has no written time from " + short_number(from) + " to " +
                                      short_number(to) + ": change --from or --to");
  }
  if (run.scene.output.nodes) add_stresslets(frames, run);
  return frames;
}

Measurement pair_correlation(const Scene& scene, const BodyFrames& frames, const RegionBox& box,
                             double longest, int number) {
  const Bins bins(0.0, longest, number);
  const MatrixXd g = scene.cell ? correlation_in_cell(scene, frames, bins, longest)
                                : correlation_in_region(scene, frames, box, bins, longest);
  Measurement result{"pair_correlation", "r", bins.centres()};
  result.add("g", frames.t, g);
  return result;
}

Measurement neighbours(const Scene& scene, const BodyFrames& frames) {
  const std::size_t bodies = scene.bodies.size();
  const std::size_t components = walls_stay(scene) ? count_components(scene).all() : bodies;
  const double share = 1.0 / static_cast<double>(bodies);
  DiscretisationCache cache({}, components);
  Discretisation discretisation;
  Configuration configuration;
  double mean_radius = 0.0;
  for (std::size_t k = 0; k < components; ++k) {
    const ComponentView component = component_of(scene, k);
    const int nodes = k < bodies ? body_nodes : nodes_of_walls;
    discretisation.push_back(cache.get(component.shape, {nodes}, component.kind));
    configuration.push_back(component.start);
    if (k < bodies) mean_radius += share * outer_radius(discretisation[k]->curve, 0.0);
  }
  std::vector<double> limits;
  for (int k = -16; k <= 0; ++k) limits.push_back(mean_radius * std::pow(10.0, 0.25 * k));
  MatrixXd at_bodies = zeros(frames, std::ssize(limits)), at_walls = at_bodies;
  for (std::size_t f = 0; f < frames.t.size(); ++f) {
    const std::optional<PeriodicCell> cell = cell_at(scene, frames.t[f]);
    const std::optional<Lattice> lattice = lattice_at(scene, frames.t[f]);
    for (std::size_t k = 0; k < bodies; ++k) {
      const BodyState& body = frames.bodies[f][k];
      configuration[k] = {
          lattice ? lattice->wrap(body.position, cell_centre(scene)) : body.position,
          body.orientation};
    }
    for (const auto& [a, b, closest, shift] :
         gaps_within(configuration, discretisation, limits.back(), cell)) {
      if (a >= bodies) continue;  // the gap of two walls
      MatrixXd& numbers = b < bodies ? at_bodies : at_walls;
      for (std::size_t k = 0; k < limits.size(); ++k) {
        if (closest.gap >= limits[k]) continue;
        numbers(static_cast<Index>(f), static_cast<Index>(k)) += (b < bodies ? 2.0 : 1.0) * share;
      }
    }
  }
  Measurement result{"neighbours", "h", limits};
  result.is_logarithmic = true;
  result.add("bodies", frames.t, at_bodies);
  if (components > bodies) result.add("walls", frames.t, at_walls);
  return result;
}

Measurement orientations(const Scene& scene, const BodyFrames& frames, int number) {
  const Bins bins(0.0, std::numbers::pi, number);
  const std::vector<std::vector<Complex>> axes = doubled_axes(scene, frames);
  if (axes[0].empty()) return {"orientations", "theta", {}};
  MatrixXd density = zeros(frames, number);
  for (std::size_t f = 0; f < axes.size(); ++f) {
    for (const Complex axis : axes[f]) {
      const double doubled = std::arg(axis);  // in (-pi, pi]
      const double angle = 0.5 * (doubled < 0.0 ? doubled + 2.0 * std::numbers::pi : doubled);
      bins.add(density.row(static_cast<Index>(f)), angle,
               1.0 / (static_cast<double>(axes[f].size()) * bins.width));
    }
  }
  Measurement result{"orientations", "theta", bins.centres()};
  result.add("density", frames.t, density);
  return result;
}

std::vector<double> nematic_order(const Scene& scene, const BodyFrames& frames) {
  std::vector<double> order;
  for (const std::vector<Complex>& axes : doubled_axes(scene, frames)) {
    const Complex sum = std::accumulate(axes.begin(), axes.end(), Complex{});
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
  Eigen::RowVectorXd bin_area = Eigen::RowVectorXd::Zero(number);
  for (const double value : values) bins.add(bin_area, value, region.area / samples);
  MatrixXd covered = zeros(frames, number);
  MatrixXcd momentum = covered.cast<Complex>(), stress = momentum;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Curve curve = sampled(scene.bodies[k]);
    for (std::size_t f = 0; f < frames.t.size(); ++f) {
      const auto& [position, orientation, velocity, omega, force, torque] = frames.bodies[f][k];
      const Complex own_stress =
          frames.stresslets.empty() ? 0.0 : frames.stresslets[f][k] / area(curve);
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
        // In polar coordinates, vectors turn by the angle of the point, and stresses by twice that.
        const Complex turn =
            across == Across::radius ? std::conj(at - centre) / std::abs(at - centre) : 1.0;
        const double place = variable(at);
        bins.add(covered.row(row), place, weight);
        bins.add(momentum.row(row), place, weight * turn * (velocity + imaginary * omega * arm));
        bins.add(stress.row(row), place, weight * turn * turn * own_stress);
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
  const auto velocity_of = [&](const MatrixXd& part) -> MatrixXd {
    const Eigen::RowVectorXd v = part.colwise().mean().cwiseQuotient(mean_area);
    return ((part - covered * v.asDiagonal()) * mean_area.cwiseInverse().asDiagonal())
               .eval()
               .rowwise() +
           v;
  };
  const bool is_radial = across == Across::radius;
  const auto per_area = bin_area.cwiseInverse().asDiagonal();
  result.add("area_fraction", frames.t, covered * per_area);
  result.add(is_radial ? "radial_velocity" : "ux", frames.t, velocity_of(momentum.real()));
  result.add(is_radial ? "azimuthal_velocity" : "uy", frames.t, velocity_of(momentum.imag()));
  if (frames.stresslets.empty()) return result;
  result.add("particle_normal_stress", frames.t, stress.real() * per_area);
  result.add("particle_shear_stress", frames.t, stress.imag() * per_area);
  return result;
}

}  // namespace stokesbook
