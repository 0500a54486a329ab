// Tests loads and amplitudes of scene files: each key with a value that is not its default, columns
// of lists, and the messages for wrong values.

#include <string>
#include <vector>

#include "bad_scene.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const std::string lines_of_list = "[[body_lists]]\nfile = 'a.csv'\nn_nodes = 32\n";
const std::string disk_shape = "shape = { kind = 'circle', radius = 0.5 }\n";
const std::string gravity = "[gravity]\nacceleration = [0, -2]\nfluid_density = 3\n";
const std::string field = "[magnetic_field]\nfield = [1, 2]\n";

std::string sheared(const std::string& amplitude) {
  return "[flow]\nkind = 'shear'\nrate = 1\namplitude = " + amplitude + "\n" + disk();
}

Amplitude amplitude(const std::string& text) {
  return parse(sheared(text)).flow_amplitude;
}

std::vector<Body> bodies_in(const std::string& scene, const std::string& csv) {
  const Folder folder;
  folder.write("a.csv", csv);
  return parse(scene, {}, folder.path()).bodies;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(loads)

BOOST_AUTO_TEST_CASE(amplitudes) {
  BOOST_TEST((amplitude("{ kind = 'constant' }") == Amplitude{}));
  BOOST_TEST((amplitude("{ kind = 'steps', times = [0, 2], values = [1, -0.5] }") ==
              Amplitude{SteppedAmplitude{{0.0, 2.0}, {1.0, -0.5}}}));
  BOOST_TEST((amplitude("{ kind = 'ramp', times = [0.5, 2], values = [0, 3] }") ==
              Amplitude{RampedAmplitude{{0.5, 2.0}, {0.0, 3.0}}}));
  BOOST_TEST((amplitude("{ kind = 'oscillation', period = 4 }") ==
              Amplitude{OscillatingAmplitude{0.0, 1.0, 4.0, 0.0}}));
  BOOST_TEST(
      (amplitude("{ kind = 'oscillation', frequency = 4, mean = 1, amplitude = 2, phase = 3 }") ==
       Amplitude{OscillatingAmplitude{1.0, 2.0, 0.25, 3.0}}));
  const Amplitude four = OscillatingAmplitude{0.0, 1.0, 4.0, 0.0};
  const std::string key = "amplitude = { kind = 'oscillation', period = 4 }\n";
  BOOST_TEST(
      (parse(tank() + "motion = { kind = 'rotating', omega = 1 }\n" + key).walls[0].amplitude ==
       four));
  BOOST_TEST((parse(disk() + key).bodies[0].loads.amplitude == four));
  BOOST_TEST(
      (parse(disk("n_nodes = 8\ndensity = 1\n") + gravity + key).gravity->amplitude == four));
  BOOST_TEST((parse(disk() + field + key).magnetic_field->amplitude == four));
}

BOOST_AUTO_TEST_CASE(bodies_fills_and_sections) {
  const std::string keys =
      "density = 4\ntrap = { stiffness = 5, centre = [6, 7] }\nmagnetic_moment = [8, 9]\n";
  const SceneFile file =
      parse_file(tank() + disk("n_nodes = 32\n" + keys) + "[[fill]]\n" + disk_shape +
                 "n_nodes = 32\ncount = 2\nforce = [1, 2]\ntorque = 3\n" + keys + gravity + field +
                 "frequency = 3\n[repulsion]\nstrength = 4\nrange = 5\n");
  const LoadLaws expected{{}, 4.0, Trap{5.0, Complex{6.0, 7.0}}, {8.0, 9.0}};
  BOOST_TEST((file.scene.bodies[0].loads == expected));
  BOOST_TEST((file.fills[0].body.loads == expected));
  BOOST_TEST(file.fills[0].body.force == Complex(1.0, 2.0));
  BOOST_TEST(file.fills[0].body.torque == 3.0);
  BOOST_TEST((file.scene.gravity == Gravity{{0.0, -2.0}, 3.0, {}}));
  BOOST_TEST((file.scene.magnetic_field == MagneticField{{1.0, 2.0}, 3.0, {}}));
  BOOST_TEST((file.scene.repulsion == Repulsion{4.0, 5.0}));
  BOOST_TEST((parse(disk("n_nodes = 8\ntrap = { stiffness = 5 }\n")).bodies[0].loads.trap ==
              Trap{5.0, {}}));
}

BOOST_AUTO_TEST_CASE(columns_of_lists) {
  const std::vector<Body> disks = bodies_in(
      lines_of_list + gravity, "radius,fy,x,density,theta,y,fx,torque\n1,2,3,4,5,6,7,8\n");
  Body expected{Circle{1.0}, {3.0, 6.0}, 5.0, {7.0, 2.0}, 8.0};
  expected.n_nodes = 32;
  expected.loads.density = 4.0;
  BOOST_TEST((disks == std::vector{expected}));
  const std::vector<Body> pushed =
      bodies_in(lines_of_list + disk_shape + "torque = 5\ntrap = { stiffness = 2 }\n",
                "cx,cy,theta,fx\n1,2,3,4\n");
  expected = {Circle{0.5}, {1.0, 2.0}, 3.0, {4.0, 0.0}, 5.0};
  expected.n_nodes = 32;
  expected.loads.trap = Trap{2.0, {}};
  BOOST_TEST((pushed == std::vector{expected}));
}

BOOST_AUTO_TEST_CASE(bad_columns) {
  const auto is_refused = [](const std::string& header) {
    return error_with_csv(lines_of_list + disk_shape, header + "\n")
        .starts_with("a.csv:1: header = ");
  };
  for (const std::string header :
       {"x,y", "x,theta", "cx,y,theta", "x,y,theta,x", "x,y,cx,cy,theta", "x,y,theta,semi_a",
        "x,y,theta,fz", "x,y,theta,radius,semi_a,semi_b"}) {
    BOOST_TEST(is_refused(header), header);
  }
  BOOST_TEST(error_with_csv(lines_of_list, "x,y,theta,radius\n1,2,3,-4\n") ==
             "a.csv:2: radius = -4.0: must be a number > 0");
  BOOST_TEST(
      error_with_csv(lines_of_list + disk_shape + gravity, "x,y,theta,density\n1,2,3,-4\n") ==
      "a.csv:2: density = -4.0: must be a number >= 0");
  BOOST_TEST(
      error_with_csv(lines_of_list + disk_shape + "force = [1, 2]\n", "x,y,theta,fy\n1,2,3,4\n") ==
      "s.toml:5:1: body_lists[0].force = [1, 2]: the file has the column fy");
  BOOST_TEST(error_with_csv(lines_of_list + disk_shape, "x,y,theta,radius\n1,2,3,4\n") ==
             "s.toml:4:1: body_lists[0].shape: the file gives each body its own circle; remove "
             "shape");
  BOOST_TEST(error_with_csv(lines_of_list + disk_shape, "x,y,theta,density\n1,2,3,4\n") ==
             "s.toml:2:8: body_lists[0].file = \"a.csv\": the column density has no effect: write "
             "[gravity], or remove it");
}

BOOST_AUTO_TEST_CASE(bad_amplitudes) {
  check({
      {sheared("1"), "s.toml:4:13: flow.amplitude = 1: must be a table, not an integer"},
      {sheared("{ kind = 'square' }"),
       "s.toml:4:22: flow.amplitude.kind = \"square\": must be one of constant, steps, ramp, "
       "oscillation"},
      {sheared("{ kind = 'ramp', times = [1, 1], values = [2, 3] }"),
       "s.toml:4:38: flow.amplitude.times = [1, 1]: must be a list of one or more ascending times "
       ">= 0"},
      {sheared("{ kind = 'ramp', times = [], values = [] }"),
       "s.toml:4:38: flow.amplitude.times = []: must be a list of one or more ascending times >= "
       "0"},
      {sheared("{ kind = 'ramp', times = [1, 2], values = [3] }"),
       "s.toml:4:55: flow.amplitude.values = [3]: must hold as many numbers as times"},
      {sheared("{ kind = 'steps', times = [1], values = [3] }"),
       "s.toml:4:39: flow.amplitude.times = [1]: must begin with 0, at which the first value "
       "begins"},
      {sheared("{ kind = 'oscillation' }"),
       "s.toml:4:13: flow.amplitude.period is missing: must be a number > 0"},
      {sheared("{ kind = 'oscillation', period = 1, frequency = 1 }"),
       "s.toml:4:37: flow.amplitude.period = 1: give period or frequency, not both"},
      {sheared("{ kind = 'oscillation', period = 1, offset = 1 }"),
       "s.toml:4:49: flow.amplitude.offset = 1: unknown key; valid keys: kind, mean, amplitude, "
       "period, phase, frequency"},
      {"[flow]\namplitude = { kind = 'constant' }\n" + disk(),
       "s.toml:2:1: flow.amplitude: has no effect: give kind, or remove it"},
      {tank() + "amplitude = { kind = 'constant' }\n",
       "s.toml:5:1: walls[0].amplitude: has no effect on a fixed wall: give a motion, or remove "
       "it"},
      {tank() + "[flow]\namplitude = { kind = 'constant' }\n",
       "s.toml:6:1: flow.amplitude: not allowed with an outer wall, which drives the flow; only "
       "reverse_at is"},
  });
}

BOOST_AUTO_TEST_CASE(bad_loads) {
  const std::string held = "held = true\nn_nodes = 8\n";
  check({
      {disk() + "density = 1\n",
       "s.toml:4:1: bodies[0].density = 1: has no effect: write [gravity], or remove it"},
      {disk() + "magnetic_moment = [1, 0]\n",
       "s.toml:4:1: bodies[0].magnetic_moment = [1, 0]: has no effect: write [magnetic_field], or "
       "remove it"},
      {disk() + "density = -1\n" + gravity,
       "s.toml:4:11: bodies[0].density = -1: must be a number >= 0"},
      {disk() + gravity, "s.toml:1:1: bodies[0].density is missing: must be a number >= 0"},
      {disk() + "density = 1\n" + tank() + "[[fill]]\n" + disk_shape + "count = 1\nn_nodes = 8\n" +
           gravity,
       "s.toml:9:1: fill[0].density is missing: must be a number >= 0"},
      {disk() + "density = 1\n[gravity]\nacceleration = [0, 0]\n",
       "s.toml:6:16: gravity.acceleration = [0, 0]: must be two numbers [x, y], not both 0"},
      {disk() + "density = 1\n[gravity]\nacceleration = [0, 1]\n",
       "s.toml:5:1: gravity.fluid_density is missing: must be a number >= 0"},
      {disk(held) + "trap = { stiffness = 1 }\n",
       "s.toml:5:1: bodies[0].trap: has no effect on a held body; remove it, or set held = false"},
      {disk() + "trap = { stiffness = 0 }\n",
       "s.toml:4:22: bodies[0].trap.stiffness = 0: must be a number > 0"},
      {disk() + "trap = { centre = [0, 0] }\n",
       "s.toml:4:8: bodies[0].trap.stiffness is missing: must be a number > 0"},
      {disk() + "[magnetic_field]\nfrequency = 1\n",
       "s.toml:4:1: magnetic_field.field is missing: must be two numbers [x, y]"},
      {disk() + "[repulsion]\nstrength = 1\nrange = 0\n",
       "s.toml:6:9: repulsion.range = 0: must be a number > 0"},
      {disk() + "[repulsion]\nrange = 1\n",
       "s.toml:4:1: repulsion.strength is missing: must be a number > 0"},
  });
}

BOOST_AUTO_TEST_SUITE_END()
