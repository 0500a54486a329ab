#include "sweep/manifest.hpp"

#include <system_error>

#include "record/atomic_file.hpp"
#include "record/checkpoint.hpp"
#include "record/record_error.hpp"
#include "scene/write.hpp"
#include "sweep/file_lock.hpp"
#include "sweep/task.hpp"
#include "sweep/task_folder.hpp"

namespace stokesbook {

namespace {

constexpr const char* manifest_name = "tasks.csv";
constexpr const char* another_sweep =
    "is of another sweep, or the scene has changed since: give another --out";

void require_manifest(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path, error)) return;
  throw RecordError(path, "is not there: stokes sweep with --plan writes it");
}

void require_same(const std::filesystem::path& path, std::string_view manifest) {
  if (read_text(path) != manifest) throw RecordError(path, another_sweep);
}

std::string header(const Sweep& sweep) {
  std::string text = "task,folder,";
  for (const Axis& axis : sweep.axes) text += csv_cell(axis.name) + ",";
  if (!sweep.seeds.values.empty()) text += sweep.seeds.name + ",";
  return text + "scene\n";
}

std::string row(const Sweep& sweep, std::size_t number) {
  const Task task = task_of(sweep, number);
  std::string text = std::to_string(number) + "," + TaskFolder::name(number) + ",";
  for (const Setting& setting : task.settings) text += csv_cell(setting.chosen.value) + ",";
  return text + fingerprint(to_toml(scene_of(sweep, task))) + "\n";
}

}  // namespace

std::filesystem::path sweep_lock(const std::filesystem::path& out) {
  return out / "lock";
}

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  return quoted + '"';
}

std::string manifest(const Sweep& sweep) {
  std::string text = header(sweep);
  for (std::size_t k = 0; k < task_count(sweep); ++k) text += row(sweep, k);
  return text;
}

void open_sweep(const std::filesystem::path& out, std::string_view manifest) {
  std::error_code error;
  std::filesystem::create_directories(out / "runs", error);
  if (error) throw RecordError(out / "runs", "making the directory", error);
  const FileLock lock(sweep_lock(out));  // of two sweeps that begin, one writes
  const std::filesystem::path path = out / manifest_name;
  if (!std::filesystem::exists(path, error)) {
    write_atomically(path, manifest, SafeFrom::power_cut);
  } else {
    require_same(path, manifest);
  }
}

void require_sweep(const std::filesystem::path& out, std::string_view manifest) {
  require_manifest(out / manifest_name);
  require_same(out / manifest_name, manifest);
}

void require_task(const std::filesystem::path& out, const Sweep& sweep, std::size_t task) {
  const std::filesystem::path path = out / manifest_name;
  require_manifest(path);
  const std::string text = read_text(path);
  const std::string first = header(sweep);
  const std::size_t found = text.find(row(sweep, task), first.size() - 1);
  if (!text.starts_with(first) || found == std::string::npos || text[found - 1] != '\n') {
    throw RecordError(path, another_sweep);
  }
}

}  // namespace stokesbook
