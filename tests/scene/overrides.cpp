// Tests that settings of the command line replace and add values, and that their errors name them.
#include <string>

#include "scene_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const std::string two_disks = disk() + disk() + "[time]\nt_final = 1\ndt = 0.1\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(overrides)

BOOST_AUTO_TEST_CASE(replace_values) {
  const Scene scene = parse(two_disks, {"time.dt=0.01", "bodies.1.n_nodes = 64", "title=\"x=y\"",
                                        "bodies.0.position=[1, 2]", "bodies.1.position=[4,2]"});
  BOOST_TEST(scene.time->dt.value() == 0.01);
  BOOST_TEST(scene.time->t_final == 1.0);
  BOOST_TEST(scene.bodies[0].n_nodes == 32);
  BOOST_TEST(scene.bodies[1].n_nodes == 64);
  BOOST_TEST(scene.title == "x=y");
  BOOST_TEST(scene.bodies[0].position == Complex(1.0, 2.0));
  BOOST_TEST(scene.bodies[1].position == Complex(4.0, 2.0));
}

BOOST_AUTO_TEST_CASE(paths_may_be_written_as_messages_write_them) {
  const Scene scene = parse(two_disks, {"bodies[1].n_nodes=64", "bodies[0].shape.radius = 0.25"});
  BOOST_TEST(scene.bodies[0].n_nodes == 32);
  BOOST_TEST(scene.bodies[1].n_nodes == 64);
  BOOST_TEST((scene.bodies[0].shape == Shape(Circle{0.25})));
  BOOST_TEST(
      error_of(two_disks, {"bodies[2].n_nodes=8"}) ==
      "--set bodies[2].n_nodes: bodies has 2 elements, numbered from 0; there is no element '2'");
}

BOOST_AUTO_TEST_CASE(add_values_and_tables) {
  const Scene scene = parse(disk(), {"time.t_final=3", "time.dt=0.5", "flow.kind='shear'",
                                     "flow.rate=2", "bodies.0.shape.radius=0.25"});
  BOOST_TEST(scene.time->t_final == 3.0);
  BOOST_TEST((scene.flow == BackgroundFlow(ShearFlow{2.0})));
  BOOST_TEST((scene.bodies[0].shape == Shape(Circle{0.25})));
}

BOOST_AUTO_TEST_CASE(replace_whole_tables) {
  const Scene scene = parse(disk(), {"bodies.0.shape={ kind='ellipse', semi_axes=[2, 1] }"});
  BOOST_TEST((scene.bodies[0].shape == Shape(Ellipse{2.0, 1.0})));
  BOOST_TEST(parse("", {"bodies=[{shape={kind='circle',radius=1},n_nodes=8}]"}).bodies.size() == 1);
}

BOOST_AUTO_TEST_CASE(words_need_no_quotation_marks) {
  BOOST_TEST((parse(two_disks, {"solver.summation=fmm"}).solver.summation == Summation::fmm));
  BOOST_TEST((parse(two_disks, {"solver.preconditioner=block_diagonal"}).solver.preconditioner ==
              PreconditionerKind::block_diagonal));
  BOOST_TEST(parse(two_disks, {"title=x-1_b"}).title == "x-1_b");
  BOOST_TEST(error_of(two_disks, {"time.dt=fast"}) ==
             "--set time.dt: time.dt = \"fast\": must be a number > 0, not a string");
  BOOST_TEST(parse(two_disks, {"bodies.0.held=true"}).bodies[0].held);
  BOOST_TEST(error_of(two_disks, {"time.dt=inf"}).find("inf") != std::string::npos);
  BOOST_TEST(error_of(two_disks, {"time.dt=inf"}).find('"') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_last_one_counts) {
  BOOST_TEST(parse(two_disks, {"time.dt=0.2", "time.dt=0.4"}).time->dt.value() == 0.4);
}

BOOST_AUTO_TEST_CASE(errors_name_the_setting) {
  const auto message = [](const std::string& setting) { return error_of(two_disks, {setting}); };
  BOOST_TEST(message("time.dt=-1") == "--set time.dt: time.dt = -1: must be a number > 0");
  BOOST_TEST(message("bodies.1.n_nodes=31") ==
             "--set bodies.1.n_nodes: bodies[1].n_nodes = 31: must be an even integer >= 8 or "
             "\"auto\" (try "
             "32)");
  BOOST_TEST(message("flow={ kind='sheer' }") ==
             "--set flow: flow.kind = \"sheer\": must be one of quiescent, uniform, shear, "
             "extensional, taylor_green, linear, sum");
  BOOST_TEST(message("time.st=1") == "--set time.st: time.st = 1: unknown key, did you mean 'dt'?");
  BOOST_TEST(message("tme.dt=1") == "--set tme.dt: tme: unknown key, did you mean 'time'?");
  BOOST_TEST(message("fill.0.count=5") ==
             "--set fill.0.count: fill: must be an array of tables: write [[fill]], not a table");
  // Error messages still give the place in the file of values that are not overridden.
  BOOST_TEST(message("time.tolerance=1") ==
             "--set time.tolerance: time.tolerance = 1: must be a number from 1e-13 to 0.1");
  BOOST_TEST(error_of(disk("n_nodes = 31\n"), {"seed=1"}).starts_with("s.toml:3:11: "));
}

BOOST_AUTO_TEST_CASE(errors_of_form) {
  const auto message = [](const std::string& setting) { return error_of(two_disks, {setting}); };
  const std::string form = "must have the form key=value, such as time.dt=0.01";
  BOOST_TEST(message("time.dt") == "--set time.dt: " + form);
  BOOST_TEST(message("=1") == "--set : " + form);
  BOOST_TEST(message("") == "--set : " + form);
  const std::string value = "must be a TOML value (write text in double quotes)";
  BOOST_TEST(message("time.method=rk 4") == "--set time.method: time.method = rk 4: " + value);
  BOOST_TEST(message("time.dt=") == "--set time.dt: time.dt = : " + value);
  BOOST_TEST(message("time.dt=1\nseed=2") == "--set time.dt: time.dt = 1\nseed=2: " + value);
}

BOOST_AUTO_TEST_CASE(errors_of_path) {
  const auto message = [](const std::string& setting) { return error_of(two_disks, {setting}); };
  const std::string two = "bodies has 2 elements, numbered from 0; there is no element ";
  BOOST_TEST(message("bodies.2.n_nodes=8") == "--set bodies.2.n_nodes: " + two + "'2'");
  BOOST_TEST(message("bodies.-1.n_nodes=8") == "--set bodies.-1.n_nodes: " + two + "'-1'");
  BOOST_TEST(message("bodies.1x.n_nodes=8") == "--set bodies.1x.n_nodes: " + two + "'1x'");
  BOOST_TEST(message("bodies.n_nodes=8") == "--set bodies.n_nodes: " + two + "'n_nodes'");
  BOOST_TEST(message("time.dt.first=8") ==
             "--set time.dt.first: time.dt = 0.1: has no 'first' in it");
  BOOST_TEST(message("time..dt=8") ==
             "--set time..dt: time.: unknown key; valid keys: t_final, dt, method, tolerance, "
             "dt_min, dt_max, effort");
}

BOOST_AUTO_TEST_SUITE_END()
