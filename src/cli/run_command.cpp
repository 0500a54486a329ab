// Runs or solves one scene: reads the scene, prints the plan, computes the motion, and writes the
// files of the run.
#include "cli/run_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include <omp.h>
#include <sys/resource.h>

#include "cli/build_info.hpp"
#include "cli/message.hpp"
#include "cli/progress.hpp"
#include "record/atomic_file.hpp"
#include "record/record_error.hpp"
#include "record/run_directory.hpp"
#include "scene/parse.hpp"
#include "scene/write.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/motion/describe.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

Scene load_scene(const RunOptions& options) {
  const SceneFile file = read_scene(options.scene, options.overrides);
  if (!options.once && !file.scene.time) {
    throw SceneError(
        options.scene.string() +
        ": stokes run requires [time] with t_final; use stokes solve for a scene without [time]");
  }
  try {
    return place_fills(file);
  } catch (const std::invalid_argument& error) {
    throw SceneError(options.scene.string() + ": " + error.what());
  }
}

/// Interpolates a curve at a multiple of its nodes, at 64 points or more, so that it looks smooth.
ComplexVector smooth_outline(const ComplexVector& nodes) {
  constexpr Eigen::Index least = 64;
  return resample(nodes, nodes.size() * ((least + nodes.size() - 1) / nodes.size()));
}

std::string fingerprint_of_program() {
  const BuildInfo build = build_info();
  std::string text;
  for (const std::string_view part : {build.version, build.git_hash, build.compiler, build.flags}) {
    text += std::string(part) + '\n';
  }
  return fingerprint(text);
}

RunContents contents_of(const Scene& scene, const SuspensionSolver& solver) {
  const auto asks_for = [&](OutputFormat format) {
    const auto& formats = scene.output.formats;
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  };
  RunContents contents{scene.title,
                       to_toml({scene}),
                       {},
                       asks_for(OutputFormat::csv),
                       asks_for(OutputFormat::vtk),
                       asks_for(OutputFormat::svg),
                       asks_for(OutputFormat::html),
                       scene.output.fields.has_value(),
                       scene.contact.has_value(),
                       fingerprint_of_program()};
  for (std::size_t k = 0; k < solver.discretisation().size(); ++k) {
    const Curve& curve = solver.discretisation()[k]->curve;
    auto& [bodies, walls] = contents.outlines;
    (k < scene.bodies.size() ? bodies : walls)
        .push_back({smooth_outline(curve.x), curve.side == Side::fluid_inside});
  }
  return contents;
}

RunInfo run_info(const std::vector<std::string>& plan) {
  const BuildInfo build = build_info();
  RunInfo info;
  info.version = build.version;
  info.git_hash = build.git_hash;
  info.compiler = build.compiler;
  info.flags = build.flags;
  info.machine = machine_name();
  info.threads = omp_get_max_threads();
  info.plan = plan;
  return info;
}

struct OpenedRun {
  RunDirectory directory;
  std::optional<Checkpoint> checkpoint;  // state from which a resumed run continues
};

// Opens the folder of a run. A run killed before its first checkpoint is resumed from the start.
OpenedRun open_directory(const std::filesystem::path& out, const RunContents& contents,
                         const RunOptions& options) {
  const bool has_checkpoint = std::filesystem::exists(out / "checkpoint");
  if (options.resume && has_checkpoint) {
    ResumedRun resumed = RunDirectory::resume(out, contents);
    if (!resumed.by_this_program) {
      std::fprintf(
          stderr,
          "stokes: %s was written by another build of this program: the numbers of one run "
          "may differ in their last digits\n",
          (out / "checkpoint").c_str());
    }
    return {std::move(resumed.directory), std::move(resumed.checkpoint)};
  }
  std::error_code ignored;
  if (!has_checkpoint && std::filesystem::equivalent(options.scene, out / "scene.toml", ignored) &&
      read_text(options.scene) != contents.scene) {
    throw RecordError(
        out / "scene.toml",
        "is the scene itself, which the resolved scene would replace; give another --out");
  }
  const ExistingRun existing = options.overwrite ? ExistingRun::overwrite
                               : options.resume  ? ExistingRun::restart
                                                 : ExistingRun::refuse;
  return {RunDirectory::create(out, contents, existing), {}};
}

void go_on_from(const Checkpoint& checkpoint, Simulation& simulation,
                const std::filesystem::path& out) {
  try {
    simulation.resume(checkpoint);
  } catch (const std::out_of_range&) {
    throw RecordError(out / "checkpoint", "lacks data that this version requires to resume");
  }
}

// Returns the largest resident set so far, in bytes; getrusage() returns multiples of 1024 bytes.
long long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024LL * usage.ru_maxrss;
}

