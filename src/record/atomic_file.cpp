// Writes files that a kill at any moment leaves valid, by POSIX calls. A file that is replaced is
// written under a partial name, then renamed; where a power cut matters, the disk confirms the file
// before the renaming and its name after it. A file that grows is written by one call for many
// records, and incomplete records are cut off.
#include "record/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace stokesbook {

namespace {

std::error_code last_error() {
  return {errno, std::generic_category()};
}

constexpr const char* partial_extension = ".partial";

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw RecordError(path, "reading", error);
  return size;
}

}  // namespace

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw RecordError(path, "making the directory", error);
}

void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger) {
  std::filesystem::path partial = path;
  partial += partial_extension;
  std::error_code error;
  std::filesystem::remove(partial, error);
  AppendFile file = AppendFile::create(partial);
  file.append(text);
  danger == SafeFrom::power_cut ? file.sync() : file.flush();
  std::filesystem::rename(partial, path, error);
  if (error) throw RecordError(path, "renaming " + partial.filename().string(), error);
  if (danger == SafeFrom::power_cut) sync_names(path.parent_path());
}

std::filesystem::path without_partial(std::filesystem::path path) {
  while (path.extension() == partial_extension) path.replace_extension();
  return path;
}

void sync_file(const std::filesystem::path& path) {
  AppendFile::reopen(path, size_of(path)).sync();
}

void sync_names(const std::filesystem::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

AppendFile::AppendFile(const std::filesystem::path& path, int flags)
    : path_(path),
      descriptor_(::open(path.c_str(),
                         O_WRONLY | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | flags, 0666)) {
  if (descriptor_ >= 0) return;
  if (errno == ELOOP) {
    throw RecordError(path, "is a symbolic link; files of a run must be regular files");
  }
  if (errno == ENXIO) throw RecordError(path, "is not a regular file");
  throw RecordError(path, "opening", last_error());
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_),
      waiting_(std::move(other.waiting_)) {}

AppendFile::~AppendFile() {
  if (descriptor_ < 0) return;
  try {
    flush();
  } catch (const RecordError&) {  // earlier records stay
  }
  ::close(descriptor_);
}

AppendFile AppendFile::create(const std::filesystem::path& path) {
  return {path, O_CREAT | O_EXCL};
}

AppendFile AppendFile::reopen(const std::filesystem::path& path, std::uintmax_t size) {
  AppendFile file(path, 0);
  struct stat status {};
  if (::fstat(file.descriptor_, &status) != 0) throw RecordError(path, "reading", last_error());
  if (S_ISFIFO(status.st_mode)) throw RecordError(path, "is not a regular file");
  const auto found = static_cast<std::uintmax_t>(status.st_size);
  if (found < size) {
    throw RecordError(path, "has " + std::to_string(found) + " bytes, should have at least " +
                                std::to_string(size));
  }
  file.size_ = size;
  if (found > size && !file.cut_back()) throw RecordError(path, "cutting back", last_error());
  return file;
}

void AppendFile::flush() {
  const std::string records = std::exchange(waiting_, {});
  std::string_view rest = records;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written >= 0) {
      rest.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      const std::error_code cause = last_error();
      cut_back();
      throw RecordError(path_, "writing", cause);
    }
  }
  size_ += records.size();
}

void AppendFile::sync() {
  flush();
  if (::fsync(descriptor_) != 0) throw RecordError(path_, "writing to disk", last_error());
}

bool AppendFile::cut_back() {
  return ::ftruncate(descriptor_, static_cast<off_t>(size_)) == 0;
}

std::string read_text(const std::filesystem::path& path) {
  std::string text(size_of(path), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    throw RecordError(path, "reading", last_error());
  }
  return text;
}

}  // namespace stokesbook
