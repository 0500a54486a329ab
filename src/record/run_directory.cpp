// Manages the files of a run: makes or removes them, adds frames and steps, and reopens a run at
// its last checkpoint.
#include "record/run_directory.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "record/animation.hpp"
#include "record/csv.hpp"
#include "record/picture.hpp"
#include "record/vtk.hpp"
#include "text/fingerprint.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

constexpr const char* checkpoint_name = "checkpoint";
constexpr const char* trajectory_name = "trajectory.csv";
constexpr const char* walls_name = "walls.csv";
constexpr const char* rheology_name = "rheology.csv";
constexpr const char* contacts_name = "contacts.csv";
constexpr const char* tracers_name = "tracers.csv";
constexpr const char* nodes_name = "nodes.csv";
constexpr const char* steps_name = "steps.csv";
constexpr const char* animation_name = "animation.html";
constexpr const char* picture_name = "configuration.svg";
constexpr const char* resistance_name = "resistance.csv";
constexpr const char* mobility_name = "mobility.csv";
constexpr const char* info_name = "run.json";
constexpr const char* scene_name = "scene.toml";
constexpr std::array frame_files{body_files, contact_files, tracer_files, field_files,
                                 earlier_scenes};

struct GrowingFile {
  std::string name;
  std::string head;
};

/// Returns the files that grow, steps.csv first, which every run has.
std::vector<GrowingFile> growing_files(const RunContents& contents) {
  std::vector<GrowingFile> files;
  const auto add = [&](const char* name, std::string_view head) {
    files.push_back({name, std::string(head)});
  };
  add(steps_name, steps_header);
  const auto add_in_cells = [&](const char* name, std::string_view head, std::string_view more) {
    add(name, contents.cell ? continued(head, more) : std::string(head));
  };
  if (contents.csv) add_in_cells(trajectory_name, trajectory_header, cell_trajectory_columns);
  if (contents.csv) add_in_cells(rheology_name, rheology_header, cell_rheology_columns);
  if (contents.csv && !contents.outlines.walls.empty()) add(walls_name, walls_header);
  if (contents.csv && contents.contacts) {
    add_in_cells(contacts_name, contacts_header, cell_contacts_columns);
  }
  if (contents.csv && contents.tracers) add(tracers_name, tracers_header);
  if (contents.csv && contents.nodes) add(nodes_name, nodes_header);
  if (contents.html) add(animation_name, animation_head(contents.title, contents.outlines));
  return files;
}

/// Returns the frame number in a file name, and no value for files that belong to no single frame.
std::optional<std::size_t> frame_of(const std::string& name) {
  for (const FrameFiles& files : frame_files) {
    if (const auto frame = files.frame_of(name)) return frame;
  }
  return {};
}

bool belongs_to_run(const std::string& name) {
  constexpr std::array names{checkpoint_name, kept_checkpoint, trajectory_name, walls_name,
                             rheology_name,   contacts_name,   steps_name,      animation_name,
                             picture_name,    resistance_name, mobility_name,   tracers_name,
                             nodes_name,      info_name};
  const auto collects = [&](const FrameFiles& files) { return name == files.collection(); };
  return std::ranges::find(names, name) != names.end() ||
         std::ranges::any_of(frame_files, collects) || is_field_picture(name) || frame_of(name);
}

/// Returns the names of a directory's files.
std::vector<fs::path> file_names(const fs::path& directory) {
  std::vector<fs::path> names;
  try {
    for (const auto& entry : fs::directory_iterator(directory)) {
      names.push_back(entry.path().filename());
    }
  } catch (const fs::filesystem_error& error) {
    throw RecordError(directory, "listing", error.code());
  }
  return names;
}

/// Removes the files whose names `pick` accepts, and their partial versions that a kill has left.
void remove_files(const fs::path& directory, auto pick) {
  for (const fs::path& name : file_names(directory)) {
    if (!pick(without_partial(name).string())) continue;
    std::error_code error;
    fs::remove(directory / name, error);
    if (error) throw RecordError(directory / name, "removing", error);
  }
}

