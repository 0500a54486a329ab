#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "record/checkpoint.hpp"
#include "record/folder_lock.hpp"
#include "record/growing_file.hpp"
#include "record/outline.hpp"
#include "record/run_data.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// What a run is about and which files it writes beside steps.csv and checkpoint.
struct RunContents {
  std::string title;            ///< of the picture
  std::string scene;            ///< resolved scene text: a run resumes with the same only
  std::vector<Outline> bodies;  ///< in the order of Frame::bodies
  std::vector<Outline> walls;   ///< in the order of Frame::walls
  bool csv = true;        ///< trajectory.csv and rheology.csv, and walls.csv when there are walls
  bool vtk = false;       ///< bodies.pvd and one .vtp a frame
  bool svg = false;       ///< configuration.svg of the latest frame, and pictures of its fields
  bool html = false;      ///< animation.html
  bool fields = false;    ///< fields.pvd and one .vti a frame
  bool contacts = false;  ///< with csv contacts.csv, and with vtk contacts.pvd and one .vtp a frame
  std::string program{};  ///< fingerprint of the program that writes
};

/// What happens to a run that a directory holds already.
enum class ExistingRun {
  refuse,    ///< it stays, and create() throws
  restart,   ///< its files are removed if it has begun steps.csv, which every run begins with
  overwrite  ///< its files are removed
};

struct ResumedRun;

/// The files of one run, written so that a kill at any moment leaves files that can be read and a
/// run that can be resumed.
///
/// Tables and the animation grow when save() is called, and when the run is closed; all other files
/// are replaced as a whole. save() brings all of them to the disk, and then replaces the checkpoint,
/// which holds their lengths and the times of the frames; resume() cuts both back, so that what
/// follows is written as if nothing had happened. One object at a time writes a directory.
class RunDirectory {
 public:
  /// Makes the directory, if need be, and the files that grow with their headers.
  ///
  /// Files are removed that a run writes and no others. An old scene.toml stays until write_text()
  /// replaces it: the new run may have been started from it.
  /// @param  path      of the directory
  /// @param  contents  what the run is about
  /// @param  existing  what to do with a run that is there already
  /// @return           the directory, without frames and steps
  /// @throws RecordError when the directory cannot be written, is being written by another run, or
  ///         holds files with the names of a run's that are not to be removed
  static RunDirectory create(const std::filesystem::path& path, RunContents contents,
                             ExistingRun existing);

  /// Goes back to the last checkpoint: tables and frames written after it are dropped.
  ///
  /// @param  path      of the directory
  /// @param  contents  as create() had them
  /// @return           the directory and the checkpoint to go on from
  /// @throws RecordError when there is no whole checkpoint, it is of another scene, a table is
  ///         missing or shorter than it says, or another run writes the directory
  static ResumedRun resume(const std::filesystem::path& path, RunContents contents);

  /// Adds a written time to all files asked for; tables and the animation show it after save().
  ///
  /// @param  frame  the configuration at that time
  /// @throws std::invalid_argument when the frame has other bodies or walls than the contents, a
  ///         contact of others, contacts or a field although the run writes none, or no field
  ///         although it does
  /// @throws RecordError when the disk does not take it; what was written before stays valid
  void write_frame(const Frame& frame);

  /// Adds a row to steps.csv, which shows it after save().
  ///
  /// @param  step  what it did
  /// @throws RecordError when the disk does not take it
  void write_step(const StepInfo& step);

  /// Shows all that was written so far, and makes it and the checkpoint permanent.
  ///
  /// @param  checkpoint  what the solver can go on from
  /// @throws std::invalid_argument when a name of the history is not one word
  /// @throws RecordError when the disk does not take it; the last checkpoint then stays
  /// @par Cost  a wait for the disk, some milliseconds, for each table and each other file written
  ///            since the last call
  void save(const Checkpoint& checkpoint);

  /// Replaces a file by text, as a whole and at once safe from a power cut.
  ///
  /// @param  name  of the file in the directory
  /// @param  text  all that it is to hold
  /// @throws RecordError when the disk does not take it
  void write_text(const std::string& name, std::string_view text) const;

  /// Counts the frames written so far.
  /// @return their number, those before a resumption included
  std::size_t frame_count() const { return frame_times_.size(); }

 private:
  RunDirectory(FolderLock lock, const std::filesystem::path& path, RunContents contents);

  /// Begins a file that grows.
  void begin(const std::string& name, std::string_view head);

  /// Adds rows to a table, if this run has it.
  void append(const std::string& table, std::string_view rows);

  /// Brings the collections of the files of all frames up to date.
  void write_collections();

  /// Draws the latest frame.
  void write_pictures(const Frame& frame);

  /// Replaces a file of a frame, safe from a power cut after the next save() only.
  void replace(const std::string& name, std::string_view text);

  FolderLock lock_;
  std::filesystem::path path_;
  RunContents contents_;
  std::map<std::string, GrowingFile> tables_;  ///< by file name
  std::vector<double> frame_times_;
  std::set<std::string> unsynced_;  ///< names of files written since the last save()
};

/// A run opened at its last checkpoint.
struct ResumedRun {
  RunDirectory directory;       ///< cut back to the checkpoint
  Checkpoint checkpoint;        ///< what the solver goes on from
  bool by_this_program = true;  ///< whether the program that saved it is that of the contents
};

/// @}

}  // namespace stokesbook
