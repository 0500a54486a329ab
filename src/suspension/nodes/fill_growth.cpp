// Packs bodies more densely than random insertion: all bodies grow together, and after each growth
// sweeps over the gaps of their polygons move them apart (chapter 12).
#include "suspension/nodes/fill_growth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "stiv/polygon_gaps.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/bodies/components.hpp"

namespace stokesbook {

namespace {

// The growing bodies, the components of the scene, and the boxes of fills, in this order. In a
// periodic cell, images of bodies and components follow when gaps are measured.
struct Crowd {
  std::size_t bodies, components;  // numbers of both
  std::vector<const Fill*> fills;  // of bodies and boxes; null for components
  ContactShapes shapes;
  std::vector<Pose> poses;
  double size;
  std::optional<std::pair<Lattice, Complex>> cell{};  // with its centre

  void add(ContactShape shape, const Pose& pose, const Fill* fill) {
    shapes.push_back(std::make_shared<const ContactShape>(std::move(shape)));
    poses.push_back(pose);
    fills.push_back(fill);
  }
};

// The gap of two polygons, and its derivatives by x, y and k theta of both, where the length k is
// half the body's radius. The derivatives by components and boxes, which do not move, are zero.
struct Row {
  std::size_t a, b;
  double gap, least, aim;  // gap now, least gap allowed, and gap to which bodies are moved apart
  Eigen::Vector3d by_a, by_b;
};

// Returns the sag of polygons that is small for a shape: 2e-3 of the radius of a disk of its area.
double fine_sag(const Shape& shape) {
  return 2e-3 * std::sqrt(area(sample(shape, 256, Side::fluid_outside)) / std::numbers::pi);
}

void resize(Crowd& crowd, double size) {
  crowd.size = size;
  for (std::size_t k = 0; k < crowd.bodies; ++k) {
    crowd.shapes[k] = crowd.shapes[k > 0 ? k - 1 : 0];
    if (k > 0 && crowd.fills[k] == crowd.fills[k - 1]) continue;
    const Shape shape = scaled(crowd.fills[k]->body.shape, size);
    crowd.shapes[k] = std::make_shared<const ContactShape>(
        contact_shape(shape, Side::fluid_outside, fine_sag(shape)));
  }
}

// Adds to shapes and poses the images, in a periodic cell, that come within a reach of bodies.
// Returns the component of each entry: its own number, or that of which it is an image.
std::vector<std::size_t> add_images(Crowd& crowd, double reach) {
  std::vector<std::size_t> owners(crowd.poses.size());
  std::iota(owners.begin(), owners.end(), std::size_t{0});
  if (!crowd.cell) return owners;
  const auto& [lattice, centre] = *crowd.cell;
  double radius = 0.0;
  for (std::size_t k = 0; k < owners.size(); ++k) {
    crowd.poses[k].position = lattice.wrap(crowd.poses[k].position, centre);
    if (k < crowd.bodies) radius = std::max(radius, crowd.shapes[k]->radius);
  }
  const double farthest = lattice.circumradius() + radius + reach;
  for (std::size_t k = 0, count = owners.size(); k < count; ++k) {
    const Pose pose = crowd.poses[k];
    const double within = farthest + crowd.shapes[k]->radius;
    for (const Complex w : lattice.vectors_into_disk(pose.position, centre, within)) {
      if (w == 0.0) continue;
      crowd.shapes.push_back(crowd.shapes[k]);
      crowd.poses.push_back({pose.position + w, pose.orientation});
      owners.push_back(k);
    }
  }
  return owners;
}

// Returns the gaps that may limit a move. A body is not limited by the boxes of other fills.
std::vector<Row> near_rows(Crowd crowd) {
  double reach = 0.0;
  for (std::size_t k = 0; k < crowd.bodies; ++k) {
    reach = std::max(reach, crowd.size * crowd.fills[k]->clearance + 0.1 * crowd.shapes[k]->radius);
  }
  const std::vector<std::size_t> owners = add_images(crowd, reach);
  std::vector<Row> rows;
  for (const PolygonGap& gap : polygon_gaps(crowd.shapes, crowd.poses, reach)) {
    const std::size_t a = gap.a, b = owners[gap.b];
    const bool is_box = b >= crowd.bodies + crowd.components;
    // The gap of a and an image of b is also that of b and an image of a.
    if (a >= crowd.bodies || b < a || (is_box && crowd.fills[b] != crowd.fills[a])) continue;
    const auto derivative = [&](std::size_t k, Complex normal) -> Eigen::Vector3d {
      if (owners[k] >= crowd.bodies) return Eigen::Vector3d::Zero();
      const double turn = cross(gap.point - crowd.poses[k].position, normal);
      return {normal.real(), normal.imag(), turn / (0.5 * crowd.shapes[k]->radius)};
    };
    const Fill& later = *crowd.fills[b < crowd.bodies ? b : a];
    const double clearance = is_box ? 0.0 : crowd.size * later.clearance;
    const double sags = crowd.shapes[a]->sag + crowd.shapes[b]->sag;
    rows.push_back({a, b, gap.gap, clearance + sags, clearance + 2.0 * sags,
                    derivative(a, gap.normal), derivative(gap.b, -gap.normal)});
  }
  return rows;
}

// Moves bodies until the gaps reach their aim to first order: for one gap after another, by the
// shortest move of its two bodies.
void move_apart(Crowd& crowd, const std::vector<Row>& rows) {
  std::vector<Eigen::Vector3d> moves(crowd.poses.size(), Eigen::Vector3d::Zero());
  for (int round = 0; round < 20; ++round) {
    for (const auto& [a, b, gap, least, aim, by_a, by_b] : rows) {
      const double lack = aim - gap - by_a.dot(moves[a]) - by_b.dot(moves[b]);
      if (lack <= 0.0) continue;
      const double multiplier = lack / (by_a.squaredNorm() + by_b.squaredNorm());
      moves[a] += multiplier * by_a;
      moves[b] += multiplier * by_b;
    }
  }
  for (std::size_t k = 0; k < crowd.bodies; ++k) {
    crowd.poses[k].position += Complex{moves[k][0], moves[k][1]};
    crowd.poses[k].orientation += moves[k][2] / (0.5 * crowd.shapes[k]->radius);
  }
}

// Moves bodies until all keep their clearance. Returns false if the sweeps do not suffice.
bool separate(Crowd& crowd) {
  for (int sweep = 0; sweep < 100; ++sweep) {
    const std::vector<Row> rows = near_rows(crowd);
    if (std::ranges::all_of(rows, [](const Row& row) { return row.gap >= row.least; })) return true;
    move_apart(crowd, rows);
  }
  return false;
}

// Adds the components of the scene and the boxes of the fills to the bodies.
void add_surroundings(Crowd& crowd, const Scene& scene) {
  const double sag = fine_sag(crowd.fills[0]->body.shape);
  for (std::size_t k = 0; k < crowd.components; ++k) {
    const ComponentView component = component_of(scene, k);
    crowd.add(contact_shape(component.shape, side_of(component.kind), sag), component.start, {});
  }
  for (std::size_t k = 0; k < crowd.bodies; ++k) {
    const Fill* fill = crowd.fills[k];
    if (!fill->box || (k > 0 && fill == crowd.fills[k - 1])) continue;
    const auto [left, bottom, right, top] = *fill->box;
    const ComplexVector corners =
        ComplexVector{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
    const double radius = corners.cwiseAbs().maxCoeff();
    crowd.add({Polygon(corners, Side::fluid_inside), {}, 0.0, radius}, {}, fill);
  }
}

}  // namespace

GrowingBodies grow_bodies(const Scene& scene, const std::vector<const Fill*>& fills,
                          GrowingBodies growing) {
  auto& [size, bodies] = growing;
  Crowd crowd{fills.size(), count_components(scene).all(), fills, ContactShapes(fills.size()), {},
              size};
  if (const auto cell = cell_at(scene, 0.0)) crowd.cell = {lattice_of(*cell), cell_centre(scene)};
  for (const Body& body : bodies) crowd.poses.push_back({body.position, body.orientation});
  add_surroundings(crowd, scene);
  for (double growth = 0.02; size < 1.0 && growth > 2e-3;) {
    resize(crowd, std::min(1.0, size + growth));
    if (separate(crowd)) {
      size = crowd.size;
    } else {
      growth *= 0.5;
    }
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k].shape = fills[k]->body.shape;
    bodies[k].position = crowd.poses[k].position;
    bodies[k].orientation = crowd.poses[k].orientation;
  }
  return growing;
}

}  // namespace stokesbook