/// Refuses a directory with a file that the run would replace.
void require_no_run(const fs::path& directory, const std::string& ways_out) {
  const std::vector<fs::path> names = file_names(directory);
  const auto found = std::ranges::find_if(
      names, [](const std::string& name) { return belongs_to_run(name) || name == scene_name; });
  if (found == names.end()) return;
  throw RecordError(directory, "already contains a run (" + found->string() + "); use " + ways_out +
                                   " or another directory");
}

/// Refuses a checkpoint that names other files than the run writes: every file that it names will
/// be opened and cut back, and a wrong name may be the path of a foreign file. Only a changed scene
/// may add files.
void require_own_tables(const fs::path& directory, const SavedRun& saved,
                        const std::vector<GrowingFile>& own, bool is_changed) {
  const auto is_listed = [&](const GrowingFile& file) {
    return saved.table_sizes.contains(file.name);
  };
  const auto listed = std::ranges::count_if(own, is_listed);
  if (std::cmp_equal(listed, saved.table_sizes.size()) &&
      (is_changed || std::cmp_equal(listed, own.size()))) {
    return;
  }
  throw RecordError(directory / checkpoint_name, "lists other files than this run writes");
}

/// Removes the files of a run, the checkpoint first and steps.csv last. After a kill in between, no
/// checkpoint refers to missing files, and steps.csv still marks the directory as that of a run.
void remove_run(const fs::path& directory) {
  remove_files(directory, [](const std::string& name) { return name == checkpoint_name; });
  remove_files(directory,
               [](const std::string& name) { return belongs_to_run(name) && name != steps_name; });
  remove_files(directory, [](const std::string& name) { return name == steps_name; });
}

}  // namespace

RunDirectory::RunDirectory(FileLock lock, const fs::path& path, RunContents contents)
    : lock_(std::move(lock)), path_(path), contents_(std::move(contents)) {}

RunDirectory RunDirectory::create(const fs::path& path, RunContents contents,
                                  ExistingRun existing) {
  make_folder(path);
  FileLock lock = FileLock::of_folder(path);
  std::error_code error;
  if (existing == ExistingRun::refuse) {
    require_no_run(path, "--resume, --overwrite");
  } else if (existing == ExistingRun::restart && !fs::exists(path / steps_name, error)) {
    require_no_run(path, "--overwrite");
  } else {
    remove_run(path);
  }
  RunDirectory directory(std::move(lock), path, std::move(contents));
  directory.open_tables({});
  return directory;
}

ResumedRun RunDirectory::resume(const fs::path& path, RunContents contents,
                                const std::optional<ChangedScene>& change) {
  FileLock lock = FileLock::of_folder(path);
  const fs::path source = path / (change && change->before_end ? kept_checkpoint : checkpoint_name);
  SavedRun saved = read_saved_run(source);
  if (saved.scene != fingerprint(change ? change->before : contents.scene)) {
    throw RecordError(source, "was written by a run of another scene");
  }
  RunDirectory directory(std::move(lock), path, std::move(contents));
  require_own_tables(path, saved, growing_files(directory.contents_), change.has_value());
  // The last checkpoint must not refer to more rows than the tables have.
  if (source.filename() == kept_checkpoint) directory.write_text(checkpoint_name, to_text(saved));
  directory.open_tables(saved.table_sizes);
  directory.frame_times_ = std::move(saved.frame_times);
  // Collections are shortened first, so that they never name a missing file.
  directory.write_collections();
  remove_files(path, [&](const std::string& name) {
    const std::optional<std::size_t> frame = frame_of(name);
    return frame && *frame >= directory.frame_count();
  });
  const bool by_this_program = saved.program == directory.contents_.program;
  return {std::move(directory), std::move(saved.checkpoint), by_this_program};
}