void print_report(const RunInfo& info, const std::filesystem::path& out) {
  const RunTotals& totals = info.totals;
  std::printf(
      "%lld steps, %lld more rejected, %lld solves, %lld GMRES iterations, %.1f s, %lld MB; "
      "results in %s\n",
      totals.steps, totals.rejected_steps, totals.solves, totals.gmres_iterations,
      info.wall_seconds, info.peak_memory / 1'000'000, out.c_str());
  std::printf("error estimates: of velocities, relative to their scale, %s",
              short_number(info.resolution.velocity_error).c_str());
  if (totals.steps > 0) {
    std::printf("; of positions in radii and angles, by all steps together, %s",
                short_number(info.resolution.configuration_error).c_str());
  }
  std::printf("\n");
  const char* before = "error estimates of fields, relative to their largest values: ";
  for (const auto& [quantity, error] : info.resolution.field_errors) {
    std::printf("%s%s %s", before, quantity.c_str(), short_number(error).c_str());
    before = ", ";
  }
  if (!info.resolution.field_errors.empty()) std::printf("\n");
  if (const auto& uniform = info.uniform_velocity) {
    std::printf(
        "the fluid at infinity has the velocity (%s, %s) beside [flow], for zero net force: "
        "flow.gauge_length would prescribe it\n",
        short_number(uniform->real()).c_str(), short_number(uniform->imag()).c_str());
  }
  if (!info.has_contact) return;
  std::printf(
      "contact: %lld solves of %lld iterations in %.1f s, %lld steps halved; imbalance of forces "
      "at most %s, of torques %s; energy injected %s\n",
      totals.contact_solves, totals.ncp_iterations, totals.contact_seconds,
      totals.halved_by_contact, short_number(totals.largest_force_imbalance).c_str(),
      short_number(totals.largest_torque_imbalance).c_str(),
      short_number(totals.energy_injected).c_str());
}

// Warns of error estimates above the tolerance: of fields, and of velocities with contact forces or
// lagged coupling. In all other cases, such an estimate of velocities stops the run.
void warn_of_estimate(const RunInfo& info, double tolerance) {
  for (const auto& [quantity, error] : info.resolution.field_errors) {
    if (error <= tolerance) continue;
    std::fprintf(stderr,
                 "stokes: the error estimate of the field %s is up to %s, above solver.tolerance = "
                 "%s: n_nodes is too small, or automatic nodes have reached their limit\n",
                 quantity.c_str(), short_number(error).c_str(), short_number(tolerance).c_str());
  }
  if (info.resolution.velocity_error <= tolerance) return;
  if (std::isinf(info.resolution.velocity_error)) {
    std::fprintf(stderr,
                 "stokes: the error of velocities could not be estimated in steps whose "
                 "velocity_error in steps.csv is inf\n");
    return;
  }
  std::fprintf(stderr,
               "stokes: the error estimate of velocities is up to %s, above solver.tolerance = %s; "
               "steps.csv has it for each step\n",
               short_number(info.resolution.velocity_error).c_str(),
               short_number(tolerance).c_str());
}

void print_motions(const Frame& frame) {
  std::printf("%6s %24s %24s %24s\n", "body", "ux", "uy", "omega");
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    std::printf("%6zu %24.15g %24.15g %24.15g\n", k, body.velocity.real() + 0.0,
                body.velocity.imag() + 0.0, body.omega + 0.0);  // -0 becomes 0
  }
}

}  // namespace

int run_scene(const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.threads > 0) omp_set_num_threads(options.threads);
  const Scene scene = load_scene(options);
  const SuspensionSolver solver(scene);
  const std::vector<std::string> plan = describe(solver);
  if (!options.quiet) {
    if (!scene.title.empty()) std::printf("%s\n", for_terminal(scene.title).c_str());
    for (const std::string& line : plan) std::printf("  %s\n", line.c_str());
    std::fflush(stdout);
  }
  if (options.dry_run) {
    const Instant instant = solver.start();
    if (scene.contact) SuspensionContact(solver).admit_start(instant.configuration);
    const Solution first = solver.solve(instant);
    std::printf("  %s\n", describe(solver, first).c_str());
    return exit_done;
  }

  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path("out") / options.scene.stem() : options.out;
  const RunContents contents = contents_of(scene, solver);
  OpenedRun opened = open_directory(out, contents, options);
  RunDirectory& directory = opened.directory;
  const std::optional<Checkpoint>& checkpoint = opened.checkpoint;
  directory.write_text("scene.toml", contents.scene);

  Progress progress(checkpoint ? checkpoint->t : 0.0, scene.time ? scene.time->t_final : 0.0,
                    options.quiet || options.once);
  RunInfo info = run_info(plan);
  info.has_contact = scene.contact.has_value();
  Simulation simulation(solver, {[&](const Frame& frame) {
                                   directory.write_frame(frame);
                                   const Complex uniform = frame.rheology.uniform_velocity;
                                   if (!std::isnan(uniform.real())) info.uniform_velocity = uniform;
                                   if (options.once && !options.quiet) print_motions(frame);
                                 },
                                 [&](const StepInfo& step) {
                                   directory.write_step(step);
                                   progress.step(step);
                                 },
                                 [&](const Checkpoint& reached) { directory.save(reached); }});
  if (checkpoint) go_on_from(*checkpoint, simulation, out);

  const auto finish = [&](int status, const std::string& message) {
    progress.finish();
    info.totals = simulation.totals();
    info.resolution = simulation.resolution();
    info.exit_status = status;
    info.message = message;
    info.wall_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    info.peak_memory = peak_memory();
    directory.write_text("run.json", to_json(info));
  };
  info.message = "under way, or killed";
  directory.write_text("run.json", to_json(info));
  try {
    options.once ? simulation.solve_once() : simulation.run();
  } catch (const SolverError& error) {
    finish(exit_refused, error.what());
    throw;
  }
  finish(exit_done, "done");
  if (!options.quiet) print_report(info, out);
  warn_of_estimate(info, scene.solver.tolerance);
  return exit_done;
}

}  // namespace stokesbook
