// Tests scene files, and the files that scenes name.

#include <cmath>
#include <string>
#include <vector>

#include "scene/write.hpp"
#include "scene_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const std::string octagon_csv = "x,y\n2,0\n1,1\n0,1\n-1,1\n-2,0\n-1,-1\n0,-1\n1,-1\n";
const std::string nodal_body = body_with_shape("{ kind = 'nodes', file = 'a.csv' }");
const std::string list =
    "[[body_lists]]\nfile = 'a.csv'\nshape = { kind = 'circle', radius = 0.5 }\nn_nodes = 32\n";
const std::string list_of_ellipses = "[[body_lists]]\nfile = 'a.csv'\nn_nodes = 32\n";

}  // namespace

BOOST_AUTO_TEST_SUITE(files)

BOOST_AUTO_TEST_CASE(scene_file) {
  const Folder folder;
  folder.write("s.toml", disk("n_nodes = 31\n"));
  BOOST_CHECK_EXCEPTION(read_scene(folder.at("s.toml")), SceneError, [&](const SceneError& error) {
    return error.what() ==
           folder.at("s.toml") +
               ":3:11: bodies[0].n_nodes = 31: must be an even integer >= 8 or \"auto\" (try "
               "32)";
  });
  const Overrides overrides{"bodies.0.n_nodes=40"};
  BOOST_TEST((read_scene(folder.at("s.toml"), overrides) == parse_file(disk("n_nodes = 40\n"))));
}

BOOST_AUTO_TEST_CASE(no_scene_file) {
  const Folder folder;
  for (const std::string& path : {folder.at("missing.toml"), folder.path().string()}) {
    BOOST_CHECK_EXCEPTION(read_scene(path), SceneError, [&](const SceneError& error) {
      return error.what() == path + ": the file does not exist or cannot be read";
    });
  }
}

BOOST_AUTO_TEST_CASE(windows_line_ends) {
  BOOST_TEST(
      (parse("[[bodies]]\r\nshape = { kind = 'circle', radius = 0.5 }\r\nn_nodes = 32\r\n") ==
       parse(disk())));
}

BOOST_AUTO_TEST_CASE(files_are_relative_to_the_scene) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "data");
  folder.write("data/a.csv", "x,y,theta\n1,2,3\n");
  folder.write("s.toml",
               "[[body_lists]]\nfile = 'data/a.csv'\nshape = { kind = 'circle', radius = 1 }\n"
               "n_nodes = 32\n");
  BOOST_TEST(read_scene(folder.at("s.toml")).scene.bodies.size() == 1);
  BOOST_TEST(parse("[[body_lists]]\nfile = '" + folder.at("data/a.csv") +
                   "'\nshape = { kind = 'circle', radius = 1 }\nn_nodes = 32\n")
                 .bodies.size() == 1);
}

BOOST_AUTO_TEST_CASE(nodal_curve) {
  const Folder folder;
  folder.write("a.csv", octagon_csv);
  const Scene scene = parse(nodal_body, {}, folder.path());
  const auto& curve = std::get<NodalCurve>(scene.bodies.at(0).shape);
  BOOST_REQUIRE(curve.points.size() == 8);
  BOOST_TEST(curve.points[0] == Complex(2.0, 0.0));
  BOOST_TEST(curve.points[7] == Complex(1.0, -1.0));
  BOOST_TEST(curve.file == folder.at("a.csv"));
  // The written scene contains the points and needs no other file.
  BOOST_TEST((parse(to_toml({scene})) == scene));
}

BOOST_AUTO_TEST_CASE(list_of_equal_bodies) {
  const Folder folder;
  folder.write("a.csv",
               "# made by hand\r\n x , y , theta \r\n1, 2,3\r\n\r\n 4.5,-5e-1 ,6 # last\r\n\r\n");
  const Scene scene = parse(disk() + list + "force = [7, 8]\ntorque = 9\n", {}, folder.path());
  Body listed{.shape = Circle{0.5}, .force = {7, 8}, .torque = 9, .n_nodes = 32};
  std::vector<Body> expected = parse(disk()).bodies;
  listed.position = {1, 2};
  listed.orientation = 3;
  expected.push_back(listed);
  listed.position = {4.5, -0.5};
  listed.orientation = 6;
  expected.push_back(listed);
  BOOST_TEST((scene.bodies == expected));
}

BOOST_AUTO_TEST_CASE(numbers_of_other_programs) {
  const Folder folder;
  folder.write("a.csv", "x,\ty,\ttheta\n+1.5,\t1e-400,\t-1e-400\n+1E+2,5e-324,0.1e-400\n");
  const std::vector<Body> bodies = parse(list, {}, folder.path()).bodies;
  BOOST_TEST(bodies.at(0).position == Complex(1.5, 0.0));
  BOOST_TEST(bodies.at(0).orientation == 0.0);
  BOOST_TEST(bodies.at(1).position == Complex(100.0, 5e-324));
  BOOST_TEST(bodies.at(1).orientation == 0.0);
}

