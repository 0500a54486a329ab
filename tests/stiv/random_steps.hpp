// Builds crowds of circles, slender ellipses and stars, which are well apart. Each body has its own
// path.
#pragma once

#include <numbers>
#include <random>

#include "steps.hpp"
#include "stiv/polygon_gaps.hpp"

namespace stokesbook::test {

/// Returns components that are at least 0.05 apart at the start. Displacements and turns are up to
/// `travel`, and a star-shaped container is added if `enclosed`. The result is the same in every
/// run.
inline Step random_step(std::size_t count, unsigned seed, double travel, bool enclosed = false) {
  static const std::vector<std::shared_ptr<const ContactShape>> shapes{
      body(Circle{0.5}, 96), body(Ellipse{0.8, 0.08}, 160), body(Star{0.5, 0.3, 5}, 200),
      body(Circle{0.2}, 48), body(Ellipse{0.6, 0.3}, 96)};
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const double size = 0.8 * std::sqrt(static_cast<double>(count));
  Step step;
  if (enclosed) step.add(container(Star{1.5 * size, 0.05, 4}, 800), {});
  const auto random_vector = [&](double length) {
    const double x = uniform(generator);
    return length * Complex{x, uniform(generator)};
  };
  const std::size_t walls = step.shapes.size();
  while (step.shapes.size() < count + walls) {
    const Complex centre = random_vector(size);
    const double orientation = std::numbers::pi * uniform(generator);
    const Complex displacement = random_vector(travel);
    Step grown = step;
    grown.add(shapes[step.shapes.size() % shapes.size()],
              {{centre, orientation}, displacement, travel * uniform(generator)});
    std::vector<Pose> poses;
    for (const RigidPath& path : grown.paths) poses.push_back(path.start);
    if (polygon_gaps(grown.shapes, poses, 0.055).empty()) step = grown;
  }
  return step;
}

}  // namespace stokesbook::test
