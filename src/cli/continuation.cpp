// Compares a scene with that of a run, and decides from which checkpoint the run goes on. Reads a
// state of a run as the start of another scene: bodies from the table of the trajectory, walls,
// which this table lacks, from the checkpoint.
#include "cli/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "analysis/run.hpp"
#include "scene/parse.hpp"
#include "suspension/bodies/cell.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/motion/output_schedule.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

constexpr const char* changeable =
    "title, [time], [solver], [contact], output.dt_write, more output.formats and new "
    "output.fields may change; --from begins another run at the last state of this one";

/// A key that differs, and its values, which are empty where a scene lacks the key.
struct Change {
  std::string key, before, now;

  std::string description() const {
    const auto text = [](const std::string& value) { return value.empty() ? "none" : value; };
    return key + " = " + text(now) + " (so far " + text(before) + ")";
  }
};

/// Lists the values in a text of to_toml(), in which each line is a value or begins a section, by
/// their paths, such as "bodies[0].position".
std::map<std::string, std::string> values_in(std::string_view scene) {
  std::map<std::string, std::string> values;
  std::map<std::string, int> counts;  // of sections
  std::string section;
  for (const std::string_view line : split(scene, '\n')) {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("[[")) {
      const std::string name(line.substr(2, line.size() - 4));
      section = name + "[" + std::to_string(counts[name]++) + "].";
    } else if (line.starts_with("[")) {
      section = std::string(line.substr(1, line.size() - 2)) + ".";
    } else if (equals != std::string_view::npos) {
      values[section + std::string(line.substr(0, equals))] = line.substr(equals + 3);
    }
  }
  return values;
}

std::vector<Change> find_changes(std::string_view before, std::string_view now) {
  std::map<std::string, Change> changes;
  for (const auto& [key, value] : values_in(before)) changes[key] = {key, value, {}};
  for (const auto& [key, value] : values_in(now)) changes[key] = {key, changes[key].before, value};
  std::vector<Change> found;
  for (const auto& [key, change] : changes) {
    if (change.before != change.now) found.push_back(change);
  }
  return found;
}

/// Returns why a key must not differ; empty if it may.
const char* refusal(const Change& change, const Scene& before, const Scene& now) {
  const std::string section = change.key.substr(0, change.key.find('.'));
  if (section == "contact") {
    return before.contact && now.contact ? "" : "contact cannot begin or end within a run";
  }
  if (change.key == "output.formats") {
    const auto is_kept = [&](OutputFormat f) { return std::ranges::count(now.output.formats, f); };
    return std::ranges::all_of(before.output.formats, is_kept) ? "" : "a run keeps its formats";
  }
  if (change.key == "output.fields") {
    return before.output.fields ? "all fields of a run have the same grid and quantities" : "";
  }
  const bool may_differ = section == "title" || section == "solver" || section == "time" ||
                          change.key == "output.dt_write";
  return may_differ ? "" : "the motion so far depends on this key";
}

[[noreturn]] void fail(const fs::path& run, const std::string& problem) {
  throw SceneError("--from " + run.string() + ": " + problem);
}

/// Refuses bodies or walls that are not those of the run.
void require_same(const fs::path& run, const std::string& kind, const auto& given,
                  const auto& expected) {
  const auto is_same = [](const auto& a, const auto& b) { return a.shape == b.shape; };
  if (std::ranges::equal(given, expected, is_same)) return;
  fail(run, "has " + std::to_string(expected.size()) + " " + kind + ", and the scene " +
                std::to_string(given.size()) + ": number, order and shapes must be the same");
}

/// Returns the index of a written time of a run, by default of the last one.
std::size_t frame_at(const Run& run, std::optional<double> time) {
  const std::vector<double>& times = run.times();
  const double asked = time.value_or(times.back());
  const auto distance = [=](double t) { return std::abs(t - asked); };
  const auto nearest = std::ranges::min_element(times, {}, distance);
  if (distance(*nearest) > 1e-9 * std::abs(asked)) {  // beyond the rounding of a given time
    fail(run.path, "has not written t = " + number_text(asked) + "; the nearest written time is " +
                       number_text(*nearest));
  }
  return static_cast<std::size_t>(nearest - times.begin());
}

