#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/checkpoint.hpp"
#include "record/file_lock.hpp"
#include "record/run_data.hpp"
#include "record/vtk.hpp"

namespace stokesbook {

/// The contents of a run, and the files that it writes in addition to steps.csv and checkpoint.
struct RunContents {
  std::string title;      ///< title of pictures and animation
  std::string scene;      ///< resolved scene text; a run resumes only with the same text
  Outlines outlines;      ///< outlines of all bodies and walls
  bool csv = true;        ///< trajectory.csv and rheology.csv, and walls.csv when there are walls
  bool vtk = false;       ///< bodies.pvd and one .vtp for each frame
  bool svg = false;       ///< configuration.svg of the latest frame, and pictures of its fields
  bool html = false;      ///< animation.html
  bool fields = false;    ///< fields.pvd and one .vti for each frame
  bool cell = false;      ///< with csv: more columns in trajectory, rheology and contacts.csv
  bool contacts = false;  ///< with csv: contacts.csv; with vtk: contacts.pvd, a .vtp for each frame
  bool tracers = false;   ///< with csv: tracers.csv; with vtk: tracers.pvd, a .vtp for each frame
  bool nodes = false;     ///< with csv: nodes.csv
  std::string program{};  ///< fingerprint of the program that writes the run
};

/// Names of the scenes of a run that has been changed: the scene with which the run went on to a
/// frame, the last before the change.
inline constexpr FrameFiles earlier_scenes{"scene_until_frame", ".toml"};

/// Name of the copy that keep_checkpoint() makes.
inline constexpr const char* kept_checkpoint = "checkpoint_before_end";

/// Treatment of an earlier run in the same directory.
enum class ExistingRun {
  refuse,    ///< the files of the run stay, and create() throws
  restart,   ///< the files are removed if they include steps.csv, which every run writes first
  overwrite  ///< the files are removed
};

struct ResumedRun;

/// The state from which a run continues with another scene, of the same bodies and walls.
struct ChangedScene {
  std::string before;       ///< resolved scene text of the run so far
  bool before_end = false;  ///< true: at the checkpoint of keep_checkpoint(), not at the last one
};

/// The files of one run, written so that a kill at any moment leaves files that can be read and a
/// run that can be resumed; @ref record lists the files, and the rules that ensure this.
///
/// Tables and the animation grow when save() is called and when the run is closed; all other files
/// are replaced as a whole. Only one object at a time can write a directory.
class RunDirectory {
 public:
  /// Makes the directory, if necessary, and the growing files with their headers.
  ///
  /// Only files with names of a run's files are removed. An old scene.toml stays until write_text()
  /// replaces it, because the new run may have been started from it.
  /// @throws RecordError when the directory cannot be written, when another run is writing it, or
  ///         when files of an earlier run must stay
  static RunDirectory create(const std::filesystem::path& path, RunContents contents,
                             ExistingRun existing);

  /// Opens a run at a checkpoint, and removes rows and frames that were written later.
  ///
  /// After a change of the scene the run may write more files. Call save() before anything else:
  /// until then the folder belongs to the scene before, and a killed run resumes with that.
  /// @param  contents  the same as for create(), but for scene and added files after a change
  /// @param  change    none: the scene is the same, and the run continues at its last checkpoint
  /// @throws RecordError when another run is writing the directory, or when checkpoint, contents
  ///         and files do not match
  static ResumedRun resume(const std::filesystem::path& path, RunContents contents,
                           const std::optional<ChangedScene>& change = {});

  /// Adds a frame to all files of the run. Tables and the animation contain the frame after save().
  /// @throws std::invalid_argument when the frame does not match the outlines, has contacts or a
  ///         field that the run does not write, or lacks a field that the run writes
  /// @throws RecordError when a file cannot be written; earlier data stay valid
  void write_frame(const Frame& frame);

  /// Adds a row to steps.csv. The file contains the row after save().
  void write_step(const StepInfo& step);

  /// Adds everything written so far to the files, waits for the disk, and stores the checkpoint.
  /// @throws RecordError when the disk refuses the data; the last checkpoint then stays
  /// @par Cost  a wait for the disk, some milliseconds, for each table and each other file written
  ///            since the last call
  void save(const Checkpoint& checkpoint);

  /// Keeps a copy of the last checkpoint, if there is one, beside the later ones: the run can be
  /// extended from there.
  void keep_checkpoint() const;

  /// Replaces a file in the directory by a text, atomically and safe from a power cut.
  void write_text(const std::string& name, std::string_view text) const;

  /// Returns the number of frames written so far, including the frames before a resume.
  std::size_t frame_count() const { return frame_times_.size(); }

 private:
  RunDirectory(FileLock lock, const std::filesystem::path& path, RunContents contents);

  /// Opens the growing files: those with a size are cut back to it, all others begin anew.
  void open_tables(const std::map<std::string, std::uintmax_t>& sizes);

  /// Adds rows to a table, if the run writes this table.
  void append(const std::string& table, std::string_view rows);

  /// Updates the collections, which list the files of all frames.
  void write_collections();

  /// Replaces a file, which is safe from a power cut only after the next save().
  void replace(const std::string& name, std::string_view text);

  FileLock lock_;
  std::filesystem::path path_;
  RunContents contents_;
  std::map<std::string, AppendFile> tables_;  ///< by file name
  std::vector<double> frame_times_;
  std::set<std::string> unsynced_;  ///< names of files written since the last save()
};

/// A run opened at its last checkpoint.
struct ResumedRun {
  RunDirectory directory;       ///< cut back to the checkpoint
  Checkpoint checkpoint;        ///< data from which the solver continues
  bool by_this_program = true;  ///< whether the saving program is that of the contents
};

}  // namespace stokesbook
