// Runs or solves one scene: reads the scene, prints the plan, computes the motion, and writes the
// files of the run.
#include "cli/run_command.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <utility>

#include <omp.h>
#include <sys/resource.h>

#include "analysis/settings.hpp"
#include "cli/analysis_command.hpp"
#include "cli/build_info.hpp"
#include "cli/continuation.hpp"
#include "cli/run_report.hpp"
#include "record/atomic_file.hpp"
#include "record/run_directory.hpp"
#include "scene/parse.hpp"
#include "scene/write.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/motion/describe.hpp"
#include "suspension/motion/output_schedule.hpp"
#include "suspension/motion/simulation.hpp"
#include "suspension/motion/statistics.hpp"
#include "suspension/nodes/random_fill.hpp"
#include "suspension/solver/matrices.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

/// Solves the start, with the checks of a run, and prints how well the solution is resolved.
void try_first_solve(const Scene& scene, const SuspensionSolver& solver) {
  const Instant start = solver.start();
  if (scene.contact) {
    SuspensionContact(solver).admit_start({start.configuration, lattice_at(scene, 0.0)});
  }
  std::printf("  %s\n", describe(solver, solver.solve(start)).c_str());
}

/// Interpolates a curve at a multiple of its nodes, at 64 points or more, so that it looks smooth.
ComplexVector smooth_outline(const ComplexVector& nodes) {
  constexpr Eigen::Index least = 64;
  return resample(nodes, nodes.size() * ((least + nodes.size() - 1) / nodes.size()));
}

std::string fingerprint_of_program() {
  const BuildInfo build = build_info();
  const std::array parts{build.version, build.git_hash, build.compiler, build.flags};
  return fingerprint(joined(parts, "\n") + "\n");
}

RunContents contents_of(const Scene& scene, const SuspensionSolver& solver) {
  const auto is_requested = [&](OutputFormat format) {
    return std::ranges::count(scene.output.formats, format) > 0;
  };
  RunContents contents{.title = scene.title,
                       .scene = to_toml({scene}),
                       .outlines = {},
                       .csv = is_requested(OutputFormat::csv),
                       .vtk = is_requested(OutputFormat::vtk),
                       .svg = is_requested(OutputFormat::svg),
                       .html = is_requested(OutputFormat::html),
                       .fields = scene.output.fields.has_value(),
                       .cell = scene.cell.has_value(),
                       .contacts = scene.contact.has_value(),
                       .tracers = !scene.tracers.empty(),
                       .nodes = scene.output.nodes,
                       .program = fingerprint_of_program()};
  for (std::size_t k = 0; k < solver.discretisation().size(); ++k) {
    const Curve& curve = solver.discretisation()[k]->curve;
    auto& [bodies, walls] = contents.outlines;
    (k < scene.bodies.size() ? bodies : walls)
        .push_back({smooth_outline(curve.x), curve.side == Side::fluid_inside});
  }
  return contents;
}

/// Returns the information on a run that begins: its origin and plan.
RunInfo info_of(const Scene& scene, const std::vector<std::string>& plan) {
  const BuildInfo build = build_info();
  RunInfo info;
  info.version = build.version;
  info.git_hash = build.git_hash;
  info.compiler = build.compiler;
  info.flags = build.flags;
  info.machine = machine_name();
  info.threads = omp_get_max_threads();
  info.plan = plan;
  info.has_contact = scene.contact.has_value();
  info.message = "under way, or killed";
  return info;
}

struct OpenedRun {
  RunDirectory directory;
  std::optional<Checkpoint> checkpoint;  // state from which a resumed run continues
  Continuation continuation{};
};

/// Opens the folder of a run. A run killed before its first checkpoint is resumed from the start.
OpenedRun open_directory(const fs::path& out, const Scene& scene, const RunContents& contents,
                         const RunOptions& options) {
  const bool has_checkpoint = fs::exists(out / "checkpoint");
  const bool resumes = options.resume && has_checkpoint;
  Continuation continuation =
      resumes ? find_continuation(out, scene, contents.scene) : Continuation{};
  if (resumes && !continuation.from_start) {
    ResumedRun resumed = RunDirectory::resume(out, contents, continuation.change);
    if (!resumed.by_this_program) {
      std::fprintf(
          stderr,
          "stokes: %s was written by another build of this program: the numbers of one run "
          "may differ in their last digits\n",
          (out / "checkpoint").c_str());
    }
    return {std::move(resumed.directory), std::move(resumed.checkpoint), std::move(continuation)};
  }
  std::error_code ignored;
  if (!has_checkpoint && fs::equivalent(options.scene, out / "scene.toml", ignored) &&
      read_text(options.scene) != contents.scene) {
    throw RecordError(
        out / "scene.toml",
        "is the scene itself, which the resolved scene would replace; give another --out");
  }
  const ExistingRun existing = options.overwrite ? ExistingRun::overwrite
                               : options.resume  ? ExistingRun::restart
                                                 : ExistingRun::refuse;
  return {RunDirectory::create(out, contents, existing), {}, std::move(continuation)};
}

void print_continuation(const OpenedRun& opened) {
  const std::string start = opened.checkpoint
                                ? "goes on at t = " + short_number(opened.checkpoint->t, 6)
                                : "begins again, since all of its steps depended on its end,";
  std::printf("the run %s with %s\n", start.c_str(), opened.continuation.keys.c_str());
}

