// Tests every error in a shape, with the whole message of each.

#include <string>

#include "bad_scene.hpp"

using namespace stokesbook::test;

namespace {

std::string body_of_points(const std::string& points) {
  return body_with_shape("{ kind = 'nodes', points = [" + points + "] }");
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bad_shapes)

BOOST_AUTO_TEST_CASE(shapes) {
  check({
      {"[[bodies]]\nn_nodes = 32\n",
       "s.toml:1:1: bodies[0].shape is missing: must be a table, such as { kind = \"circle\", "
       "radius = 1.0 }"},
      {body_with_shape("'circle'"),
       "s.toml:2:9: bodies[0].shape = \"circle\": must be a table, not a string"},
      {body_with_shape("{ radius = 1 }"),
       "s.toml:2:9: bodies[0].shape.kind is missing: must be one of circle, ellipse, star, "
       "superellipse, nodes"},
      {body_with_shape("{ kind = 'square' }"),
       "s.toml:2:18: bodies[0].shape.kind = \"square\": must be one of circle, ellipse, star, "
       "superellipse, nodes"},
      {body_with_shape("{ kind = 'circle' }"),
       "s.toml:2:9: bodies[0].shape.radius is missing: must be a number > 0"},
      {body_with_shape("{ kind = 'circle', radius = 0 }"),
       "s.toml:2:37: bodies[0].shape.radius = 0: must be a number > 0"},
      {body_with_shape("{ kind = 'circle', raduis = 1 }"),
       "s.toml:2:28: bodies[0].shape.raduis = 1: unknown key, did you mean 'radius'?"},
      {body_with_shape("{ kind = 'circle', radius = 1, semi_axes = [1, 2] }"),
       "s.toml:2:40: bodies[0].shape.semi_axes = [1, 2]: unknown key; valid keys: kind, radius"},
      {body_with_shape("{ kind = 'ellipse' }"),
       "s.toml:2:9: bodies[0].shape.semi_axes is missing: must be two numbers > 0"},
      {body_with_shape("{ kind = 'ellipse', semi_axes = [1, 0] }"),
       "s.toml:2:41: bodies[0].shape.semi_axes = [1, 0]: must be two numbers > 0"},
      {body_with_shape("{ kind = 'ellipse', semi_axes = [-1, 1] }"),
       "s.toml:2:41: bodies[0].shape.semi_axes = [-1, 1]: must be two numbers > 0"},
      {body_with_shape("{ kind = 'ellipse', semi_axes = [1, 1, 1] }"),
       "s.toml:2:41: bodies[0].shape.semi_axes = [1, 1, 1]: must be two numbers > 0, not an array "
       "of 3"},
      {body_with_shape("{ kind = 'ellipse', semi_axes = [1, 1], power = 2 }"),
       "s.toml:2:49: bodies[0].shape.power = 2: unknown key; valid keys: kind, semi_axes"},
      {body_with_shape("{ kind = 'star', radius = -1, amplitude = 0.2, arms = 5 }"),
       "s.toml:2:35: bodies[0].shape.radius = -1: must be a number > 0"},
      {body_with_shape("{ kind = 'star', radius = 1, amplitude = 1, arms = 5 }"),
       "s.toml:2:50: bodies[0].shape.amplitude = 1: must be a number > -1 and < 1, so that the "
       "curve does not meet itself"},
      {body_with_shape("{ kind = 'star', radius = 1, amplitude = -1.0, arms = 5 }"),
       "s.toml:2:50: bodies[0].shape.amplitude = -1.0: must be a number > -1 and < 1, so that the "
       "curve does not meet itself"},
      {body_with_shape("{ kind = 'star', radius = 1, amplitude = 0.2, arms = 0 }"),
       "s.toml:2:62: bodies[0].shape.arms = 0: must be an integer >= 1"},
      {body_with_shape("{ kind = 'star', radius = 1, amplitude = 0.2, arms = 2.5 }"),
       "s.toml:2:62: bodies[0].shape.arms = 2.5: must be an integer >= 1, not a float"},
      {body_with_shape("{ kind = 'star', amplitude = 0.2, arms = 2 }"),
       "s.toml:2:9: bodies[0].shape.radius is missing: must be a number > 0"},
      {body_with_shape("{ kind = 'star', radius = 1, arms = 2 }"),
       "s.toml:2:9: bodies[0].shape.amplitude is missing: must be a number > -1 and < 1, so that "
       "the curve does not meet itself"},
      {body_with_shape("{ kind = 'star', radius = 1, amplitude = 0.2 }"),
       "s.toml:2:9: bodies[0].shape.arms is missing: must be an integer >= 1"},
      {body_with_shape("{ kind = 'superellipse', semi_axes = [1, 1], power = 3 }"),
       "s.toml:2:62: bodies[0].shape.power = 3: must be an even integer from 2 to 1000, for which "
       "the curve "
       "is analytic"},
      {body_with_shape("{ kind = 'superellipse', semi_axes = [1, 1], power = 0 }"),
       "s.toml:2:62: bodies[0].shape.power = 0: must be an even integer from 2 to 1000, for which "
       "the curve "
       "is analytic"},
      {body_with_shape("{ kind = 'superellipse', semi_axes = [0, 1], power = 4 }"),
       "s.toml:2:46: bodies[0].shape.semi_axes = [0, 1]: must be two numbers > 0"},
      {body_with_shape("{ kind = 'superellipse', semi_axes = [1, 1] }"),
       "s.toml:2:9: bodies[0].shape.power is missing: must be an even integer from 2 to 1000, for "
       "which the "
       "curve is analytic"},
      {body_with_shape("{ kind = 'nodes' }"),
       "s.toml:2:9: bodies[0].shape.file is missing: must be the name of a CSV file, or points = "
       "[[x, y], ...]"},
      {body_with_shape("{ kind = 'nodes', file = 3 }"),
       "s.toml:2:34: bodies[0].shape.file = 3: must be the name of a CSV file, not an integer"},
      {body_with_shape("{ kind = 'nodes', file = 'a.csv', points = [] }"),
       "s.toml:2:27: bodies[0].shape.file = \"a.csv\": give file or points, not both"},
      {body_with_shape("{ kind = 'nodes', points = 8 }"),
       "s.toml:2:36: bodies[0].shape.points = 8: must be a list of points [[x, y], ...], not an "
       "integer"},
      {body_of_points("[1, 1], [-1, 1], [-1, -1], [1, -1]"),
       "s.toml:2:36: bodies[0].shape.points = [[1, 1], [-1, 1], [-1, -1], [1, -1]]: must be at "
       "least 8 points, not 4"},
      {body_of_points("[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1]"),
       "s.toml:2:98: bodies[0].shape.points[7] = [1]: must be two numbers [x, y], not an array of "
       "1"},
      {body_of_points("[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, 0]"),
       "s.toml:2:98: bodies[0].shape.points[7] = [1, 0]: is the same point as the next one (the "
       "last joins the first)"},
      {body_of_points("[1, 0], [1, 1], [0, 1], [-1, 0], [-1, 1], [0, -1], [0, -1], [1, -1]"),
       "s.toml:2:79: bodies[0].shape.points[5] = [0, -1]: is the same point as the next one (the "
       "last joins the first)"},
      {body_of_points("[1, 0], [1, 1], [0, 1], [0, -2], [-1, 1], [-1, 0], [-1, -1], [0, -1]"),
       "s.toml:2:53: bodies[0].shape.points[2] = [0, 1]: the edge to the next point meets the edge "
       "that starts at [-1, -1]"},
      {body_of_points("[3, 0], [3, 1], [2, 1], [1, 1], [1, 0], [1, -1], [2, -1], [3, -1]"),
       "s.toml:2:36: bodies[0].shape.points = [...]: the curve must go around the origin: loads "
       "act there"},
  });
}

BOOST_AUTO_TEST_SUITE_END()
