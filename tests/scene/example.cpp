// Tests a scene with every section, as in the documentation of the scene format.

#include <string>

#include "scene_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const std::string start = R"(
title = "Two disks in shear"
seed = 1                                  # all randomness of the scene

[fluid]
viscosity = 1.0

[flow]
reverse_at = [20.0]                       # times at which all driving changes sign
)";

const std::string shear = R"(
kind = "shear"
rate = 1.0
# velocity = [1.0, 0.0]
# gradient = [[0.0, 1.0], [0.0, 0.0]]
gauge_length = 1.0
)";

const std::string tank_in_rotation = R"(
[[walls]]
role = "outer"
shape = { kind = "circle", radius = 10.0 }
position = [0.0, 0.0]
orientation = 0.0
n_nodes = 256
motion = { kind = "rotating", omega = 1.0 }
)";

const std::string rest = R"(
[[bodies]]
shape = { kind = "ellipse", semi_axes = [1.0, 0.5] }
position = [0.0, 0.0]
orientation = 0.0                         # radians, counter-clockwise
force = [0.0, 0.0]                        # external load on the body
torque = 0.0
held = false
n_nodes = 32

[[body_lists]]
file = "bodies.csv"
shape = { kind = "circle", radius = 0.5 }
n_nodes = 32

[solver]
tolerance = 1e-8
gmres_tol = 1e-9
gmres_max_iterations = 500
summation = "auto"
near_singular = "auto"
preconditioner = "auto"
coupling = "global"

[time]
t_final = 40.0
dt = 0.2
method = "euler"

[contact]
minimum_separation = 0.01                 # length; or "0.05h"
allow_close = false

[output]
dt_write = 0.2
formats = ["csv", "vtk"]
)";

std::string fill_in(const std::string& region) {
  return "[[fill]]\nshape = { kind = \"ellipse\", semi_axes = [0.375, 0.125] }\n"
         "area_fraction = 0.10\nregion = " +
         region + "\nclearance = 0.05\nn_nodes = 32\n";
}

SceneFile parse_with_bodies(const std::string& text) {
  const Folder folder;
  folder.write("bodies.csv", "x,y,theta\n3,0,0\n-3,0,0.5\n");
  return parse_file(text, {}, folder.path());
}

}  // namespace

BOOST_AUTO_TEST_SUITE(example)

BOOST_AUTO_TEST_CASE(enclosed) {
  const auto [scene, fills] =
      parse_with_bodies(start + tank_in_rotation + rest + fill_in("\"fluid\""));
  BOOST_TEST((scene.flow == BackgroundFlow(QuiescentFlow{})));
  BOOST_TEST((scene.walls.at(0).motion == WallMotion(RotatingWall{1.0})));
  BOOST_TEST(scene.bodies.size() == 3);
  BOOST_TEST(!fills.at(0).box.has_value());
  BOOST_TEST(scene.contact.value().minimum_separation == 0.01);
  BOOST_TEST(scene.output.formats.size() == 2);
}

BOOST_AUTO_TEST_CASE(unbounded) {
  const auto [scene, fills] =
      parse_with_bodies(start + shear + rest + fill_in("{ box = [-9.0, -9.0, 9.0, 9.0] }"));
  BOOST_TEST((scene.flow == BackgroundFlow(ShearFlow{1.0})));
  BOOST_TEST(scene.gauge_length.value() == 1.0);
  BOOST_TEST(scene.bodies.at(2).orientation == 0.5);
  BOOST_TEST(fills.at(0).box.value()[3] == 9.0);
}

BOOST_AUTO_TEST_SUITE_END()
