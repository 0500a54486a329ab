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

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw RecordError(path, "reading", error);
  return size;
}

}  // namespace

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

std::string read_text(const std::filesystem::path& path) {
  std::string text(size_of(path), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    throw RecordError(path, "reading", {errno, std::generic_category()});
  }
  return text;
}

}  // namespace stokesbook
