// Writes and checks `tasks.csv`, the list of a sweep's tasks with fingerprints of their scenes, and
// reads the state of a task from the files in its folder.
#include "sweep/sweep_folder.hpp"

#include <algorithm>
#include <map>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/file_lock.hpp"
#include "record/run_info.hpp"
#include "scene/scene.hpp"
#include "scene/write.hpp"
#include "sweep/task.hpp"
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/text_file.hpp"

namespace stokesbook {

namespace {

std::filesystem::path manifest_file(const std::filesystem::path& out) {
  return out / "tasks.csv";
}

/// Returns the manifest in the folder of a sweep.
std::string read_manifest(const std::filesystem::path& out) {
  std::error_code error;
  if (std::filesystem::exists(manifest_file(out), error)) return read_text(manifest_file(out));
  throw RecordError(manifest_file(out), "does not exist; run stokes sweep --plan first");
}

void require_same(const std::filesystem::path& out, bool is_same) {
  if (is_same) return;
  throw RecordError(manifest_file(out),
                    "belongs to another sweep, or the scene has changed; choose another --out");
}

std::string header(const Sweep& sweep) {
  std::string text = "task,folder,";
  for (const Axis& axis : sweep.axes) text += csv_cell(axis.name) + ",";
  if (!sweep.seeds.values.empty()) text += sweep.seeds.name + ",";
  return text + "scene\n";
}

std::string scene_fingerprint(const Sweep& sweep, const Task& task) {
  return fingerprint(to_toml(scene_of(sweep, task)));
}

std::string row(const Task& task, const std::string& scene) {
  std::string text = std::to_string(task.number) + "," + TaskFolder::name(task.number) + ",";
  for (const Setting& setting : task.settings) text += csv_cell(setting.chosen.value) + ",";
  return text + scene + "\n";
}

/// Refuses two tasks with the same scene, at the place of the first value in which they differ.
[[noreturn]] void refuse_repetition(const Task& task, const Task& earlier) {
  const auto same = [](const Setting& a, const Setting& b) {
    return a.chosen.value == b.chosen.value;
  };
  const auto [differs, _] = std::ranges::mismatch(task.settings, earlier.settings, same);
  throw SceneError(differs->chosen.where + ": " + task.description() + ": the scene is that of " +
                   earlier.description());
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::string manifest(const Sweep& sweep) {
  std::string text = header(sweep);
  std::map<std::string, std::size_t> tasks;  // task numbers by fingerprint of the scene
  for (std::size_t k = 0; k < task_count(sweep); ++k) {
    const Task task = task_of(sweep, k);
    const std::string scene = scene_fingerprint(sweep, task);
    const auto [earlier, is_new] = tasks.emplace(scene, k);
    if (!is_new) refuse_repetition(task, task_of(sweep, earlier->second));
    text += row(task, scene);
  }
  return text;
}

void open_sweep(const std::filesystem::path& out, const Sweep& sweep) {
  const std::string text = manifest(sweep);
  make_folder(out / "runs");
  // If two sweeps begin at once, one of them writes the manifest.
  const FileLock lock = FileLock::wait_for(sweep_lock(out));
  std::error_code error;
  if (!std::filesystem::exists(manifest_file(out), error)) {
    write_atomically(manifest_file(out), text, SafeFrom::power_cut);
  }
  require_same(out, read_manifest(out) == text);
  for (std::size_t k = 0; k < task_count(sweep); ++k) make_folder(TaskFolder(out, k).path());
}

void require_sweep(const std::filesystem::path& out, const Sweep& sweep) {
  const std::string text = manifest(sweep);
  require_same(out, read_manifest(out) == text);
}

void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task) {
  const std::string text = read_manifest(out);
  const Task asked = task_of(sweep, task);
  const std::string line = "\n" + row(asked, scene_fingerprint(sweep, asked));
  require_same(out, text.starts_with(header(sweep)) && text.find(line) != std::string::npos);
}

std::filesystem::path sweep_lock(const std::filesystem::path& out) {
  return out / "lock";
}

std::string TaskFolder::name(std::size_t task) {
  return "runs/" + padded_number(task, 4);
}

TaskState TaskFolder::state() const {
  if (exit_status_of(path_) == 0) return TaskState::done;
  std::error_code error;
  return std::filesystem::exists(failure_file(), error) ? TaskState::failed : TaskState::unfinished;
}

std::string TaskFolder::failure() const {
  return read_text_file(failure_file()).value_or("");
}

void TaskFolder::write_failure(std::string_view message) const {
  write_atomically(failure_file(), message, SafeFrom::kill);
}

void TaskFolder::remove_failure() const {
  std::error_code error;
  std::filesystem::remove(failure_file(), error);
}

}  // namespace stokesbook
