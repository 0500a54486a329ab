// Replaces files atomically: a file is written under a partial name, then renamed; where a power
// cut matters, the disk confirms the file before the renaming and its name after it.
#include "record/atomic_file.hpp"

#include <cerrno>
#include <fstream>

#include <fcntl.h>
#include <unistd.h>

#include "record/append_file.hpp"
#include "record/record_error.hpp"

namespace stokesbook {

namespace {

constexpr const char* partial_extension = ".partial";

}  // namespace

void write_atomically(const std::filesystem::path& path, std::string_view text, SafeFrom danger) {
  const std::filesystem::path partial = partial_of(path);
  std::error_code none;
  std::filesystem::remove(partial, none);
  AppendFile file = AppendFile::create(partial);
  file.append(text);
  danger == SafeFrom::power_cut ? file.sync() : file.flush();
  rename_file(partial, path);
  if (danger == SafeFrom::power_cut) sync_names(path.parent_path());
}

std::filesystem::path partial_of(const std::filesystem::path& path) {
  std::filesystem::path partial = path;
  return partial += partial_extension;
}

std::filesystem::path without_partial(std::filesystem::path path) {
  while (path.extension() == partial_extension) path.replace_extension();
  return path;
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) throw RecordError(to, "renaming " + from.filename().string(), error);
}

void sync_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw RecordError(path, "reading", error);
  AppendFile::reopen(path, size).sync();
}

void sync_names(const std::filesystem::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

std::string read_text(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw RecordError(path, "reading", error);
  std::string text(size, '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
    throw RecordError(path, "reading", {errno, std::generic_category()});
  }
  return text;
}

}  // namespace stokesbook
