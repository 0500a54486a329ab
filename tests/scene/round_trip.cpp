// Tests that parse_scene reads every scene that to_toml has written, bit for bit.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "scene/write.hpp"
#include "scene_text.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

/// Draws random values of the kinds that a scene holds.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}

  bool coin() { return integer(0, 1) == 1; }
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(engine_); }
  /// Returns a number between 2^-40 and 2^40 with 53 random bits.
  double positive() { return std::ldexp(uniform(0.5, 1.0), integer(-39, 40)); }
  double number() { return coin() ? positive() : -positive(); }
  double uniform(double low, double high) {
    return std::uniform_real_distribution(low, high)(engine_);
  }
  Complex vector() { return {number(), number()}; }
  template <class T>
  T one_of(std::vector<T> choices) {
    return choices[static_cast<std::size_t>(integer(0, static_cast<int>(choices.size()) - 1))];
  }

 private:
  std::mt19937 engine_;
};

Shape random_shape(Dice& dice) {
  NodalCurve curve{ComplexVector(dice.integer(8, 20)), "not part of the value"};
  for (Eigen::Index k = 0; k < curve.points.size(); ++k) {
    const double turns = static_cast<double>(k) / static_cast<double>(curve.points.size());
    curve.points[k] = std::polar(dice.uniform(0.5, 2.0), 6.25 * turns);
  }
  return dice.one_of<Shape>({Circle{dice.positive()}, Ellipse{dice.positive(), dice.positive()},
                             Star{dice.positive(), dice.uniform(-1, 1), dice.integer(1, 9)},
                             Superellipse{dice.positive(), dice.positive(), 2 * dice.integer(1, 9)},
                             curve});
}

VelocityData random_data(Dice& dice) {
  VelocityData data;
  for (int k = 0; k < 5; ++k) {
    data.rows.push_back({k + dice.uniform(0.0, 1.0), dice.number(), dice.number()});
  }
  return data;
}

std::optional<Slip> random_slip(Dice& dice) {
  if (dice.coin()) return {};
  return dice.one_of<Slip>({Squirmer{{dice.number(), dice.number()}}, random_data(dice)});
}

int random_nodes(Dice& dice) {
  return dice.coin() ? automatic_nodes : 2 * dice.integer(4, 200);
}

Amplitude random_amplitude(Dice& dice) {
  const double first = dice.positive(), second = 2.0 * first;
  return dice.one_of<Amplitude>(
      {ConstantAmplitude{}, SteppedAmplitude{{0.0, first, second}, {1.0, dice.number(), 0.0}},
       RampedAmplitude{{first, second}, {dice.number(), dice.number()}},
       OscillatingAmplitude{dice.number(), dice.number(), dice.positive(), dice.number()}});
}

Wall random_wall(Dice& dice, WallRole role) {
  Wall wall{role, random_shape(dice), dice.vector(), dice.number(), random_nodes(dice), {}};
  const Eigen::Matrix2d gradient{{dice.number(), dice.number()}, {dice.number(), dice.number()}};
  wall.motion = dice.one_of<WallMotion>({FixedWall{}, RotatingWall{dice.number()},
                                         TranslatingWall{dice.vector()}, LinearWall{gradient},
                                         random_data(dice)});
  if (dice.coin()) {
    wall.shape = Circle{dice.positive()};
    wall.motion = RadialWall{dice.number()};
  } else if (dice.coin()) {
    wall.shape = Superellipse{dice.positive(), dice.positive(), 8};
    wall.motion = ParabolicWall{dice.number()};
  }
  if (!std::holds_alternative<FixedWall>(wall.motion)) wall.amplitude = random_amplitude(dice);
  return wall;
}

Body random_body(Dice& dice) {
  Body body{.shape = random_shape(dice),
            .position = dice.vector(),
            .orientation = dice.number(),
            .held = dice.coin(),
            .n_nodes = random_nodes(dice)};
  (body.held ? body.velocity : body.force) = dice.vector();
  (body.held ? body.omega : body.torque) = dice.number();
  if (dice.coin()) body.loads.amplitude = random_amplitude(dice);
  if (!body.held && dice.coin()) body.loads.trap = Trap{dice.positive(), {}};
  if (body.loads.trap && dice.coin()) body.loads.trap->centre = dice.vector();
  if (!body.held) body.slip = random_slip(dice);
  return body;
}

