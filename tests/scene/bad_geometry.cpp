// Tests every error in walls, bodies and fills, with the whole message of each.

#include <string>

#include "bad_scene.hpp"

using namespace stokesbook::test;

namespace {

std::string wall(const std::string& lines) {
  return "[[walls]]\nrole = 'inner'\nshape = { kind = 'ellipse', semi_axes = [2, 1] }\n"
         "n_nodes = 32\n" +
         lines;
}

std::string fill(const std::string& lines) {
  return "[[fill]]\nshape = { kind = 'circle', radius = 0.5 }\nn_nodes = 32\n" + lines;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bad_geometry)

BOOST_AUTO_TEST_CASE(walls) {
  check({
      {"[[walls]]\nshape = { kind = 'circle', radius = 1 }\nn_nodes = 32\n",
       "s.toml:1:1: walls[0].role is missing: must be one of outer, inner"},
      {"[[walls]]\nrole = 'middle'\n",
       "s.toml:2:8: walls[0].role = \"middle\": must be one of outer, inner"},
      {tank() + tank(),
       "s.toml:6:8: walls[1].role = \"outer\": must be inner: the outer wall is walls[0]"},
      {"[[walls]]\nrole = 'inner'\nn_nodes = 32\n",
       "s.toml:1:1: walls[0].shape is missing: must be a table, such as { kind = \"circle\", "
       "radius = 1.0 }"},
      {"[[walls]]\nrole = 'inner'\nshape = { kind = 'circle', radius = 1 }\n",
       "s.toml:1:1: walls[0].n_nodes is missing: must be an even integer >= 8 or \"auto\""},
      {wall("positon = [0, 0]\n"),
       "s.toml:5:1: walls[0].positon = [0, 0]: unknown key, did you mean 'position'?"},
      {wall("position = [0, 0, 0]\n"),
       "s.toml:5:12: walls[0].position = [0, 0, 0]: must be two numbers [x, y], not an array of 3"},
      {wall("position = [0, nan]\n"),
       "s.toml:5:16: walls[0].position[1] = nan: must be a number, and finite"},
      {wall("orientation = [1]\n"),
       "s.toml:5:15: walls[0].orientation = [1]: must be a number, not an array of 1"},
      {wall("force = [0, 0]\n"),
       "s.toml:5:1: walls[0].force = [0, 0]: unknown key; valid keys: role, shape, position, "
       "orientation, n_nodes, motion, amplitude"},
      {wall("motion = 'fixed'\n"),
       "s.toml:5:10: walls[0].motion = \"fixed\": must be a table, not a string"},
      {wall("motion = { omega = 1 }\n"),
       "s.toml:5:10: walls[0].motion.kind is missing: must be one of fixed, rotating, translating, "
       "linear, radial, parabolic, data"},
      {wall("motion = { kind = 'sliding' }\n"),
       "s.toml:5:19: walls[0].motion.kind = \"sliding\": must be one of fixed, rotating, "
       "translating, linear, radial, parabolic, data"},
      {wall("motion = { kind = 'fixed', omega = 1 }\n"),
       "s.toml:5:28: walls[0].motion.omega = 1: unknown key; valid keys: kind"},
      {wall("motion = { kind = 'rotating' }\n"),
       "s.toml:5:10: walls[0].motion.omega is missing: must be a number"},
      {wall("motion = { kind = 'rotating', omega = 'fast' }\n"),
       "s.toml:5:39: walls[0].motion.omega = \"fast\": must be a number, not a string"},
      {wall("motion = { kind = 'rotating', velocity = [1, 0] }\n"),
       "s.toml:5:31: walls[0].motion.velocity = [1, 0]: unknown key; valid keys: kind, omega"},
      {wall("motion = { kind = 'translating' }\n"),
       "s.toml:5:10: walls[0].motion.velocity is missing: must be two numbers [x, y]"},
      {wall("motion = { kind = 'translating', omega = 1 }\n"),
       "s.toml:5:34: walls[0].motion.omega = 1: unknown key; valid keys: kind, velocity"},
      {wall("motion = { kind = 'linear', gradient = [[1, 0]] }\n"),
       "s.toml:5:40: walls[0].motion.gradient = [[1, 0]]: must be two rows of two numbers [[a, b], "
       "[c, d]], not an array of 1"},
      {wall("motion = { kind = 'linear', rate = 1 }\n"),
       "s.toml:5:29: walls[0].motion.rate = 1: unknown key; valid keys: kind, gradient"},
      {wall("motion = { kind = 'radial', speed = 1 }\n"),
       "s.toml:5:10: walls[0].motion: radial motion requires a wall whose shape is a circle"},
      {tank() + "motion = { kind = 'radial' }\n",
       "s.toml:5:10: walls[0].motion.speed is missing: must be a number"},
      {tank() + "motion = { kind = 'radial', velocity = [1, 1] }\n",
       "s.toml:5:29: walls[0].motion.velocity = [1, 1]: unknown key; valid keys: kind, speed"},
      {tank() + "motion = { kind = 'parabolic', speed = 1 }\n",
       "s.toml:5:10: walls[0].motion: parabolic motion requires a wall whose shape is a "
       "superellipse"},
  });
}

BOOST_AUTO_TEST_CASE(bodies) {
  check({
      {disk(""),
       "s.toml:1:1: bodies[0].n_nodes is missing: must be an even integer >= 8 or \"auto\""},
      {disk("n_nodes = 31\n"),
       "s.toml:3:11: bodies[0].n_nodes = 31: must be an even integer >= 8 or \"auto\" (try 32)"},
      {disk("n_nodes = 6\n"),
       "s.toml:3:11: bodies[0].n_nodes = 6: must be an even integer >= 8 or \"auto\" (try 8)"},
      {disk("n_nodes = -2\n"),
       "s.toml:3:11: bodies[0].n_nodes = -2: must be an even integer >= 8 or \"auto\" (try 8)"},
      {disk("n_nodes = 32.0\n"),
       "s.toml:3:11: bodies[0].n_nodes = 32.0: must be an even integer >= 8 or \"auto\", not a "
       "float"},
      {disk("n_nodes = 5000000000\n"),
       "s.toml:3:11: bodies[0].n_nodes = 5000000000: must be at most 1000000"},
      {disk("n_nodes = 2147483647\n"),
       "s.toml:3:11: bodies[0].n_nodes = 2147483647: must be at most 1000000"},
      {disk("n_nodes = 1000002\n"),
       "s.toml:3:11: bodies[0].n_nodes = 1000002: must be at most 1000000"},
      {disk("n_nodes = 999999\n"),
       "s.toml:3:11: bodies[0].n_nodes = 999999: must be an even integer >= 8 or \"auto\" (try "
       "1000000)"},
      {disk("n_nodes = 'many'\n"),
       "s.toml:3:11: bodies[0].n_nodes = \"many\": must be an even integer >= 8 or \"auto\", not a "
       "string"},
      {disk("n_nodes = 'Auto'\n"),
       "s.toml:3:11: bodies[0].n_nodes = \"Auto\": must be an even integer >= 8 or \"auto\", not a "
       "string"},
      {disk("position = 'here'\n"),
       "s.toml:3:12: bodies[0].position = \"here\": must be two numbers [x, y], not a string"},
      {disk("orientation = inf\n"),
       "s.toml:3:15: bodies[0].orientation = inf: must be a number, and finite"},
      {disk("held = 1\n"), "s.toml:3:8: bodies[0].held = 1: must be true or false, not an integer"},
      {disk("force = 1\n"),
       "s.toml:3:9: bodies[0].force = 1: must be two numbers [x, y], not an integer"},
      {disk("torque = [1, 0]\n"),
       "s.toml:3:10: bodies[0].torque = [1, 0]: must be a number, not an array of 2"},
      {disk("held = true\nforce = [1, 0]\n"),
       "s.toml:4:1: bodies[0].force = [1, 0]: force and torque of a held body are results; remove "
       "them, or set held = false"},
      {disk("torque = 0.0\nheld = true\n"),
       "s.toml:3:1: bodies[0].torque = 0.0: force and torque of a held body are results; remove "
       "them, or set held = false"},
      {disk("velocity = [1, 0]\n"),
       "s.toml:3:1: bodies[0].velocity = [1, 0]: velocity and omega of a free body are results; "
       "remove them, or set held = true"},
      {disk("held = false\nomega = 1\n"),
       "s.toml:4:1: bodies[0].omega = 1: velocity and omega of a free body are results; remove "
       "them, or set held = true"},
      {disk("held = true\nvelocity = 1\n"),
       "s.toml:4:12: bodies[0].velocity = 1: must be two numbers [x, y], not an integer"},
      {disk("held = true\nomega = [1]\n"),
       "s.toml:4:9: bodies[0].omega = [1]: must be a number, not an array of 1"},
      {disk("mass = 1\n"),
       "s.toml:3:1: bodies[0].mass = 1: unknown key; valid keys: shape, position, orientation, "
       "force, torque, held, velocity, omega, n_nodes, slip, amplitude, density, trap, "
       "magnetic_moment"},
      {disk("n_nodes = 8\nheld = true\nslip = { kind = 'squirmer', modes = [1] }\n"),
       "s.toml:5:1: bodies[0].slip: a held body has no slip; remove it, or set held = false"},
      {disk("n_nodes = 8\nslip = { kind = 'squirmer' }\n"),
       "s.toml:4:8: bodies[0].slip.modes is missing: must be a list of one or more numbers [B_1, "
       "B_2, ...]"},
      {disk("n_nodes = 8\nslip = { kind = 'squirmer', modes = [] }\n"),
       "s.toml:4:37: bodies[0].slip.modes = []: must be a list of one or more numbers [B_1, B_2, "
       "...]"},
      {disk("n_nodes = 8\nslip = { modes = [1] }\n"),
       "s.toml:4:8: bodies[0].slip.kind is missing: must be one of squirmer, data"},
      {disk("n_nodes = 8\nslip = { kind = 'data' }\n"),
       "s.toml:4:8: bodies[0].slip.file is missing: must be the name of a CSV file, or rows = [[t, "
       "u, v], ...]"},
      {disk("n_nodes = 8\nslip = { kind = 'data', rows = 1 }\n"),
       "s.toml:4:32: bodies[0].slip.rows = 1: must be a list [[t, u, v], ...], not an integer"},
      {disk("n_nodes = 8\nslip = { kind = 'data', rows = [[0, 1]] }\n"),
       "s.toml:4:33: bodies[0].slip.rows[0] = [0, 1]: must be three numbers [t, u, v]"},
      {disk("n_nodes = 8\nslip = { kind = 'data', rows = [[0, 1, 0]] }\n"),
       "s.toml:4:32: bodies[0].slip.rows = [[0, 1, 0]]: must hold at least 4 rows"},
      {disk("n_nodes = 8\nslip = { kind = 'data', rows = [[7, 1, 0]] }\n"),
       "s.toml:4:33: bodies[0].slip.rows[0] = [7, 1, 0]: t must be >= 0 and < 2 pi, not 7"},
      {disk("n_nodes = 8\nslip = { kind = 'data', rows = [[0, 1, 0], [0, 1, 0]] }\n"),
       "s.toml:4:44: bodies[0].slip.rows[1] = [0, 1, 0]: t must be larger than in the row before, "
       "not 0"},
      {disk("n_nodes = 8\nslip = { kind = 'data', file = 'a.csv', rows = [] }\n"),
       "s.toml:4:25: bodies[0].slip.file = \"a.csv\": give file or rows, not both"},
      {disk() + disk("n_nodes = 9\n"),
       "s.toml:6:11: bodies[1].n_nodes = 9: must be an even integer >= 8 or \"auto\" (try 10)"},
  });
}

BOOST_AUTO_TEST_CASE(fills) {
  check({
      {fill(""), "s.toml:1:1: fill[0]: must hold area_fraction or count, and not both"},
      {fill("area_fraction = 0.1\ncount = 5\n"),
       "s.toml:1:1: fill[0]: must hold area_fraction or count, and not both"},
      {fill("area_fraction = 0\n"),
       "s.toml:4:17: fill[0].area_fraction = 0: must be a number > 0 and < 1"},
      {fill("area_fraction = 1.0\n"),
       "s.toml:4:17: fill[0].area_fraction = 1.0: must be a number > 0 and < 1"},
      {fill("count = 0\n"), "s.toml:4:9: fill[0].count = 0: must be an integer >= 1"},
      {fill("count = 2.5\n"),
       "s.toml:4:9: fill[0].count = 2.5: must be an integer >= 1, not a float"},
      {fill("count = 5\n"),
       "s.toml:1:1: fill[0].region is missing: must be { box = [xmin, ymin, xmax, ymax] } "
       "(\"fluid\" requires an outer wall)"},
      {fill("count = 5\nregion = 'fluid'\n"),
       "s.toml:5:10: fill[0].region = \"fluid\": must be { box = [xmin, ymin, xmax, ymax] } "
       "(\"fluid\" requires an outer wall)"},
      {tank() + fill("count = 5\nregion = 'all'\n"),
       "s.toml:9:10: fill[0].region = \"all\": must be \"fluid\" or { box = [xmin, ymin, xmax, "
       "ymax] }"},
      {tank() + fill("count = 5\nregion = 3\n"),
       "s.toml:9:10: fill[0].region = 3: must be \"fluid\" or { box = [xmin, ymin, xmax, ymax] }, "
       "not an integer"},
      {fill("count = 5\nregion = { box = [0, 0, 1] }\n"),
       "s.toml:5:18: fill[0].region.box = [0, 0, 1]: must be [xmin, ymin, xmax, ymax] with xmin < "
       "xmax and ymin < ymax, not an array of 3"},
      {fill("count = 5\nregion = { box = [1, 0, 1, 1] }\n"),
       "s.toml:5:18: fill[0].region.box = [1, 0, 1, 1]: must be [xmin, ymin, xmax, ymax] with xmin "
       "< xmax and ymin < ymax"},
      {fill("count = 5\nregion = { box = [0, 1, 1, 1] }\n"),
       "s.toml:5:18: fill[0].region.box = [0, 1, 1, 1]: must be [xmin, ymin, xmax, ymax] with xmin "
       "< xmax and ymin < ymax"},
      {fill("count = 5\nregion = { bx = [0, 0, 1, 1] }\n"),
       "s.toml:5:12: fill[0].region.bx = [0, 0, 1, 1]: unknown key, did you mean 'box'?"},
      {fill("count = 5\nregion = {}\n"),
       "s.toml:5:10: fill[0].region.box is missing: must be [xmin, ymin, xmax, ymax] with xmin < "
       "xmax and ymin < ymax"},
      {tank() + fill("count = 5\nclearance = -0.1\n"),
       "s.toml:9:13: fill[0].clearance = -0.1: must be a number >= 0"},
      {tank() + fill("count = 5\nposition = [0, 0]\n"),
       "s.toml:9:1: fill[0].position = [0, 0]: unknown key; valid keys: shape, sizes, "
       "area_fraction, count, region, clearance, n_nodes, force, torque, slip, amplitude, density, "
       "trap, magnetic_moment"},
      {tank() + fill("area_fraction = 0.5\nsizes = [1.0, 2.0]\n"),
       "s.toml:9:10: fill[0].sizes[0] = 1.0: must be two numbers > 0, not a float"},
      {tank() + fill("area_fraction = 0.5\nsizes = [[1.0, 0.0]]\n"),
       "s.toml:9:10: fill[0].sizes[0] = [1.0, 0.0]: must be two numbers > 0"},
      {tank() + fill("area_fraction = 0.5\nsizes = []\n"),
       "s.toml:9:9: fill[0].sizes = []: must be a list of one or more sizes and shares, [[size, "
       "share], ...]"},
      {tank() + fill("count = 5\nsizes = [[1.0, 1.0]]\n"),
       "s.toml:9:1: fill[0].sizes = [[1.0, 1.0]]: sizes require area_fraction; remove count"},
      {tank() + "[[fill]]\nshape = { kind = 'circle', radius = 1 }\ncount = 5\n",
       "s.toml:5:1: fill[0].n_nodes is missing: must be an even integer >= 8 or \"auto\""},
      {tank() + "[[fill]]\ncount = 5\nn_nodes = 32\n",
       "s.toml:5:1: fill[0].shape is missing: must be a table, such as { kind = \"circle\", radius "
       "= 1.0 }"},
  });
}

BOOST_AUTO_TEST_SUITE_END()
