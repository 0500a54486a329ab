// Selects the pairs of components that may come near each other, from rectangles about their paths
// in an R-tree: the broad phase (section "Results: what it costs" of chapter 10).
#include "stiv/near_pairs.hpp"

namespace stokesbook {

Rectangle bounding_rectangle(const ContactShape& shape, const Pose& pose) {
  const ComplexVector turned = std::polar(1.0, pose.orientation) * shape.polygon.vertices();
  const auto [lower, upper] = bounding_rectangle(turned);
  return {pose.position + lower, pose.position + upper};
}

Rectangle swept_rectangle(const ContactShape& shape, const RigidPath& path) {
  const Rectangle start = bounding_rectangle(shape, path.at(0.0)),
                  end = bounding_rectangle(shape, path.at(1.0));
  const ComplexVector corners = ComplexVector{{start.lower, start.upper, end.lower, end.upper}};
  // An arc of the circle |X| rises above its chord by at most |X| rotation^2/8, and by at most the
  // diameter 2 |X|.
  const double arc = std::min(path.rotation * path.rotation / 8.0, 2.0) * shape.radius;
  return widened(bounding_rectangle(corners), arc);
}

std::vector<ComponentPair> near_pairs(const ContactShapes& shapes,
                                      const std::vector<Rectangle>& rectangles, double reach) {
  const RectangleIndex index(rectangles);
  const auto encloses = [&](std::size_t k) {
    return shapes[k]->polygon.side() == Side::fluid_inside;
  };
  std::vector<ComponentPair> pairs;
  std::vector<std::size_t> enclosing;
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    if (encloses(k)) {
      enclosing.push_back(k);
      continue;
    }
    for (std::size_t other : index.meeting(widened(rectangles[k], reach))) {
      if (other > k && !encloses(other)) pairs.emplace_back(k, other);
    }
  }
  // Pair each enclosing wall with all components that it encloses.
  for (std::size_t wall : enclosing) {
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (!encloses(k)) pairs.push_back(std::minmax(k, wall));
    }
  }
  std::ranges::sort(pairs);
  return pairs;
}

}  // namespace stokesbook