Fill random_fill(Dice& dice, bool enclosed) {
  Fill fill{{.shape = random_shape(dice), .n_nodes = random_nodes(dice)}};
  if (dice.coin()) fill.area_fraction = dice.uniform(0.01, 0.99);
  if (!fill.area_fraction) fill.count = dice.integer(1, 1000);
  if (!enclosed || dice.coin()) {
    fill.box = {-dice.positive(), -dice.positive(), dice.positive(), dice.positive()};
  }
  fill.clearance = dice.coin() ? dice.positive() : 0.0;
  if (dice.coin()) fill.body.force = dice.vector();
  if (dice.coin()) fill.body.torque = dice.number();
  if (dice.coin()) fill.body.loads.trap = Trap{dice.positive(), dice.vector()};
  fill.body.slip = random_slip(dice);
  return fill;
}

void add_flow(Scene& scene, Dice& dice) {
  const double stretch = dice.number();
  const Eigen::Matrix2d gradient{{stretch, dice.number()}, {dice.number(), -stretch}};
  scene.flow = dice.one_of<BackgroundFlow>(
      {QuiescentFlow{}, UniformFlow{dice.vector()}, ShearFlow{dice.number()},
       ExtensionalFlow{dice.number(), dice.vector()}, TaylorGreenFlow{dice.number()},
       LinearFlow{gradient, dice.vector()},
       SumFlow{{UniformFlow{dice.vector()}, ShearFlow{dice.number(), dice.vector()},
                SumFlow{{LinearFlow{gradient}}}}}});
  if (dice.coin()) scene.gauge_length = dice.positive();
  if (!std::holds_alternative<QuiescentFlow>(scene.flow)) {
    scene.flow_amplitude = random_amplitude(dice);
  }
}

/// Adds sections of loads, and the properties of bodies that they require.
void add_loads(SceneFile& file, Dice& dice) {
  Scene& scene = file.scene;
  if (dice.coin()) scene.gravity = Gravity{dice.vector(), dice.positive(), random_amplitude(dice)};
  if (dice.coin()) {
    scene.magnetic_field = MagneticField{dice.vector(), dice.number(), random_amplitude(dice)};
  }
  if (dice.coin()) scene.repulsion = Repulsion{dice.positive(), dice.positive()};
  const auto add = [&](LoadLaws& loads) {
    if (scene.gravity) loads.density = dice.positive();
    if (scene.magnetic_field && dice.coin()) loads.magnetic_moment = dice.vector();
  };
  for (Body& body : scene.bodies) {
    if (!body.held) add(body.loads);
  }
  for (Fill& fill : file.fills) add(fill.body.loads);
}

TimeSettings fixed_steps(Dice& dice) {
  using enum SteppingMethod;
  TimeSettings time{dice.positive(), dice.positive(),
                    dice.one_of<SteppingMethod>({euler, adams_bashforth2, heun, rk4})};
  if (dice.coin()) time.dt_min = *time.dt * dice.uniform(1e-9, 1.0);
  if (dice.coin()) {
    const int few = dice.integer(1, 100);
    time.effort = EffortBounds{few, few + dice.integer(1, 100)};
    if (dice.coin()) time.dt_max = *time.dt * dice.uniform(1.0, 9.0);
  }
  return time;
}

TimeSettings adapted_steps(Dice& dice) {
  using enum SteppingMethod;
  TimeSettings time{
      dice.positive(),
      {},
      dice.one_of<SteppingMethod>({bogacki_shampine32, dormand_prince54, prince_dormand87})};
  time.tolerance = dice.uniform(1e-13, 0.1);
  const double dt = dice.positive();
  if (dice.coin()) time.dt = dt;
  if (dice.coin()) time.dt_min = dt * dice.uniform(1e-9, 1.0);
  if (dice.coin()) time.dt_max = dt * dice.uniform(1.0, 9.0);
  return time;
}