/// Returns the cell of a scene with the lattice of a run at a time. Refuses a cell that cannot be
/// that of the run: the flow carries the lattice along, and keeps its area.
std::optional<CellSettings> cell_from(const Run& run, const Scene& scene, double t) {
  const std::optional<PeriodicCell> given = cell_at(scene, 0.0), reached = cell_at(run.scene, t);
  const double area = given ? lattice_of(*given).area() : 0.0;
  const double expected = reached ? lattice_of(*reached).area() : 0.0;
  constexpr double rounding = 1e-9;
  if (std::abs(area - expected) > rounding * expected) {
    fail(run.path, "has a [cell] of the area " + number_text(expected) + ", and the scene one of " +
                       number_text(area) +
                       ", where 0 means none: give the cell.vectors of the run");
  }
  if (!reached) return {};
  const Lattice lattice = lattice_of(*reached);
  const Complex b1 = lattice.shortest(), b2 = lattice.second();
  CellSettings cell = *scene.cell;
  cell.vectors << b1.real(), b1.imag(), b2.real(), b2.imag();
  return cell;
}

/// Returns whether a wall looks as at the start of its run.
bool is_unmoved(const Wall& wall, const Pose& now) {
  return now.position == wall.position &&
         (now.orientation == wall.orientation || std::holds_alternative<Circle>(wall.shape));
}

}  // namespace

Continuation find_continuation(const fs::path& out, const Scene& scene, const std::string& text) {
  const SavedRun saved = read_saved_run(out / "checkpoint");
  if (saved.scene == fingerprint(text)) return {};
  const fs::path file = out / "scene.toml";
  const std::string text_before = read_text(file);
  if (saved.scene != fingerprint(text_before)) {
    throw RecordError(file,
                      "is not the scene of the checkpoint, so that changes cannot be found: "
                      "restore this file, and change keys by --set or in another file");
  }
  const Scene before = parse_scene(text_before, file.string(), out).scene;
  const std::vector<Change> changes = find_changes(text_before, text);
  std::vector<std::string> problems;
  for (const Change& change : changes) {
    const std::string reason = refusal(change, before, scene);
    if (!reason.empty()) problems.push_back(change.description() + ": " + reason);
  }
  if (!problems.empty()) {
    throw SceneError(out.string() + ": the run cannot go on with " + joined(problems, "; ") + ". " +
                     changeable);
  }
  const double t = saved.checkpoint.t;
  if (scene.time->t_final <= t) {
    throw SceneError(out.string() + ": time.t_final = " + number_text(scene.time->t_final) +
                     ": must be later than t = " + number_text(t) + ", which the run has reached");
  }
  const bool is_extension = changes.size() == 1 && changes[0].key == "time.t_final" &&
                            scene.time->t_final > before.time->t_final;
  const OutputSchedule schedule(before);
  const bool goes_back = is_extension && schedule.depends_on_end(t);
  const bool from_start =
      goes_back && schedule.depends_on_end(0.0) && !fs::exists(out / kept_checkpoint);
  return {.change = ChangedScene{text_before, goes_back && !from_start},
          .is_extension = is_extension,
          .from_start = from_start,
          .keys = joined(changes, ", ", &Change::description)};
}

Scene start_from(Scene scene, const fs::path& path, std::optional<double> time) {
  const Run run = read_run(path);
  const std::size_t bodies = run.scene.bodies.size();
  require_same(path, "bodies", scene.bodies, run.scene.bodies);
  require_same(path, "walls", scene.walls, run.scene.walls);
  const std::size_t frame = frame_at(run, time);
  scene.cell = cell_from(run, scene, run.times()[frame]);
  for (std::size_t k = 0; k < bodies; ++k) {
    Body& body = scene.bodies[k];
    // A trap without a centre holds a body at its start in the scene, not where the run has ended.
    if (body.loads.trap && !body.loads.trap->centre) body.loads.trap->centre = body.position;
    const BodyState state = body_state(run.bodies, frame * bodies + k);
    body.position = state.position;
    body.orientation = state.orientation;
  }
  if (scene.walls.empty()) return scene;
  const Checkpoint last = read_saved_run(path / "checkpoint").checkpoint;
  const auto components = static_cast<Eigen::Index>(bodies + scene.walls.size());
  const Configuration poses = to_configuration(last.state.head(3 * components));  // no tracers
  for (std::size_t k = 0; k < scene.walls.size(); ++k) {
    const Pose& pose = poses.at(bodies + k);
    if (last.t != run.times()[frame] && !is_unmoved(run.scene.walls[k], pose)) {
      fail(path, "walls[" + std::to_string(k) +
                     "] has moved, and its place is known only at the last state, t = " +
                     number_text(last.t));
    }
    scene.walls[k].position = pose.position;
    scene.walls[k].orientation = pose.orientation;
  }
  return scene;
}

}  // namespace stokesbook