BOOST_AUTO_TEST_CASE(velocity_data) {
  const std::string data = "{ kind = 'data', file = 'a.csv' }\n";
  const std::string body = disk("n_nodes = 8\nslip = " + data);
  const Folder folder;
  folder.write("a.csv", "t, u, v\n0,1,2\n1.5,3,4\n3,5,6\n4,7,8\n");
  folder.write("b.csv", "x,y,theta\n1,2,3\n4,5,6\n");
  const VelocityData expected{{{0, 1, 2}, {1.5, 3, 4}, {3, 5, 6}, {4, 7, 8}}};
  const Scene scene =
      parse(tank() + "motion = " + data + body +
                "[[body_lists]]\nfile = 'b.csv'\nshape = { kind = 'circle', radius = "
                "1 }\nn_nodes = 8\nslip = " +
                data,
            {}, folder.path());
  BOOST_TEST((scene.walls[0].motion == WallMotion(expected)));
  BOOST_REQUIRE(scene.bodies.size() == 3);
  for (const Body& listed : scene.bodies) BOOST_TEST((listed.slip == Slip(expected)));
  BOOST_TEST((parse(to_toml({scene})) == scene));

  BOOST_TEST(error_with_csv(body, "x,y\n") == "a.csv:1: header = x,y: must be t,u,v");
  BOOST_TEST(error_with_csv(body, "t,u,v\n0,1,1\n6.3,1,1\n") ==
             "a.csv:3: t must be >= 0 and < 2 pi, not 6.3");
  BOOST_TEST(error_with_csv(body, "t,u,v\n-0.5,1,1\n") ==
             "a.csv:2: t must be >= 0 and < 2 pi, not -0.5");
  BOOST_TEST(error_with_csv(body, "t,u,v\n1,1,1\n0.5,1,1\n") ==
             "a.csv:3: t must be larger than in the row before, not 0.5");
  BOOST_TEST(error_with_csv(body, "t,u,v\n0,1,1\n1,1,1\n2,1,1\n") ==
             "s.toml:4:32: bodies[0].slip.file = \"a.csv\": must hold at least 4 rows");
}

BOOST_AUTO_TEST_CASE(list_of_ellipses_and_order_of_lists) {
  const Folder folder;
  folder.write("a.csv",
               "\xEF\xBB\xBF"
               "cx,cy,semi_a,semi_b,theta\n1,2,3,4,5\n");
  folder.write("b.csv", "x,y,theta\n6,7,8\n");
  const Scene scene = parse(
      list_of_ellipses +
          "[[body_lists]]\nfile = 'b.csv'\nshape = { kind = 'circle', radius = 9 }\nn_nodes = 8\n" +
          disk(),
      {}, folder.path());
  const std::vector<Body> expected{
      {.shape = Circle{0.5}, .n_nodes = 32},
      {.shape = Ellipse{3, 4}, .position = {1, 2}, .orientation = 5, .n_nodes = 32},
      {.shape = Circle{9}, .position = {6, 7}, .orientation = 8, .n_nodes = 8}};
  BOOST_TEST((scene.bodies == expected));
}