/// Adds contact, and changes the settings that contact restricts.
void add_contact(SceneFile& file, Dice& dice) {
  auto& [scene, fills] = file;
  using enum SteppingMethod;
  scene.contact = ContactSettings{dice.positive(), dice.coin(), dice.coin()};
  if (scene.time) {
    scene.time = fixed_steps(dice);
    scene.time->method = dice.one_of<SteppingMethod>({euler, heun});
    if (scene.time->method == heun && !scene.time->effort && dice.coin()) {
      scene.time->tolerance = dice.uniform(1e-13, 0.1);
    }
  }
  if (!scene.contact->in_spacings) return;
  for (Body& body : scene.bodies) body.n_nodes = 2 * dice.integer(4, 200);
  for (Fill& fill : fills) fill.body.n_nodes = 2 * dice.integer(4, 200);
}

/// Chooses an end of the run for which the numbers of steps and frames are allowed.
void let_end(TimeSettings& time, std::optional<double> dt_write) {
  for (const std::optional<double> length : {time.dt, time.dt_min, time.dt_max, dt_write}) {
    if (length) time.t_final = std::min(time.t_final, 5e11 * *length);
  }
}

void add_settings(SceneFile& file, Dice& dice) {
  using enum OutputFormat;
  Scene& scene = file.scene;
  scene.solver.tolerance = dice.uniform(1e-14, 0.1);
  if (dice.coin()) scene.solver.gmres_tol = dice.uniform(1e-16, 0.9);
  scene.solver.gmres_max_iterations = dice.integer(1, 1000);
  scene.solver.summation =
      dice.one_of<Summation>({Summation::automatic, Summation::direct, Summation::fmm});
  scene.solver.near_singular =
      dice.one_of<NearSingular>({NearSingular::automatic, NearSingular::cauchy, NearSingular::off});
  scene.solver.preconditioner = dice.one_of<PreconditionerKind>(
      {PreconditionerKind::automatic, PreconditionerKind::none, PreconditionerKind::block_diagonal,
       PreconditionerKind::clusters});
  scene.solver.coupling = dice.one_of<Coupling>({Coupling::global, Coupling::local});
  if (dice.coin()) scene.time = dice.coin() ? fixed_steps(dice) : adapted_steps(dice);
  if (dice.coin()) add_contact(file, dice);
  if (dice.coin()) scene.output.dt_write = dice.positive();
  scene.output.nodes = dice.coin();
  for (int k = dice.integer(0, 3); k > 0; --k) scene.tracers.push_back(dice.vector());
  if (scene.time) let_end(*scene.time, scene.output.dt_write);
  scene.output.formats = dice.one_of<std::vector<OutputFormat>>({{csv}, {vtk, csv}, {svg, html}});
  if (dice.coin()) {
    using enum FieldQuantity;
    scene.output.fields = {
        {-dice.positive(), -dice.positive(), dice.positive(), dice.positive()},
        dice.integer(2, 2000),
        dice.one_of<std::vector<FieldQuantity>>(
            {{velocity}, {dissipation, vorticity}, {pressure, shear_stress, velocity}})};
  }
}

SceneFile random_file(Dice& dice) {
  SceneFile file;
  auto& [scene, fills] = file;
  scene.title = dice.one_of<std::string>({"", "plain", "\"quoted\\\" \u00e9 \t\n\x01\x7f # no"});
  scene.seed = static_cast<std::uint64_t>(dice.integer(0, 1 << 30));
  scene.viscosity = dice.positive();
  const bool enclosed = dice.coin();
  if (enclosed) scene.walls.push_back(random_wall(dice, WallRole::outer));
  if (!enclosed) add_flow(scene, dice);
  if (dice.coin()) scene.walls.push_back(random_wall(dice, WallRole::inner));
  if (dice.coin()) scene.reverse_at = {0.1, 0.1 + dice.positive()};
  for (int k = dice.integer(1, 4); k > 0; --k) scene.bodies.push_back(random_body(dice));
  for (int k = dice.integer(0, 2); k > 0; --k) fills.push_back(random_fill(dice, enclosed));
  if (dice.coin()) add_loads(file, dice);
  add_settings(file, dice);
  return file;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(round_trip)

BOOST_AUTO_TEST_CASE(random_scenes_come_back) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    Dice dice(seed);
    const SceneFile file = random_file(dice);
    const std::string text = to_toml(file);
    BOOST_TEST_CONTEXT("seed " << seed << "\n" << text) {
      BOOST_TEST((parse_file(text) == file));
      BOOST_TEST(to_toml(parse_file(text)) == text);
    }
  }
}