void RunDirectory::write_frame(const Frame& frame) {
  require_outlines(frame, contents_.outlines);
  if (frame.field.has_value() != contents_.fields) {
    throw std::invalid_argument("a frame must have a field exactly if the run writes fields");
  }
  if (!contents_.contacts && !frame.contacts.empty()) {
    throw std::invalid_argument("a frame has contacts only if the run writes them");
  }
  // In a periodic cell, tables list paths, and pictures show the images in the cell.
  const std::optional<Frame> images = frame.cell ? std::optional(in_cell(frame)) : std::nullopt;
  const Frame& shown = images ? *images : frame;
  append(trajectory_name, trajectory_rows(frame));
  append(walls_name, wall_rows(frame));
  append(rheology_name, rheology_row(frame));
  append(contacts_name, contact_rows(frame));
  append(tracers_name, tracer_rows(frame));
  append(nodes_name, node_rows(frame));
  if (contents_.html) append(animation_name, animation_frame(frame));
  if (contents_.vtk) {
    replace(body_files.name(frame_count()), configuration_vtp(shown, contents_.outlines));
  }
  if (contents_.vtk && contents_.contacts) {
    replace(contact_files.name(frame_count()), contacts_vtp(shown));
  }
  if (contents_.vtk && contents_.tracers) {
    replace(tracer_files.name(frame_count()), tracers_vtp(shown));
  }
  if (contents_.fields) replace(field_files.name(frame_count()), field_vti(*frame.field));
  frame_times_.push_back(frame.t);
  write_collections();
  if (contents_.svg) {
    replace(picture_name, draw_configuration(shown, contents_.outlines, contents_.title));
  }
  if (contents_.svg && contents_.fields) {
    for (const auto& [name, text] : draw_fields(shown, contents_.outlines, contents_.title)) {
      replace(name, text);
    }
  }
}

void RunDirectory::open_tables(const std::map<std::string, std::uintmax_t>& sizes) {
  for (const auto& [name, head] : growing_files(contents_)) {
    const auto size = sizes.find(name);
    if (size == sizes.end()) write_atomically(path_ / name, head, SafeFrom::kill);
    tables_.try_emplace(
        name, AppendFile::reopen(path_ / name, size == sizes.end() ? head.size() : size->second));
  }
}

void RunDirectory::write_collections() {
  const auto write = [&](const FrameFiles& files) {
    // A format that a changed scene has added has no files of the frames before.
    std::size_t first = 0;
    while (first < frame_count() && !fs::exists(path_ / files.name(first))) ++first;
    replace(files.collection(), files.collection_text(frame_times_, first));
  };
  if (contents_.vtk) write(body_files);
  if (contents_.vtk && contents_.contacts) write(contact_files);
  if (contents_.vtk && contents_.tracers) write(tracer_files);
  if (contents_.fields) write(field_files);
}

void RunDirectory::write_step(const StepInfo& step) {
  append(steps_name, step_row(step));
}

void RunDirectory::save(const Checkpoint& checkpoint) {
  SavedRun saved{fingerprint(contents_.scene), contents_.program, {}, frame_times_, checkpoint};
  for (auto& [name, table] : tables_) {
    table.sync();
    saved.table_sizes[name] = table.size();
  }
  for (const std::string& name : unsynced_) sync_file(path_ / name);
  unsynced_.clear();
  sync_names(path_);
  write_text(checkpoint_name, to_text(saved));
}

void RunDirectory::keep_checkpoint() const {
  std::error_code error;
  if (!fs::exists(path_ / checkpoint_name, error)) return;
  write_text(kept_checkpoint, read_text(path_ / checkpoint_name));
}

void RunDirectory::write_text(const std::string& name, std::string_view text) const {
  write_atomically(path_ / name, text, SafeFrom::power_cut);
}

void RunDirectory::replace(const std::string& name, std::string_view text) {
  write_atomically(path_ / name, text, SafeFrom::kill);
  unsynced_.insert(name);
}

void RunDirectory::append(const std::string& name, std::string_view rows) {
  const auto table = tables_.find(name);
  if (table != tables_.end()) table->second.append(rows);
}

}  // namespace stokesbook
