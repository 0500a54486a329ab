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
  std::filesystem::path partial = path;
  partial += partial_extension;
  std::error_code error;
  std::filesystem::remove(partial, error);
  AppendFile file = AppendFile::create(partial);
  file.append(text);
  if (danger == SafeFrom::power_cut) file.sync();
  std::filesystem::rename(partial, path, error);
  if (error) throw RecordError(path, "renaming " + partial.filename().string(), error);
  if (danger == SafeFrom::power_cut) sync_names(path.parent_path());
}

bool is_partial(const std::filesystem::path& path) {
  return path.extension() == partial_extension;
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