BOOST_AUTO_TEST_CASE(different_scenes_differ) {
  Dice dice(1);
  BOOST_TEST((random_file(dice) != random_file(dice)));
}

BOOST_AUTO_TEST_CASE(every_number_comes_back) {
  using limits = std::numeric_limits<double>;
  for (const double number : {0.1, 1.0 / 3.0, 1.0, -7.0, 1e15, 1e22, 123456789012345680000.0,
                              -1e-100, 1e100, limits::epsilon(), 9007199254740993.0}) {
    Scene scene = parse(disk());
    scene.bodies[0].torque = number;
    BOOST_TEST(parse(to_toml({scene})).bodies[0].torque == number);
  }
}

BOOST_AUTO_TEST_CASE(contact_is_written_as_it_was_given) {
  const auto section_of = [](const std::string& separation) {
    const std::string text =
        to_toml(parse_file("[contact]\nminimum_separation = " + separation + "\n" + disk()));
    const std::size_t start = text.find("[contact]");
    return text.substr(start, text.find("\n\n", start) - start);
  };
  BOOST_TEST(section_of("0.01") == "[contact]\nminimum_separation = 0.01\nallow_close = false");
  BOOST_TEST(section_of("'0.050h'") ==
             "[contact]\nminimum_separation = \"0.05h\"\nallow_close = false");
}

BOOST_AUTO_TEST_CASE(numbers_are_short_and_floats) {
  using scene_text::toml_value;
  BOOST_TEST(toml_value(0.1) == "0.1");
  BOOST_TEST(toml_value(3.0) == "3.0");
  BOOST_TEST(toml_value(1e-8) == "1e-08");
  BOOST_TEST(toml_value(123456789012345680000.0) == "123456789012345683968.0");
  BOOST_TEST(toml_value(1.0 / 3.0) == "0.3333333333333333");
}

BOOST_AUTO_TEST_CASE(cells) {
  Dice dice(7);
  for (int run = 0; run < 20; ++run) {
    SceneFile file = parse_file("[cell]\nvectors = [[2, 0], [1, 3]]\n" + disk());
    Scene& scene = file.scene;
    const double length = dice.positive();
    scene.cell->vectors << length, 0.0, length * dice.uniform(-3, 3), length * dice.uniform(0.1, 3);
    (dice.coin() ? scene.cell->mean_velocity : scene.cell->pressure_gradient.emplace()) =
        dice.vector();
    scene.bodies[0].held = scene.cell->pressure_gradient.has_value();
    BOOST_TEST((parse_file(to_toml(file)) == file));
  }
}

BOOST_AUTO_TEST_CASE(the_text_is_as_one_would_write_it) {
  const SceneFile file =
      parse_file("title = 'one disk'\nseed = 3\n[flow]\nkind = 'shear'\nrate = 1\n" + disk());
  BOOST_TEST(to_toml(file) == R"(title = "one disk"
seed = 3

[fluid]
viscosity = 1.0

[flow]
kind = "shear"
rate = 1.0

[[bodies]]
shape = { kind = "circle", radius = 0.5 }
position = [0.0, 0.0]
orientation = 0.0
force = [0.0, 0.0]
torque = 0.0
n_nodes = 32

[solver]
tolerance = 1e-08
gmres_max_iterations = 500
summation = "auto"
near_singular = "auto"
preconditioner = "auto"
coupling = "global"

[output]
formats = ["csv"]
)");
}

BOOST_AUTO_TEST_SUITE_END()