BOOST_AUTO_TEST_CASE(bad_lists) {
  const std::string one = "x,y,theta\n1,2,3\n";
  const std::string ellipse = "cx,cy,semi_a,semi_b,theta\n1,2,3,4,5\n";
  const std::string headers =
      "x,y,theta or cx,cy,theta with any of fx, fy, torque, density, and radius or semi_a, semi_b";
  BOOST_TEST(error_with_csv(list, "") ==
             "a.csv: must hold rows of numbers below the header " + headers);
  BOOST_TEST(error_with_csv(list, "x,y,theta\n\n") ==
             "a.csv: must hold rows of numbers below the header " + headers);
  BOOST_TEST(error_with_csv(list, "1,2,3\n") == "a.csv:1: header = 1,2,3: must be " + headers);
  BOOST_TEST(error_with_csv(list, "# c\nx,theta\n") ==
             "a.csv:2: header = x,theta: must be " + headers);
  BOOST_TEST(error_with_csv(list, ",x,y,theta\n1,2,3,4\n") ==
             "a.csv:1: header = ,x,y,theta: must be " + headers);
  BOOST_TEST(error_with_csv(list, one + "\n4,5\n") ==
             "a.csv:4: must hold 3 values (x,y,theta), not 2");
  BOOST_TEST(error_with_csv(list, one + "4,5,6,7\n") ==
             "a.csv:3: must hold 3 values (x,y,theta), not 4");
  BOOST_TEST(error_with_csv(list, one + "4,five,6\n") ==
             "a.csv:3: y = five: must be a number with magnitude at most 1e100");
  BOOST_TEST(error_with_csv(list, one + "4,5 5,6\n") ==
             "a.csv:3: y = 5 5: must be a number with magnitude at most 1e100");
  BOOST_TEST(error_with_csv(list, one + "4,5,\n") ==
             "a.csv:3: theta = : must be a number with magnitude at most 1e100");
  BOOST_TEST(error_with_csv(list, one + "nan,5,6\n") ==
             "a.csv:3: x = nan: must be a number with magnitude at most 1e100");
  BOOST_TEST(error_with_csv(list, one + "4,5,inf\n") ==
             "a.csv:3: theta = inf: must be a number with magnitude at most 1e100");
  BOOST_TEST(error_with_csv(list, one + "4,5,1e999\n") ==
             "a.csv:3: theta = 1e999: must be a number with magnitude at most 1e100");
  for (const std::string number : {"+-1", "++1", "+", "-", "1e400", "-1e400", "1e-400x"}) {
    BOOST_TEST(error_with_csv(list, one + "4," + number + ",6\n") ==
               "a.csv:3: y = " + number + ": must be a number with magnitude at most 1e100");
  }
  BOOST_TEST(error_with_csv(list_of_ellipses, ellipse + "1,2,0,4,5\n") ==
             "a.csv:3: semi_a = 0.0: must be a number > 0");
  BOOST_TEST(error_with_csv(list_of_ellipses, ellipse + "1,2,3,-4.5,5\n") ==
             "a.csv:3: semi_b = -4.5: must be a number > 0");
  BOOST_TEST(
      error_with_csv(list, ellipse) ==
      "s.toml:3:1: body_lists[0].shape: the file gives each body its own ellipse; remove shape");
  BOOST_TEST(error_with_csv(list_of_ellipses, one) ==
             "s.toml:1:1: body_lists[0].shape is missing: must be a table, such as { kind = "
             "\"circle\", radius = 1.0 }");
  BOOST_TEST(error_with_csv(list + "held = true\n", one) ==
             "s.toml:5:1: body_lists[0].held = true: unknown key; valid keys: file, shape, force, "
             "torque, n_nodes, slip, amplitude, density, trap, magnetic_moment");
  BOOST_TEST(error_with_csv(list + "force = 1\n", one) ==
             "s.toml:5:9: body_lists[0].force = 1: must be two numbers [x, y], not an integer");
  BOOST_TEST(error_with_csv(list + "torque = 'x'\n", one) ==
             "s.toml:5:10: body_lists[0].torque = \"x\": must be a number, not a string");
  BOOST_TEST(
      error_with_csv("[[body_lists]]\nfile = 'a.csv'\n", ellipse) ==
      "s.toml:1:1: body_lists[0].n_nodes is missing: must be an even integer >= 8 or \"auto\"");
  BOOST_TEST(error_with_csv("[[body_lists]]\nn_nodes = 32\n", one) ==
             "s.toml:1:1: body_lists[0].file is missing: must be the name of a CSV file");
  BOOST_TEST(error_with_csv("[[body_lists]]\nfile = 'b.csv'\n", one) ==
             "s.toml:2:8: body_lists[0].file = \"b.csv\": the file b.csv does not exist or cannot "
             "be read");
}

BOOST_AUTO_TEST_CASE(bad_nodal_curves) {
  BOOST_TEST(error_with_csv(nodal_body, "x,y,theta\n") ==
             "a.csv:1: header = x,y,theta: must be x,y");
  BOOST_TEST(error_with_csv(nodal_body, "x,y\n1,0\n0,1\n-1,0\n") ==
             "s.toml:2:34: bodies[0].shape.file = \"a.csv\": must be at least 8 points, not 3");
  BOOST_TEST(error_with_csv(nodal_body, octagon_csv + "2,0\n") ==
             "a.csv:10: is the same point as the next one (the last joins the first)");
  BOOST_TEST(error_with_csv(nodal_body, octagon_csv + "0,3\n") ==
             "a.csv:3: the edge to the next point meets the edge that starts at [1, -1]");
  BOOST_TEST(error_with_csv(nodal_body, "x,y\n5,0\n4,1\n3,1\n2,1\n1,0\n2,-1\n3,-1\n4,-1\n") ==
             "s.toml:2:34: bodies[0].shape.file = \"a.csv\": the curve must go around the origin: "
             "loads act there");
  BOOST_TEST(error_with_csv(nodal_body, "x,y\n1,0\n0,x\n") ==
             "a.csv:3: y = x: must be a number with magnitude at most 1e100");
}

BOOST_AUTO_TEST_SUITE_END()
