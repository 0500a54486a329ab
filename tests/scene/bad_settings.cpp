// Tests every error in the top level and the settings of a scene file, with the whole message of
// each.

#include <cmath>
#include <string>
#include <tuple>

#include "bad_scene.hpp"
#include "text/number_text.hpp"

using stokesbook::number_text;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(bad_settings)

// The words of the message are those of the TOML parser; the test compares the place only.
BOOST_AUTO_TEST_CASE(no_toml) {
  const auto place = [](const std::string& text) {
    const std::string message = error_of(text);
    return message.substr(0, message.find(": Error while parsing"));
  };
  BOOST_TEST(place("[time\n") == "s.toml:1:6");
  BOOST_TEST(place("seed = \n") == "s.toml:1:8");
  BOOST_TEST(place("seed = 1\nseed = 2\n") == "s.toml:2:8");
  BOOST_TEST(place("title = \"open\n") == "s.toml:1:14");
  BOOST_TEST(place("seed = 99999999999999999999\n") == "s.toml:1:28");
  BOOST_TEST(place("[time]\ndt = 1e999\n") == "s.toml:2:11");
}

BOOST_AUTO_TEST_CASE(keys_without_end) {
  const auto key_of = [](int parts) {
    std::string key = "a";
    for (int k = 1; k < parts; ++k) key += ".a";
    return key;
  };
  const std::string refused = ": a key must have at most 1000 parts";
  for (const std::string& text : {key_of(50000) + " = 1\n", "[" + key_of(50000) + "]\n",
                                  "x = {" + key_of(50000) + " = 1}\n"}) {
    const std::string message = error_of("seed = 1\n" + text);
    BOOST_TEST(message.starts_with("s.toml:2:"));
    BOOST_TEST(message.ends_with(refused));
  }
  for (const int parts : {1000, 1001}) {
    const bool is_refused = error_of(key_of(parts) + " = 1\n").ends_with(refused);
    BOOST_TEST(is_refused == (parts > 1000));
  }
  BOOST_TEST(error_of(disk(), {key_of(50000) + "=1"}) == "--set" + refused);
  BOOST_TEST(error_of(disk(), {"x={" + key_of(50000) + "=1}"}) == "--set x" + refused);
  BOOST_TEST(error_of(key_of(900) + " = 1\n").find("unknown key") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(top_level) {
  check({
      {"",
       "s.toml:1:1: a scene must have a wall, a body or a fill: write [[walls]], [[bodies]], ..."},
      {"title = 'nothing in it'\n",
       "s.toml:1:1: a scene must have a wall, a body or a fill: write [[walls]], [[bodies]], ..."},
      {"title = 3\n", "s.toml:1:9: title = 3: must be text, not an integer"},
      {"seed = -1\n", "s.toml:1:8: seed = -1: must be an integer >= 0"},
      {"seed = 1.5\n", "s.toml:1:8: seed = 1.5: must be an integer >= 0, not a float"},
      {"seed = 1979-05-27\n",
       "s.toml:1:8: seed = 1979-05-27: must be an integer >= 0, not a date or time"},
      {"tilte = 'x'\n", "s.toml:1:1: tilte = \"x\": unknown key, did you mean 'title'?"},
      {"title = 'x'\n\n[solvr]\n", "s.toml:3:2: solvr: unknown key, did you mean 'solver'?"},
      {"zeta = 1\nalpha = 1\n",
       "s.toml:1:1: zeta = 1: unknown key; valid keys: title, seed, fluid, flow, cell, walls, "
       "bodies, body_lists, fill, tracers, gravity, magnetic_field, repulsion, solver, time, "
       "contact, output"},
      {"[bodies]\n",
       "s.toml:1:1: bodies: must be an array of tables: write [[bodies]], not a table"},
      {"bodies = [1]\n", "s.toml:1:11: bodies[0] = 1: must be a table, not an integer"},
      {"walls = 1\n",
       "s.toml:1:9: walls = 1: must be an array of tables: write [[walls]], not an integer"},
      {"[[time]]\n", "s.toml:1:1: time = [{...}]: must be a table, not an array of 1"},
      {"time = true\n", "s.toml:1:8: time = true: must be a table, not a boolean"},
      {"fluid = 1\n", "s.toml:1:9: fluid = 1: must be a table, not an integer"},
      {"[fluid]\nviscosity = 0\n", "s.toml:2:13: fluid.viscosity = 0: must be a number > 0"},
      {"[fluid]\nviscosity = -1.5\n", "s.toml:2:13: fluid.viscosity = -1.5: must be a number > 0"},
      {"[fluid]\nviscosity = nan\n",
       "s.toml:2:13: fluid.viscosity = nan: must be a number > 0, and finite"},
      {"[fluid]\nviscosity = inf\n",
       "s.toml:2:13: fluid.viscosity = inf: must be a number > 0, and finite"},
      {"[fluid]\nviscosity = 'water'\n",
       "s.toml:2:13: fluid.viscosity = \"water\": must be a number > 0, not a string"},
      {"[fluid]\ndensity = 1\n",
       "s.toml:2:1: fluid.density = 1: unknown key; valid keys: viscosity"},
      {"[fluid]\n  viscosty = 1\n",
       "s.toml:2:3: fluid.viscosty = 1: unknown key, did you mean 'viscosity'?"},
  });
}

BOOST_AUTO_TEST_CASE(settings) {
  check({
      {"[solver]\ntolerance = 0\n",
       "s.toml:2:13: solver.tolerance = 0: must be a number from 1e-14 to 0.1"},
      {"[solver]\ntolerance = 9e-15\n",
       "s.toml:2:13: solver.tolerance = 9e-15: must be a number from 1e-14 to 0.1"},
      {"[solver]\ntolerance = 0.2\n",
       "s.toml:2:13: solver.tolerance = 0.2: must be a number from 1e-14 to 0.1"},
      {"[solver]\ngmres_tol = 0.0\n",
       "s.toml:2:13: solver.gmres_tol = 0.0: must be a number > 0 and < 1"},
      {"[solver]\ngmres_tol = 1\n",
       "s.toml:2:13: solver.gmres_tol = 1: must be a number > 0 and < 1"},
      {"[solver]\ngmres_max_iterations = 0\n",
       "s.toml:2:24: solver.gmres_max_iterations = 0: must be an integer >= 1"},
      {"[solver]\ngmres_max_iterations = 1e3\n",
       "s.toml:2:24: solver.gmres_max_iterations = 1000.0: must be an integer >= 1, not a float"},
      {"[solver]\nsummation = 'tree'\n",
       "s.toml:2:13: solver.summation = \"tree\": must be one of auto, direct, fmm"},
      {"[solver]\nnear_singular = 'interpolated'\n",
       "s.toml:2:17: solver.near_singular = \"interpolated\": must be one of auto, cauchy, "
       "interpolation, off"},
      {"[solver]\nnear_singular = true\n",
       "s.toml:2:17: solver.near_singular = true: must be one of auto, cauchy, "
       "interpolation, off, not a boolean"},
      {"[solver]\npreconditioner = 'ilu'\n",
       "s.toml:2:18: solver.preconditioner = \"ilu\": must be one of auto, none, block_diagonal, "
       "clusters, hierarchical, direct"},
      {"[solver]\ncoupling = 'loose'\n",
       "s.toml:2:12: solver.coupling = \"loose\": must be one of global, local"},
      {"[solver]\ngmres_tolerance = 1e-3\n",
       "s.toml:2:1: solver.gmres_tolerance = 0.001: unknown key; valid keys: tolerance, gmres_tol, "
       "gmres_max_iterations, summation, near_singular, preconditioner, coupling"},
      {"[time]\ndt = 0.1\n", "s.toml:1:1: time.t_final is missing: must be a number > 0"},
      {"[time]\nt_final = 1\nmethod = 'euler'\n",
       "s.toml:1:1: time.dt is missing: must be a number > 0"},
      {"[contact]\nminimum_separation = 0.1\n[time]\nt_final = 1\n",
       "s.toml:3:1: time.dt is missing: must be a number > 0"},
      {"[time]\nt_final = 0\ndt = 0.1\n", "s.toml:2:11: time.t_final = 0: must be a number > 0"},
      {"[time]\nt_final = 1\ndt = -0.1\n", "s.toml:3:6: time.dt = -0.1: must be a number > 0"},
      {"[time]\nt_final = 1\ndt = '0.1'\n",
       "s.toml:3:6: time.dt = \"0.1\": must be a number > 0, not a string"},
      {"[time]\nt_final = 1\ndt = 0.1\nmethod = 'leapfrog'\n",
       "s.toml:4:10: time.method = \"leapfrog\": must be one of euler, adams_bashforth2, heun, "
       "rk4, "
       "bogacki_shampine32, dormand_prince54, prince_dormand87"},
      {"[time]\nt_final = 1\nmethod = 'heun'\n",
       "s.toml:1:1: time.dt is missing: must be a number > 0"},
      {"[time]\nt_final = 1\ndt = 0.1\nmethod = 'euler'\ntolerance = 1e-6\n",
       "s.toml:5:1: time.tolerance = 1e-06: requires one of bogacki_shampine32, dormand_prince54, "
       "prince_dormand87, or heun with [contact]; this method has fixed steps"},
      {"[time]\nt_final = 1\ndt = 0.1\nmethod = 'heun'\ntolerance = 1e-4\n",
       "s.toml:5:1: time.tolerance = 1e-04: requires one of bogacki_shampine32, dormand_prince54, "
       "prince_dormand87, or heun with [contact]; this method has fixed steps"},
      {"[contact]\nminimum_separation = 0.1\n[time]\nt_final = 1\ndt = 0.1\nmethod = 'heun'\n"
       "tolerance = 1e-4\neffort = { few = 1, many = 2 }\n",
       "s.toml:8:1: time.effort: cannot be combined with time.tolerance, which adapts steps to "
       "the "
       "error"},
      {"[time]\nt_final = 1\ndt = 0.1\nmethod = 'euler'\ndt_max = 1\n",
       "s.toml:5:1: time.dt_max = 1: requires one of bogacki_shampine32, dormand_prince54, "
       "prince_dormand87, or time.effort"},
      {"[time]\nt_final = 1\nmethod = 'dormand_prince54'\ntolerance = 1e-14\n",
       "s.toml:4:13: time.tolerance = 1e-14: must be a number from 1e-13 to 0.1"},
      {"[time]\nt_final = 1\ntolerance = 1e-8\n[solver]\ntolerance = 1.01e-6\n",
       "s.toml:5:13: solver.tolerance = 1.01e-06: must be at most 100 time.tolerance, which is "
       "1e-08: larger errors of velocities shorten the steps until a run takes a hundred times the "
       "work"},
      {"[time]\nt_final = 1\nmethod = 'dormand_prince54'\ndt = 0\n",
       "s.toml:4:6: time.dt = 0: must be a number > 0"},
      {"[time]\nt_final = 1\ndt = 0.1\ndt_min = 0\n",
       "s.toml:4:10: time.dt_min = 0: must be a number > 0"},
      {"[time]\nt_final = 1\ndt = 0.1\ndt_min = 0.2\n",
       "s.toml:4:10: time.dt_min = 0.2: must be at most time.dt"},
      {"[time]\nt_final = 1\nmethod = 'dormand_prince54'\ndt_min = 0.2\ndt_max = 0.1\n",
       "s.toml:4:10: time.dt_min = 0.2: must be at most time.dt_max"},
      {"[time]\nt_final = 1\nmethod = 'dormand_prince54'\ndt = 0.2\ndt_max = 0.1\n",
       "s.toml:5:10: time.dt_max = 0.1: must be at least time.dt"},
      {"[time]\nt_final = 1e90\ndt = 0.1\n",
       "s.toml:3:6: time.dt = 0.1: must be at least 1e-12 time.t_final, which is 1e+90"},
      {"[time]\nt_final = 2\ndt = 1e-90\n",
       "s.toml:3:6: time.dt = 1e-90: must be at least 1e-12 time.t_final, which is 2"},
      {"[time]\nt_final = 2\ndt = 1.9e-12\n",
       "s.toml:3:6: time.dt = 1.9e-12: must be at least 1e-12 time.t_final, which is 2"},
      {"[time]\nt_final = 2\ndt = 0.1\ndt_min = 1e-90\n",
       "s.toml:4:10: time.dt_min = 1e-90: must be at least 1e-12 time.t_final, which is 2"},
      {"[time]\nt_final = 2\nmethod = 'dormand_prince54'\ndt_max = 1e-90\n",
       "s.toml:4:10: time.dt_max = 1e-90: must be at least 1e-12 time.t_final, which is 2"},
      {"[time]\nt_final = 2\ndt = 0.1\n[output]\ndt_write = 1e-90\n",
       "s.toml:5:12: output.dt_write = 1e-90: must be at least 1e-12 time.t_final, which is 2"},
      {"[time]\nt_final = 1\nmethod = 'rk4'\ndt = 0.1\neffort = 20\n",
       "s.toml:5:10: time.effort = 20: must be a table, not an integer"},
      {"[time]\nt_final = 1\nmethod = 'rk4'\ndt = 0.1\neffort = { few = 20 }\n",
       "s.toml:5:10: time.effort.many is missing: must be an integer >= 1"},
      {"[time]\nt_final = 1\nmethod = 'rk4'\ndt = 0.1\neffort = { few = 20, many = 20 }\n",
       "s.toml:5:29: time.effort.many = 20: must be more than few"},
      {"[time]\nt_final = 1\nmethod = 'rk4'\ndt = 0.1\neffort = { few = 0, many = 20 }\n",
       "s.toml:5:18: time.effort.few = 0: must be an integer >= 1"},
      {"[time]\nt_final = 1\nmethod = 'dormand_prince54'\neffort = { few = 10, many = 20 }\n",
       "s.toml:4:1: time.effort: requires a method with fixed steps, such as \"euler\"; this "
       "method adapts steps to the error"},
      {"[time]\nt_end = 1\n",
       "s.toml:2:1: time.t_end = 1: unknown key; valid keys: t_final, dt, method, tolerance, "
       "dt_min, dt_max, effort"},
      {"[output]\nnodes = 1\n",
       "s.toml:2:9: output.nodes = 1: must be true or false, not an integer"},
      {"[[tracers]]\nspacing = 1\n",
       "s.toml:1:1: tracers[0].points is missing: must be a list of points [[x, y], ...], or give "
       "a "
       "box"},
      {"[[tracers]]\npoints = [[1, 2], [3]]\n",
       "s.toml:2:19: tracers[0].points[1] = [3]: must be two numbers [x, y], not an array of 1"},
      {"[[tracers]]\npoints = [[1, 2]]\nbox = [0, 0, 1, 1]\n",
       "s.toml:2:1: tracers[0].points = [[1, 2]]: give points or a box, not both"},
      {"[[tracers]]\nbox = [0, 0, 1, 1]\nspacing = 1e-4\n",
       "s.toml:3:11: tracers[0].spacing = 1e-04: must be larger: the grid has more than 1000000 "
       "points"},
      {"[output]\ndt_write = 0\n", "s.toml:2:12: output.dt_write = 0: must be a number > 0"},
      {"[output]\nformats = 'csv'\n",
       "s.toml:2:11: output.formats = \"csv\": must be a list of one or more of csv, vtk, svg, "
       "html, not "
       "a string"},
      {"[output]\nformats = []\n",
       "s.toml:2:11: output.formats = []: must be a list of one or more of csv, vtk, svg, html"},
      {"[output]\nformats = ['csv', 'hdf5']\n",
       "s.toml:2:19: output.formats[1] = \"hdf5\": must be one of csv, vtk, svg, html"},
      {"[output]\nformats = ['csv', 1]\n",
       "s.toml:2:19: output.formats[1] = 1: must be one of csv, vtk, svg, html, not an integer"},
      {"[output]\nformats = ['vtk', 'csv', 'vtk']\n",
       "s.toml:2:26: output.formats[2] = \"vtk\": is repeated in the list"},
      {"[output]\nfields = 200\n",
       "s.toml:2:10: output.fields = 200: must be a table, not an integer"},
      {"[output]\nfields = { resolution = 200 }\n",
       "s.toml:2:10: output.fields.box is missing: must be [xmin, ymin, xmax, ymax] with xmin < "
       "xmax and ymin < ymax"},
      {"[output]\nfields = { box = [0, 0, 1, 0] }\n",
       "s.toml:2:18: output.fields.box = [0, 0, 1, 0]: must be [xmin, ymin, xmax, ymax] with xmin "
       "< xmax and ymin < ymax"},
      {"[output]\nfields = { box = [0, 0, 1] }\n",
       "s.toml:2:18: output.fields.box = [0, 0, 1]: must be [xmin, ymin, xmax, ymax] with xmin < "
       "xmax and ymin < ymax, not an array of 3"},
      {"[output]\nfields = { box = [0, 0, 1, inf] }\n",
       "s.toml:2:28: output.fields.box[3] = inf: must be a number, and finite"},
      {"[output]\nfields = { box = [0, 0, 1, 1], resolution = 1 }\n",
       "s.toml:2:45: output.fields.resolution = 1: must be an integer from 2 to 2000: points along "
       "the box's longer side"},
      {"[output]\nfields = { box = [0, 0, 1, 1], resolution = 2001 }\n",
       "s.toml:2:45: output.fields.resolution = 2001: must be an integer from 2 to 2000: points "
       "along the box's longer side"},
      {"[output]\nfields = { box = [0, 0, 1, 1], resolutoin = 9 }\n",
       "s.toml:2:32: output.fields.resolutoin = 9: unknown key, did you mean 'resolution'?"},
      {"[output.fields]\nbox = [0, 0, 1, 1]\nquantities = ['speed']\n",
       "s.toml:3:15: output.fields.quantities[0] = \"speed\": must be one of velocity, pressure, "
       "vorticity, shear_stress, dissipation"},
      {"[output.fields]\nbox = [0, 0, 1, 1]\nquantities = ['pressure', 'pressure']\n",
       "s.toml:3:27: output.fields.quantities[1] = \"pressure\": is repeated in the list"},
      {"[output.fields]\nbox = [0, 0, 1, 1]\nquantities = []\n",
       "s.toml:3:14: output.fields.quantities = []: must be a list of one or more of velocity, "
       "pressure, vorticity, shear_stress, dissipation"},
      {"[output]\nformat = ['csv']\n",
       "s.toml:2:1: output.format = [\"csv\"]: unknown key, did you mean 'formats'?"},
  });
}

BOOST_AUTO_TEST_CASE(ranges_include_their_ends) {
  const std::string solver = disk() + "[solver]\n", time = disk() + "[time]\nt_final = 2\n";
  const std::string adaptive = time + "method = 'dormand_prince54'\n";
  const auto error_with = [](const std::string& start, double value) {
    return error_of(start + number_text(value) + "\n");
  };
  const auto check_end = [&](const std::string& start, double end, double outside,
                             const std::string& expected) {
    BOOST_TEST(error_with(start, end) == "no error");
    BOOST_TEST(error_with(start, std::nextafter(end, outside)).ends_with(": must be " + expected));
  };
  for (const auto& [start, least, range] :
       {std::tuple{solver + "tolerance = ", 1e-14, "a number from 1e-14 to 0.1"},
        std::tuple{adaptive + "tolerance = ", 1e-13, "a number from 1e-13 to 0.1"}}) {
    check_end(start, least, 0.0, range);
    check_end(start, 0.1, 1.0, range);
  }
  check_end(time + "dt = ", 2e-12, 0.0, "at least 1e-12 time.t_final, which is 2");
  // The test `settings` checks that numbers just outside the following ranges are refused.
  BOOST_TEST(error_with(solver + "gmres_tol = ", std::nextafter(1.0, 0.0)) == "no error");
  BOOST_TEST(error_of(time + "dt = 1\nmethod = 'euler'\neffort = { few = 20, many = 21 }\n") ==
             "no error");
  BOOST_TEST(error_of(adaptive + "dt = 0.1\ndt_min = 0.1\ndt_max = 0.1\n") == "no error");
  for (const int points : {2, 2000}) {
    BOOST_TEST(error_of(disk() + "[output.fields]\nbox = [0, 0, 1, 1]\nresolution = " +
                        std::to_string(points) + "\n") == "no error");
  }
}

BOOST_AUTO_TEST_CASE(contact) {
  const std::string right = ": must be a number > 0: a length, or node spacings as in \"0.05h\"";
  const std::string method = ": contact is resolved with \"euler\" and \"heun\"";
  const std::string spacing =
      "s.toml:2:22: contact.minimum_separation = \"0.05h\": requires numbers for all n_nodes, "
      "since h is the node spacing; a body has \"auto\"";
  const std::string start = "[contact]\nminimum_separation = ";
  const std::string any = start + "0.01\n";
  const std::string time = "[time]\nt_final = 1\ndt = 0.1\n";
  const std::string fill =
      "[[fill]]\nshape = { kind = 'circle', radius = 1 }\ncount = 2\nregion = { box = [0, 0, 9, 9] "
      "}\n";
  std::vector<BadScene> scenes{
      {"contact = 0.1\n", "s.toml:1:11: contact = 0.1: must be a table, not a float"},
      {"[contact]\nallow_close = true\n",
       "s.toml:1:1: contact.minimum_separation is missing" + right},
      {any + "allow_close = 1\n",
       "s.toml:3:15: contact.allow_close = 1: must be true or false, not an integer"},
      {"[contact]\nminimum_seperation = 0.01\n",
       "s.toml:2:1: contact.minimum_seperation = 0.01: unknown key, did you mean "
       "'minimum_separation'?"},
      {any + "friction = 0\n",
       "s.toml:3:1: contact.friction = 0: unknown key; valid keys: minimum_separation, "
       "allow_close"},
      {start + "[0.1]\n",
       "s.toml:2:22: contact.minimum_separation = [0.1]" + right + ", not an array of 1"},
      {start + "inf\n", "s.toml:2:22: contact.minimum_separation = inf" + right + ", and finite"},
      {any, "s.toml:1:2: contact: there are no bodies; add [[bodies]] or remove [contact]"},
      {any + tank(),
       "s.toml:1:2: contact: there are no bodies; add [[bodies]] or remove [contact]"},
      {start + "'0.05h'\n" + disk("n_nodes = 'auto'\n"), spacing},
      {start + "'0.05h'\n" + disk() + fill + "n_nodes = 'auto'\n", spacing}};
  for (const std::string number : {"0", "-0.01"}) {
    scenes.push_back(
        {start + number + "\n", "s.toml:2:22: contact.minimum_separation = " + number + right});
  }
  for (const std::string text : {"", "h", "0.05", "0.05 h", " 0.05h", "0.05hh", "0.05H", "0h",
                                 "-1h", "infh", "nanh", "1e999h", "0x1h", "close"}) {
    scenes.push_back({start + '"' + text + "\"\n",
                      "s.toml:2:22: contact.minimum_separation = \"" + text + '"' + right});
  }
  for (const std::string name : {"adams_bashforth2", "rk4"}) {
    scenes.push_back({any + disk() + time + "method = '" + name + "'\n",
                      "s.toml:9:10: time.method = \"" + name + '"' + method});
  }
  scenes.push_back({any + disk() + "[time]\nt_final = 1\nmethod = 'dormand_prince54'\n",
                    "s.toml:8:10: time.method = \"dormand_prince54\"" + method});
  check(scenes);
}

BOOST_AUTO_TEST_SUITE_END()
