// Tests every key of a scene file with a value that is not its default.

#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "scene_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

Shape shape(const std::string& text) {
  return parse(body_with_shape(text)).bodies.at(0).shape;
}

WallMotion motion(const std::string& text) {
  return parse(tank() + "motion = " + text + "\n").walls.at(0).motion;
}

Scene with_flow(const std::string& lines) {
  return parse("[flow]\n" + lines + disk());
}

SolverSettings solver(const std::string& line) {
  return parse(disk() + "[solver]\n" + line + "\n").solver;
}

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
  return Eigen::Matrix2d{{a, b}, {c, d}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(values)

BOOST_AUTO_TEST_CASE(defaults) {
  const Scene scene = parse(disk());
  Scene expected;
  expected.bodies = {Body{.shape = Circle{0.5}, .n_nodes = 32}};
  BOOST_TEST((scene == expected));
  BOOST_TEST(scene.viscosity == 1.0);
  BOOST_TEST(scene.seed == 0u);
  BOOST_TEST(scene.solver.tolerance == 1e-8);
  BOOST_TEST(scene.solver.gmres_max_iterations == 500);
  BOOST_TEST(!scene.time.has_value());
  BOOST_TEST(!scene.contact.has_value());
  BOOST_TEST(!scene.output.dt_write.has_value());
  BOOST_TEST((scene.output.formats == std::vector{OutputFormat::csv}));
}

BOOST_AUTO_TEST_CASE(empty_sections_mean_defaults) {
  BOOST_TEST((parse("[fluid]\n[flow]\n[solver]\n[output]\n" + disk()) == parse(disk())));
}

BOOST_AUTO_TEST_CASE(top_level) {
  const Scene scene =
      parse("title = 'Two disks \u00e9'\nseed = 7\n[fluid]\nviscosity = 2\n" + disk());
  BOOST_TEST(scene.title == "Two disks \u00e9");
  BOOST_TEST(scene.seed == 7u);
  BOOST_TEST(scene.viscosity == 2.0);
  BOOST_TEST(parse("seed = 9223372036854775807\n" + disk()).seed == 9223372036854775807u);
}

BOOST_AUTO_TEST_CASE(flows) {
  BOOST_TEST((with_flow("kind = 'quiescent'\n").flow == BackgroundFlow(QuiescentFlow{})));
  BOOST_TEST((with_flow("kind = 'uniform'\nvelocity = [1, -2.5]\n").flow ==
              BackgroundFlow(UniformFlow{{1.0, -2.5}})));
  BOOST_TEST((with_flow("kind = 'shear'\nrate = 2\n").flow == BackgroundFlow(ShearFlow{2.0})));
  BOOST_TEST((with_flow("kind = 'extensional'\nrate = -2\n").flow ==
              BackgroundFlow(ExtensionalFlow{-2.0})));
  BOOST_TEST((with_flow("kind = 'taylor_green'\nrate = 0.5\n").flow ==
              BackgroundFlow(TaylorGreenFlow{0.5})));
  BOOST_TEST((with_flow("kind = 'linear'\ngradient = [[1, 2], [3, -1]]\n").flow ==
              BackgroundFlow(LinearFlow{matrix(1, 2, 3, -1)})));
  BOOST_TEST((with_flow("kind = 'shear'\nrate = 2\ncentre = [1, 5]\n").flow ==
              BackgroundFlow(ShearFlow{2.0, {1.0, 5.0}})));
  BOOST_TEST((with_flow("kind = 'sum'\ngauge_length = 3\nterms = [{ kind = 'uniform', velocity = "
                        "[1, 2] }, { kind = 'extensional', rate = 3, centre = [4, 5] }]\n")
                  .flow == BackgroundFlow(SumFlow{
                               {UniformFlow{{1.0, 2.0}}, ExtensionalFlow{3.0, {4.0, 5.0}}}})));
  // Rounding errors of the trace are accepted: they are not a source of fluid.
  with_flow("kind = 'linear'\ngradient = [[1e6, 2], [3, -1000000.0000001]]\n");
  with_flow("kind = 'linear'\ngradient = [[0, 0], [0, 0]]\n");
}

BOOST_AUTO_TEST_CASE(what_goes_with_every_flow) {
  const Scene scene =
      with_flow("kind = 'shear'\nrate = 1\ngauge_length = 3\nreverse_at = [20, 20.5]\n");
  BOOST_TEST(scene.gauge_length.value() == 3.0);
  BOOST_TEST((scene.reverse_at == std::vector{20.0, 20.5}));
  BOOST_TEST(with_flow("reverse_at = []\n").reverse_at.empty());
  BOOST_TEST(with_flow("gauge_length = 2.5\n").gauge_length.value() == 2.5);
  BOOST_TEST((parse(tank() + "[flow]\nreverse_at = [5]\n").reverse_at == std::vector{5.0}));
}

BOOST_AUTO_TEST_CASE(shapes) {
  BOOST_TEST((shape("{ kind = 'circle', radius = 2 }") == Shape(Circle{2.0})));
  BOOST_TEST((shape("{ kind = 'ellipse', semi_axes = [2, 0.5] }") == Shape(Ellipse{2.0, 0.5})));
  BOOST_TEST((shape("{ kind = 'star', radius = 2, amplitude = -0.9, arms = 3 }") ==
              Shape(Star{2.0, -0.9, 3})));
  BOOST_TEST((shape("{ kind = 'star', radius = 1, amplitude = 0, arms = 1 }") ==
              Shape(Star{1.0, 0.0, 1})));
  BOOST_TEST((shape("{ kind = 'superellipse', semi_axes = [2, 0.5], power = 6 }") ==
              Shape(Superellipse{2.0, 0.5, 6})));
  BOOST_TEST((shape("{ kind = 'superellipse', semi_axes = [1, 1], power = 2 }") ==
              Shape(Superellipse{1.0, 1.0, 2})));
  NodalCurve octagon{ComplexVector(8), {}};
  octagon.points << Complex{2, 0}, Complex{1, 1}, Complex{0, 1}, Complex{-1, 1}, Complex{-2, 0},
      Complex{-1, -1}, Complex{0, -1}, Complex{1, -1};
  BOOST_TEST((shape("{ kind = 'nodes', points = [[2, 0], [1, 1], [0, 1], [-1, 1], [-2, 0], "
                    "[-1, -1], [0, -1], [1, -1]] }") == Shape(octagon)));
}

BOOST_AUTO_TEST_CASE(walls) {
  const Scene scene = parse(tank() +
                            "[[walls]]\nrole = 'inner'\nshape = { kind = 'ellipse', semi_axes = "
                            "[2, 1] }\nposition = [1, -2]\norientation = 0.5\nn_nodes = 8\n");
  BOOST_REQUIRE(scene.walls.size() == 2);
  const Wall& inner = scene.walls[1];
  BOOST_TEST((scene.walls[0].role == WallRole::outer));
  BOOST_TEST((scene.walls[0].shape == Shape(Circle{9.0})));
  BOOST_TEST(scene.walls[0].position == Complex(0.0, 0.0));
  BOOST_TEST((inner.role == WallRole::inner));
  BOOST_TEST((inner.shape == Shape(Ellipse{2.0, 1.0})));
  BOOST_TEST(inner.position == Complex(1.0, -2.0));
  BOOST_TEST(inner.orientation == 0.5);
  BOOST_TEST(inner.n_nodes == 8);
  BOOST_TEST((inner.motion == WallMotion(FixedWall{})));
}

BOOST_AUTO_TEST_CASE(wall_motions) {
  BOOST_TEST((motion("{ kind = 'fixed' }") == WallMotion(FixedWall{})));
  BOOST_TEST((motion("{ kind = 'rotating', omega = -1 }") == WallMotion(RotatingWall{-1.0})));
  BOOST_TEST((motion("{ kind = 'translating', velocity = [1, 2] }") ==
              WallMotion(TranslatingWall{{1.0, 2.0}})));
  // The solver checks the net flux of all walls: a single wall may have a flux.
  BOOST_TEST((motion("{ kind = 'linear', gradient = [[1, 2], [3, 4]] }") ==
              WallMotion(LinearWall{matrix(1, 2, 3, 4)})));
  BOOST_TEST((motion("{ kind = 'radial', speed = 0.5 }") == WallMotion(RadialWall{0.5})));
  const Scene channel = parse(
      "[[walls]]\nrole = 'outer'\nshape = { kind = 'superellipse', semi_axes = [4, 1], power = 8 }"
      "\nn_nodes = 64\nmotion = { kind = 'parabolic', speed = 2 }\n");
  BOOST_TEST((channel.walls[0].motion == WallMotion(ParabolicWall{2.0})));
  BOOST_TEST((motion("{ kind = 'data', rows = [[0, 1, 2], [1.5, 3, 4], [3, 5, 6], [4, 7, 8]] }") ==
              WallMotion(VelocityData{{{0, 1, 2}, {1.5, 3, 4}, {3, 5, 6}, {4, 7, 8}}})));
}

BOOST_AUTO_TEST_CASE(slips) {
  const std::string squirmer = "slip = { kind = 'squirmer', modes = [1, -2.5] }\n";
  const Slip expected = Squirmer{{1.0, -2.5}};
  BOOST_TEST((parse(disk("n_nodes = 8\n" + squirmer)).bodies[0].slip == expected));
  BOOST_TEST((parse_file(tank() +
                         "[[fill]]\nshape = { kind = 'circle', radius = 0.5 }\ncount = 2\n"
                         "n_nodes = 8\n" +
                         squirmer)
                  .fills[0]
                  .body.slip == expected));
}

BOOST_AUTO_TEST_CASE(bodies) {
  const Scene scene =
      parse(disk("position = [1, 2]\norientation = 3\nforce = [4, 5]\ntorque = 6\nheld = false\n"
                 "n_nodes = 8\n") +
            disk("position = [7, 8]\nheld = true\nvelocity = [9, 10]\nomega = 11\nn_nodes = 10\n") +
            disk("held = true\nn_nodes = 12\n"));
  const std::vector<Body> expected{{.shape = Circle{0.5},
                                    .position = {1, 2},
                                    .orientation = 3,
                                    .force = {4, 5},
                                    .torque = 6,
                                    .n_nodes = 8},
                                   {.shape = Circle{0.5},
                                    .position = {7, 8},
                                    .held = true,
                                    .velocity = {9, 10},
                                    .omega = 11,
                                    .n_nodes = 10},
                                   {.shape = Circle{0.5}, .held = true, .n_nodes = 12}};
  BOOST_TEST((scene.bodies == expected));
}

BOOST_AUTO_TEST_CASE(fills) {
  const std::string start = "[[fill]]\nshape = { kind = 'circle', radius = 0.5 }\nn_nodes = 16\n";
  const std::string box = "region = { box = [-1, -2, 3, 4] }\n";
  const Fill some{
      .body{.shape = Circle{0.5}, .n_nodes = 16}, .count = 5, .box{{-1.0, -2.0, 3.0, 4.0}}};
  Fill dense = some;
  dense.count.reset();
  dense.area_fraction = 0.25;
  dense.clearance = 0.125;
  Fill anywhere = some;
  anywhere.box.reset();
  const auto fills_of = [](const std::string& text) { return parse_file(text).fills; };
  BOOST_TEST((fills_of(start + "count = 5\n" + box) == std::vector{some}));
  BOOST_TEST((fills_of(start + "area_fraction = 0.25\nclearance = 0.125\n" + box + start +
                       "count = 5\n" + box) == std::vector{dense, some}));
  BOOST_TEST((fills_of(tank() + start + "count = 5\n" + box) == std::vector{some}));
  BOOST_TEST((fills_of(tank() + start + "count = 5\n") == std::vector{anywhere}));
  BOOST_TEST((fills_of(tank() + start + "count = 5\nregion = 'fluid'\nclearance = 0\n") ==
              std::vector{anywhere}));
}

BOOST_AUTO_TEST_CASE(fills_of_several_sizes) {
  const auto fills_of = [](const std::string& shape, const std::string& lines) {
    return parse_file(tank() + "[[fill]]\nshape = " + shape + "\nn_nodes = 16\n" + lines).fills;
  };
  const Fill small{{.shape = Ellipse{0.5, 0.25}, .n_nodes = 16}};
  Fill large = small;
  large.body.shape = Ellipse{1.0, 0.5};
  std::vector<Fill> both{small, large};
  const std::string ellipse = "{ kind = 'ellipse', semi_axes = [0.5, 0.25] }";
  // Shares are of the number of bodies: three of four bodies have 3 / (3 + 4) of the area.
  both[0].area_fraction = 0.7 * 3.0 / 7.0;
  both[1].area_fraction = 0.7 * 4.0 / 7.0;
  const auto found = fills_of(ellipse, "area_fraction = 0.7\nsizes = [[1.0, 0.75], [2.0, 0.25]]\n");
  BOOST_REQUIRE(found.size() == 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    BOOST_TEST(std::abs(*found[k].area_fraction - *both[k].area_fraction) < 1e-15);
    both[k].area_fraction = found[k].area_fraction;
  }
  BOOST_TEST((found == both));
  BOOST_TEST((fills_of("{ kind = 'star', radius = 1, amplitude = 0.1, arms = 3 }",
                       "area_fraction = 0.1\nsizes = [[2.0, 5.0]]\n")[0]
                  .body.shape == Shape{Star{2.0, 0.1, 3}}));
}

BOOST_AUTO_TEST_CASE(solver_settings) {
  BOOST_TEST(solver("tolerance = 1e-14").tolerance == 1e-14);
  BOOST_TEST(solver("tolerance = 0.1").tolerance == 0.1);
  BOOST_TEST(solver("gmres_tol = 1e-10").gmres_tol.value() == 1e-10);
  BOOST_TEST(solver("gmres_max_iterations = 1").gmres_max_iterations == 1);
  BOOST_TEST((solver("summation = 'auto'").summation == Summation::automatic));
  BOOST_TEST((solver("summation = 'direct'").summation == Summation::direct));
  BOOST_TEST((solver("summation = 'fmm'").summation == Summation::fmm));
  BOOST_TEST((solver("near_singular = 'auto'").near_singular == NearSingular::automatic));
  BOOST_TEST((solver("near_singular = 'cauchy'").near_singular == NearSingular::cauchy));
  BOOST_TEST(
      (solver("near_singular = 'interpolation'").near_singular == NearSingular::interpolation));
  BOOST_TEST((solver("near_singular = 'off'").near_singular == NearSingular::off));
  using enum PreconditionerKind;
  BOOST_TEST((solver("preconditioner = 'auto'").preconditioner == automatic));
  BOOST_TEST((solver("preconditioner = 'none'").preconditioner == none));
  BOOST_TEST((solver("preconditioner = 'block_diagonal'").preconditioner == block_diagonal));
  BOOST_TEST((solver("preconditioner = 'clusters'").preconditioner == clusters));
  BOOST_TEST((solver("coupling = 'global'") == SolverSettings{}));
  BOOST_TEST((solver("coupling = 'local'").coupling == Coupling::local));
}

BOOST_AUTO_TEST_CASE(time_settings) {
  const auto time = [](const std::string& line) {
    return parse(disk() + "[time]\nt_final = 4\ndt = 0.5\n" + line).time.value();
  };
  using enum SteppingMethod;
  BOOST_TEST((time("") == TimeSettings{4.0, 0.5, dormand_prince54, 1e-6}));
  BOOST_TEST((time("method = 'euler'\n").method == euler));
  BOOST_TEST((time("method = 'adams_bashforth2'\n").method == adams_bashforth2));
  BOOST_TEST((time("method = 'heun'\n").method == heun));
  BOOST_TEST((time("method = 'rk4'\n").method == rk4));
  BOOST_TEST((time("method = 'bogacki_shampine32'\n").method == bogacki_shampine32));
  BOOST_TEST((time("method = 'dormand_prince54'\n").method == dormand_prince54));
  BOOST_TEST((time("method = 'prince_dormand87'\n").method == prince_dormand87));
  BOOST_TEST(
      (time("method = 'euler'\ndt_min = 0.1\neffort = { few = 10, many = 40 }\ndt_max = 2\n") ==
       TimeSettings{4.0, 0.5, euler, {}, 0.1, 2.0, EffortBounds{10, 40}}));
  const auto in_contact = [](const std::string& line) {
    return parse("[contact]\nminimum_separation = 0.1\n[time]\nt_final = 4\ndt = 0.5\n" + line +
                 disk())
        .time.value();
  };
  BOOST_TEST((in_contact("") == TimeSettings{4.0, 0.5, heun, 1e-3}));
  BOOST_TEST((in_contact("tolerance = 1e-4\n") == TimeSettings{4.0, 0.5, heun, 1e-4}));
  BOOST_TEST((in_contact("method = 'heun'\n") == TimeSettings{4.0, 0.5, heun}));
  BOOST_TEST((in_contact("method = 'euler'\n") == TimeSettings{4.0, 0.5, euler}));
  BOOST_TEST((in_contact("effort = { few = 10, many = 40 }\n") ==
              TimeSettings{4.0, 0.5, heun, {}, {}, {}, EffortBounds{10, 40}}));
  const auto adapting = [](const std::string& line) {
    return parse(disk() + "[time]\nt_final = 4\nmethod = 'dormand_prince54'\n" + line).time.value();
  };
  BOOST_TEST((adapting("") == TimeSettings{4.0, {}, dormand_prince54, 1e-6}));
  BOOST_TEST((adapting("tolerance = 1e-9\ndt = 0.1\ndt_min = 1e-3\ndt_max = 1\n") ==
              TimeSettings{4.0, 0.1, dormand_prince54, 1e-9, 1e-3, 1.0}));
}

BOOST_AUTO_TEST_CASE(a_tolerance_that_is_not_given_follows_the_other) {
  const auto tolerances = [](const std::string& solver, const std::string& time) {
    const Scene scene =
        parse(disk() + "[solver]\n" + solver + "\n[time]\nt_final = 4\n" + time + "\n");
    return std::pair(scene.solver.tolerance, scene.time.value().tolerance.value());
  };
  BOOST_TEST((tolerances("tolerance = 1e-4", "") == std::pair(1e-4, 1e-6)));
  BOOST_TEST((tolerances("tolerance = 1e-2", "") == std::pair(1e-2, 1e-4)));
  BOOST_TEST((tolerances("", "tolerance = 1e-9") == std::pair(1e-8, 1e-9)));
  BOOST_TEST((tolerances("", "tolerance = 1e-12") == std::pair(1e-10, 1e-12)));
  BOOST_TEST((tolerances("tolerance = 1e-2", "tolerance = 1e-4") == std::pair(1e-2, 1e-4)));
  // Fixed steps have no tolerance to follow.
  parse(disk() + "[solver]\ntolerance = 0.1\n[time]\nt_final = 4\ndt = 1\nmethod = 'rk4'\n");
}

BOOST_AUTO_TEST_CASE(contact_settings) {
  const auto contact = [](const std::string& lines, const std::string& rest = disk()) {
    return parse("[contact]\n" + lines + "\n" + rest).contact.value();
  };
  BOOST_TEST((contact("minimum_separation = 0.01") == ContactSettings{0.01, false, false}));
  BOOST_TEST((contact("minimum_separation = 2\nallow_close = false") ==
              ContactSettings{2.0, false, false}));
  BOOST_TEST((contact("minimum_separation = '0.05h'\nallow_close = true") ==
              ContactSettings{0.05, true, true}));
  BOOST_TEST((contact("minimum_separation = '2.5e-1h'") == ContactSettings{0.25, true, false}));
  // Automatic nodes of bodies have no spacing, but a separation in lengths requires none. A
  // separation in spacings allows automatic nodes of walls.
  const std::string automatic = disk("n_nodes = 'auto'\n");
  BOOST_TEST(contact("minimum_separation = 0.01", automatic).minimum_separation == 0.01);
  const std::string wall =
      "[[walls]]\nrole = 'outer'\nshape = { kind = 'circle', radius = 9 }\nn_nodes = 'auto'\n";
  BOOST_TEST(contact("minimum_separation = '1h'", disk() + wall).in_spacings);
  const std::string time = "[time]\nt_final = 1\ndt = 0.1\n";
  for (const std::string method : {"", "method = 'euler'\n", "method = 'heun'\n"}) {
    contact("minimum_separation = 0.01", disk() + time + method);
  }
  contact("minimum_separation = 0.01", disk() + "[solver]\ncoupling = 'local'\n");
}

BOOST_AUTO_TEST_CASE(output_settings) {
  const OutputSettings output =
      parse(disk() + "[output]\ndt_write = 0.5\nformats = ['svg', 'html', 'vtk', 'csv']\n").output;
  BOOST_TEST(output.dt_write.value() == 0.5);
  using enum OutputFormat;
  BOOST_TEST((output.formats == std::vector{svg, html, vtk, csv}));
  BOOST_TEST(!output.fields.has_value());
}

BOOST_AUTO_TEST_CASE(field_settings) {
  const auto fields = [](const std::string& table) {
    return parse(disk() + "[output]\nfields = " + table + "\n").output.fields.value();
  };
  using enum FieldQuantity;
  BOOST_TEST((fields("{ box = [-1, -2.5, 3, 4] }") ==
              FieldSettings{{-1.0, -2.5, 3.0, 4.0}, 200, {velocity, pressure}}));
  BOOST_TEST(
      (fields("{ box = [0, 0, 1, 1], resolution = 2, quantities = ['dissipation', "
              "'shear_stress', 'vorticity', 'pressure', 'velocity'] }") ==
       FieldSettings{
           {0.0, 0.0, 1.0, 1.0}, 2, {dissipation, shear_stress, vorticity, pressure, velocity}}));
}

BOOST_AUTO_TEST_CASE(a_scene_may_be_only_walls_or_only_a_fill) {
  BOOST_TEST(parse(tank()).bodies.empty());
  BOOST_TEST(parse("[[fill]]\nshape = { kind = 'circle', radius = 1 }\ncount = 1\nn_nodes = 32\n"
                   "region = { box = [0, 0, 9, 9] }\n")
                 .walls.empty());
}

BOOST_AUTO_TEST_CASE(automatic_nodes_are_a_word) {
  const auto [scene, fills] = parse_file(
      "[[walls]]\nrole = 'outer'\nshape = { kind = 'circle', radius = 9 }\nn_nodes = 'auto'\n" +
      disk("n_nodes = 'auto'\n") +
      "[[fill]]\nshape = { kind = 'circle', radius = 0.5 }\ncount = 2\nn_nodes = 'auto'\n");
  BOOST_TEST(scene.walls.at(0).n_nodes == automatic_nodes);
  BOOST_TEST(scene.bodies.at(0).n_nodes == automatic_nodes);
  BOOST_TEST(fills.at(0).body.n_nodes == automatic_nodes);
}

BOOST_AUTO_TEST_CASE(tracers) {
  BOOST_TEST(parse(disk()).tracers.empty());
  const Scene scene = parse(
      "[[tracers]]\npoints = [[1, 2], [-3, 0.5]]\n[[tracers]]\nbox = [0, 1, 1, 1.6]\nspacing = "
      "0.5\n" +
      disk() + "[output]\nnodes = true\n");
  const std::vector<Complex> expected{{1, 2}, {-3, 0.5}, {0, 1},     {0.5, 1},
                                      {1, 1}, {0, 1.5},  {0.5, 1.5}, {1, 1.5}};
  BOOST_TEST((scene.tracers == expected));
  BOOST_TEST(scene.output.nodes);
}

BOOST_AUTO_TEST_SUITE_END()
