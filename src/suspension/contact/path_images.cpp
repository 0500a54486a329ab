// Adds the paths of images to those of the components in a periodic cell: the search for contact
// among all paths (chapter 10) then finds every pair, without a lattice. Keeps one of the names
// under which it finds a pair (chapter 14).
#include "suspension/contact/path_images.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "suspension/bodies/components.hpp"

namespace stokesbook {

namespace {

LatticeIndex sum(LatticeIndex i, LatticeIndex j) {
  return {i.first + j.first, i.second + j.second};
}

LatticeIndex negative(LatticeIndex i) {
  return {-i.first, -i.second};
}

RigidPath moved(RigidPath path, const LatticeStep& lattice, LatticeIndex index) {
  path.start.position += lattice.start.vector(index);
  path.displacement += lattice.displacement(index);
  return path;
}

// Returns the vectors by which images of components may come within a reach of the cell in a step.
std::vector<Complex> near_vectors(const LatticeStep& lattice, double reach) {
  // An image w that moves by D w is within the reach R only if |w| < R (1 + |D|), as D^2 = 0 in a
  // shear. The components of w along a reduced basis are at most 2 |w| / sqrt(3).
  double moved = 0.0;
  for (const Complex b : {lattice.start.shortest(), lattice.start.second()}) {
    moved += 2.0 / std::numbers::sqrt3 * std::abs(lattice.at_end(b) - b) / std::abs(b);
  }
  return lattice.start.vectors_into_disk(0.0, 0.0, reach * (1.0 + moved));
}

// Returns the least rectangle that holds the positions on some paths.
Rectangle positions_rectangle(const std::vector<RigidPath>& paths) {
  ComplexVector points(2 * std::ssize(paths));
  for (std::size_t k = 0; k < paths.size(); ++k) {
    points.segment<2>(2 * static_cast<Eigen::Index>(k)) << paths[k].start.position,
        paths[k].at(1.0).position;
  }
  return bounding_rectangle(points);
}

}  // namespace

std::string name_contact_pair(const Scene& scene, const ContactPair& pair) {
  return (pair.image == LatticeIndex{} ? name_pair : name_image_pair)(scene, pair.a, pair.b);
}

std::optional<ContactPair> PathImages::pair(std::size_t p, std::size_t q) const {
  if (p >= components) return {};
  const ContactPair found{p, images[q].component, sum(images[q].index, negative(images[p].index))};
  const bool is_reverse = found.a > found.b || (found.a == found.b && found.image < LatticeIndex{});
  return is_reverse ? std::nullopt : std::optional(found);
}

CloserPairs PathImages::numbered(const CloserGaps& closer) const {
  CloserPairs result;
  for (const auto& [pair, gap] : closer) {
    const Image other{pair.b, sum(images[pair.a].index, pair.image)};
    const auto from_b = images.begin() + static_cast<std::ptrdiff_t>(pair.b);
    const auto found = std::find(from_b, images.end(), other);
    if (found == images.end()) continue;
    result.emplace(ComponentPair{pair.a, found - images.begin()}, gap);
  }
  return result;
}

PathImages path_images(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                       const std::optional<LatticeStep>& lattice, double reach) {
  const std::size_t count = paths.size();
  PathImages found{std::vector<PathImages::Image>(count), paths, shapes, count};
  for (std::size_t k = 0; k < count; ++k) found.images[k].component = k;
  if (!lattice) return found;
  double radius = 0.0, longest = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const Complex here = paths[k].start.position;
    found.images[k].index = negative(lattice->start.index(lattice->start.nearest(here)));
    found.paths[k] = moved(paths[k], *lattice, found.images[k].index);
    radius = std::max(radius, shapes[k]->radius);
    longest = std::max(longest, std::abs(found.paths[k].displacement));
  }
  const double apart = 2.0 * radius + reach;  // largest distance of positions that matter
  const double cell = 2.0 * lattice->start.circumradius();
  const RectangleIndex near({widened(positions_rectangle(found.paths), apart)});
  for (const Complex w : near_vectors(*lattice, cell + 2.0 * longest + apart)) {
    if (w == 0.0) continue;  // the components themselves
    const LatticeIndex index = lattice->start.index(w);
    for (std::size_t k = 0; k < count; ++k) {
      const RigidPath image = moved(found.paths[k], *lattice, index);
      if (near.meeting(positions_rectangle({image})).empty()) continue;
      found.images.push_back({k, sum(found.images[k].index, index)});
      found.paths.push_back(image);
      found.shapes.push_back(shapes[k]);
    }
  }
  return found;
}

PathImages resting_images(const ContactShapes& shapes, const Placement& placement, double reach) {
  std::vector<RigidPath> paths;
  for (const Pose& pose : placement.paths) paths.push_back({pose, {}, 0.0});
  return path_images(shapes, paths, lattice_step(placement.lattice, placement.lattice), reach);
}

}  // namespace stokesbook
