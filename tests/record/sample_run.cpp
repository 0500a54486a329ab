// Defines the sample run that the tests of files write: an ellipse, a star, two walls and a field
// by formulas, and the state of a chaotic map.
#include "sample_run.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "record/run_info.hpp"

namespace stokesbook::test {

namespace {

/// Returns the curve r(s) (a cos s, b sin s) with r(s) = 1 + amplitude cos 5s.
Outline outline(int n, double a, double b, double amplitude, bool encloses) {
  Outline result{ComplexVector(n), encloses};
  for (int k = 0; k < n; ++k) {
    const double s = 2.0 * std::numbers::pi * k / n;
    const double r = 1.0 + amplitude * std::cos(5.0 * s);
    result.points[k] = Complex(r * a * std::cos(s), r * b * std::sin(s));
  }
  return result;
}

/// Returns a field on a grid that extends over bodies and walls; every quantity is a formula of the
/// point.
Field sample_field(double t) {
  Field field;
  field.grid = {{-4.0, -2.5}, 1.0 / 3.0, 25, 17};
  const ComplexVector points = field.grid.points();
  field.velocity = points.conjugate() / 3.0 + ComplexVector::Constant(points.size(), {t, 0.0});
  field.pressure = points.real() / 7.0;
  field.vorticity = points.imag() / 11.0;
  field.shear_stress = points.cwiseAbs() / 13.0;
  field.dissipation = points.cwiseAbs2() / 17.0;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    field.in_fluid.push_back(std::abs(points[i]) < 1.0 ? 0 : 1);
    if (field.in_fluid.back() == 1) continue;
    field.velocity[i] = {Rheology::undefined, Rheology::undefined};
    field.pressure[i] = Rheology::undefined;
  }
  return field;
}

/// Returns the start of the map, with a history such as a time stepper has.
Checkpoint start() {
  return {0.0, 0, Eigen::Vector2d(0.1, 0.7), {{"previous_rate", Eigen::Vector2d(0.2, 0.3)}}};
}

void advance(Checkpoint& run) {
  Eigen::VectorXd& previous = run.history["previous_rate"];
  for (Eigen::Index k = 0; k < run.state.size(); ++k) {
    const double rate = 3.9 * run.state[k] * (1.0 - run.state[k]);
    run.state[k] = 0.9 * rate + 0.1 * previous[k];
    previous[k] = rate;
  }
  run.step += 1;
  run.t += 0.1;
}

void write_frame_of(RunDirectory& directory, const Checkpoint& run, bool fields) {
  Frame frame = sample_frame(static_cast<int>(run.step));
  frame.t = run.t;
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    frame.bodies[k].velocity = run.state[static_cast<Eigen::Index>(k)];
  }
  if (!fields) frame.field.reset();
  directory.write_frame(frame);
}

RunDirectory begin(const std::filesystem::path& path, const RunContents& contents) {
  RunDirectory directory = RunDirectory::create(path, contents, ExistingRun::overwrite);
  directory.write_text("scene.toml", contents.scene);
  write_frame_of(directory, start(), contents.fields);
  directory.save(start());
  return directory;
}

}  // namespace

RunContents sample_contents() {
  return {
      .title = "A < B & C",
      .scene = "title = \"sample\"\n",
      .outlines = {.bodies = {outline(32, 1.0, 0.5, 0.0, false), outline(60, 1.0, 1.0, 0.3, false)},
                   .walls = {outline(64, 10.0, 10.0, 0.0, true),
                             outline(16, 0.5, 0.5, 0.0, false)}},
      .csv = true,
      .vtk = true,
      .svg = true,
      .html = true,
      .fields = true,
      .contacts = true,
      .tracers = true};
}

Frame sample_frame(int k) {
  const double t = k / 7.0;
  Frame frame{.t = t,
              .bodies = {},
              .walls = {},
              .rheology = {t / 3.0, Rheology::undefined, -t, {1.0 / 7.0, t}, {-t / 5.0, 1.0 / 3.0}},
              .field = sample_field(t)};
  for (int j = 0; j < 2; ++j) {
    frame.bodies.push_back({.position = {3.0 * j - 1.0 + t / 3.0, 2.0 * j - t / 7.0},
                            .orientation = j + t,
                            .velocity = {1.0 / 3.0, -1.0 / 7.0},
                            .omega = 1.0 + j / 3.0,
                            .force = {j + t / 11.0, -t / 13.0},
                            .torque = j / 17.0});
    frame.walls.push_back({.position = {-5.0 * j, 0.0},
                           .orientation = j / 9.0,
                           .force = {t / 3.0, j + 1.0 / 9.0},
                           .torque = -t});
  }
  frame.tracers = {{1.0 / 3.0 + t, -3.0}, {-7.0, t}};
  // There is no contact, one contact between the bodies, or a further one between a body and the
  // outer wall.
  const ContactParty star{.is_wall = false, .number = 1};
  for (std::size_t j = 0; j < static_cast<std::size_t>(k % 3); ++j) {
    frame.contacts.push_back({.a = star,
                              .b = {.is_wall = j == 1, .number = 0},
                              .point = {1.0 / 3.0 + t, -t},
                              .normal = {0.6, -0.8},
                              .force = static_cast<double>(j) + t / 19.0,
                              .gap = t / 23.0});
  }
  return frame;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool run_or_resume(const std::filesystem::path& directory, const RunContents& contents,
                   int last_step) {
  const bool resumes = std::filesystem::exists(directory / "checkpoint");
  ResumedRun run = resumes ? RunDirectory::resume(directory, contents)
                           : ResumedRun{begin(directory, contents), start()};
  Checkpoint& checkpoint = run.checkpoint;
  while (checkpoint.step < last_step) {
    advance(checkpoint);
    run.directory.write_step({.t = checkpoint.t, .dt = 0.1, .min_gap = checkpoint.state[0]});
    if (checkpoint.step % 2 == 0) write_frame_of(run.directory, checkpoint, contents.fields);
    if (checkpoint.step % 3 == 0) run.directory.save(checkpoint);
  }
  run.directory.save(checkpoint);
  run.directory.write_text("run.json", to_json(RunInfo{}));
  return resumes;
}

}  // namespace stokesbook::test