/// Resumes a run. A run with a changed scene is saved at once: from then on, the folder belongs to
/// this scene.
void resume(Simulation& simulation, OpenedRun& opened, const fs::path& out) {
  auto& [directory, checkpoint, continuation] = opened;
  const bool has_other_settings = continuation.change && !continuation.is_extension;
  try {
    has_other_settings ? simulation.continue_from(*checkpoint) : simulation.resume(*checkpoint);
  } catch (const std::out_of_range&) {
    throw RecordError(out / "checkpoint", "lacks data that this version requires to resume");
  }
  if (!continuation.change) return;
  if (has_other_settings) {
    directory.write_text(earlier_scenes.name(directory.frame_count() - 1),
                         continuation.change->before);
  }
  directory.save(simulation.checkpoint());
  directory.keep_checkpoint();
}

/// Computes and writes the matrices of the free bodies, and prints their errors.
void write_matrices(const Scene& scene, const RunDirectory& directory, bool quiet) {
  const HydrodynamicMatrices matrices = hydrodynamic_matrices(scene);
  directory.write_text("resistance.csv", resistance_table(matrices));
  directory.write_text("mobility.csv", mobility_table(matrices));
  if (!quiet) print_matrix_errors(matrix_errors(matrices));
}

/// Returns the largest resident set so far, in bytes; getrusage() returns multiples of 1024 bytes.
long long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024LL * usage.ru_maxrss;
}

}  // namespace

FilledScene load_scene(const fs::path& path, const std::vector<std::string>& overrides,
                       bool needs_time) {
  const SceneFile file = read_scene(path, overrides);
  if (needs_time && !file.scene.time) {
    throw SceneError(path.string() +
                     ": this command requires [time] with t_final; use stokes "
                     "solve for a scene without [time]");
  }
  try {
    return fill_scene(file);
  } catch (const std::invalid_argument& error) {
    throw SceneError(path.string() + ": " + error.what());
  }
}

int run_scene(const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.threads > 0) omp_set_num_threads(options.threads);
  auto [scene, placement] = load_scene(options.scene, options.overrides, !options.once);
  if (!options.from.empty()) scene = start_from(scene, options.from, options.from_time);
  const std::string tighter = options.verify ? to_toml({tightened(scene)}) : "";
  const SuspensionSolver solver(scene);
  std::vector<std::string> plan = describe(solver);
  plan.insert(plan.end(), placement.begin(), placement.end());
  if (!options.quiet) print_plan(scene.title, plan);
  if (options.dry_run) {
    try_first_solve(scene, solver);
    return exit_done;
  }

  const fs::path out = options.out.empty() ? fs::path("out") / options.scene.stem() : options.out;
  const RunContents contents = contents_of(scene, solver);
  OpenedRun opened = open_directory(out, scene, contents, options);
  RunDirectory& directory = opened.directory;
  const std::optional<Checkpoint>& checkpoint = opened.checkpoint;
  if (opened.continuation.change && !options.quiet) print_continuation(opened);
  RunInfo info = info_of(scene, plan);
  Progress progress(checkpoint ? checkpoint->t : 0.0, scene.time ? scene.time->t_final : 0.0,
                    options.quiet || options.once);
  const auto receive_frame = [&](const Frame& frame) {
    directory.write_frame(frame);
    const Complex uniform = frame.rheology.uniform_velocity;
    if (!std::isnan(uniform.real()) && !frame.cell) info.uniform_velocity = uniform;
    if (!options.once || options.quiet) return;
    print_motions(frame);
    if (frame.cell) print_cell(frame.rheology);
  };
  const auto receive_step = [&](const StepInfo& step) {
    directory.write_step(step);
    progress.step(step);
  };
  const OutputSchedule schedule(scene);
  bool depends_on_end =
      checkpoint && !opened.continuation.change && schedule.depends_on_end(checkpoint->t);
  const auto receive_checkpoint = [&](const Checkpoint& reached) {
    // The last checkpoint that does not depend on the end serves runs that are extended.
    if (!std::exchange(depends_on_end, schedule.depends_on_end(reached.t)) && depends_on_end) {
      directory.keep_checkpoint();
    }
    directory.save(reached);
  };
  const auto receive_warning = [&](const std::string& warning) {
    progress.finish();
    std::fprintf(stderr, "stokes: %s\n", warning.c_str());
  };
  Simulation simulation(solver, {receive_frame, receive_step, receive_checkpoint, receive_warning});
  if (checkpoint) resume(simulation, opened, out);
  directory.write_text("scene.toml", contents.scene);

  const auto finish = [&](int status, const std::string& message) {
    progress.finish();
    info.totals = simulation.totals();
    info.resolution = simulation.resolution();
    info.exit_status = status;
    info.message = message;
    info.wall_seconds = seconds_since(start);
    info.peak_memory = peak_memory();
    directory.write_text("run.json", to_json(info));
  };
  directory.write_text("run.json", to_json(info));
  try {
    options.once ? simulation.solve_once() : simulation.run();
    if (options.matrices) write_matrices(scene, directory, options.quiet);
  } catch (const SolverError& error) {
    finish(exit_refused, error.what());
    throw;
  }
  finish(exit_done, "done");
  if (!options.quiet) print_report(info, out);
  warn_of_estimates(info.resolution, scene.solver.tolerance);
  if (options.verify) {
    const fs::path folder = out / "verify";
    make_folder(folder);
    write_atomically(folder / "scene.toml", tighter, SafeFrom::kill);
    RunOptions second;
    second.scene = folder / "scene.toml";
    second.out = folder;
    second.threads = options.threads;
    second.resume = options.resume;
    second.overwrite = second.quiet = true;
    run_scene(second);
    const std::string report = verification_report(out, options.bound);
    if (!options.quiet) std::printf("%s", report.c_str());
  }
  return exit_done;
}

}  // namespace stokesbook
