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
#include "text/fingerprint.hpp"
#include "text/number_text.hpp"
#include "text/text_file.hpp"
#include "text/word_list.hpp"

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

[[noreturn]] void refuse_missing_tasks(const std::filesystem::path& out) {
  throw RecordError(manifest_file(out), "lacks tasks of the sweep; run stokes sweep --plan first");
}

[[noreturn]] void refuse_other_sweep(const std::filesystem::path& out, std::size_t number) {
  throw RecordError(manifest_file(out),
                    "belongs to another sweep, or the scene has changed: the sweep lacks task " +
                        std::to_string(number) + "; choose another --out");
}

std::string header(const Sweep& sweep) {
  std::string text = "task,folder,";
  for (const std::string& name : sweep.columns) text += csv_cell(name) + ",";
  if (!sweep.seeds.values.empty()) text += "seed,";
  return text + "scene\n";
}

std::string scene_fingerprint(const Sweep& sweep, const Task& task) {
  return fingerprint(to_toml(scene_of(sweep, task)));
}

/// Returns the row of a task without the fingerprint at its end.
std::string row(const Task& task) {
  std::string text = std::to_string(task.number) + "," + TaskFolder::name(task.number) + ",";
  for (const Setting& setting : task.settings) text += csv_cell(setting.chosen.value) + ",";
  return text;
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

/// Returns the rows of a manifest; the place of a row is the number of its task.
std::vector<std::string_view> rows_of(std::string_view text) {
  const std::vector<std::string_view> lines = split(text, '\n');
  return {lines.begin() + 1, std::max(lines.begin() + 1, lines.end() - 1)};
}

/// The tasks of a sweep, by their places, and the text of its manifest.
struct TaskList {
  std::vector<Task> tasks;
  std::string text;
};

/// Lists the tasks of a sweep. Tasks with a row in an earlier manifest, each of whose rows must
/// have a task, keep their numbers; other tasks have the next ones.
TaskList list_tasks(const std::filesystem::path& out, const Sweep& sweep,
                    std::string_view earlier) {
  std::map<std::string, std::size_t, std::less<>> numbers, places;  // by fingerprint of the scene
  for (const std::string_view line : rows_of(earlier)) {
    numbers.emplace(line.substr(line.rfind(',') + 1), numbers.size());
  }
  TaskList list{{}, header(sweep)};
  std::map<std::size_t, std::string> rows;
  for (std::size_t k = 0; k < task_count(sweep); ++k) {
    Task& task = list.tasks.emplace_back(task_of(sweep, k));
    const std::string scene = scene_fingerprint(sweep, task);
    const auto [first, is_new] = places.emplace(scene, k);
    if (!is_new) refuse_repetition(task, task_of(sweep, first->second));
    task.number = numbers.emplace(scene, numbers.size()).first->second;
    rows[task.number] = row(task) + scene + "\n";
  }
  for (const auto& [scene, number] : numbers) {
    if (!places.contains(scene)) refuse_other_sweep(out, number);
  }
  for (const auto& [number, text] : rows) list.text += text;
  return list;
}

}  // namespace

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::vector<Task> open_sweep(const std::filesystem::path& out, const Sweep& sweep) {
  const auto read = [&] { return read_text_file(manifest_file(out)).value_or(""); };
  std::string before = read();
  TaskList list = list_tasks(out, sweep, before);
  make_folder(out / "runs");
  // If two sweeps begin at once, one of them writes the manifest.
  const FileLock lock = FileLock::wait_for(sweep_lock(out));
  if (const std::string now = read(); now != before) {
    list = list_tasks(out, sweep, before = now);
  }
  if (list.text != before) write_atomically(manifest_file(out), list.text, SafeFrom::power_cut);
  for (const Task& task : list.tasks) make_folder(TaskFolder(out, task.number).path());
  return list.tasks;
}

std::vector<Task> require_sweep(const std::filesystem::path& out, const Sweep& sweep) {
  const std::string text = read_manifest(out);
  TaskList list = list_tasks(out, sweep, text);
  if (list.text != text) refuse_missing_tasks(out);
  return list.tasks;
}

Task require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t number) {
  const std::string text = read_manifest(out);
  const std::vector<std::string_view> rows = rows_of(text);
  if (number >= rows.size()) refuse_missing_tasks(out);
  for (std::size_t k = 0; k < task_count(sweep); ++k) {
    Task task = task_of(sweep, k);
    task.number = number;
    const std::string start = row(task);
    if (!rows[number].starts_with(start)) continue;
    if (rows[number] == start + scene_fingerprint(sweep, task)) return task;
  }
  refuse_other_sweep(out, number);
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
  return std::filesystem::exists(failure(), error) ? TaskState::failed : TaskState::unfinished;
}

}  // namespace stokesbook
