// Grows a file by complete records, with two copies that take turns under the name of the file.
#include "record/growing_file.hpp"

#include <cerrno>
#include <fstream>
#include <string>
#include <utility>

#include "record/atomic_file.hpp"
#include "record/record_error.hpp"

namespace stokesbook {

namespace {

namespace fs = std::filesystem;

/// Returns the path of the copy that will be the partial one next.
fs::path next_partial_of(const fs::path& path) {
  return partial_of(partial_of(path));
}

/// Gives a file a second name, or copies the file if the file system has no hard links.
void keep(const fs::path& path, const fs::path& second) {
  std::error_code error;
  fs::create_hard_link(path, second, error);
  if (error) fs::copy_file(path, second, error);
  if (error) throw RecordError(second, "copying " + path.filename().string(), error);
}

/// Cuts a file back, removes partial copies that a kill has left, and starts a new partial copy.
AppendFile start_beside(const fs::path& path, std::uintmax_t size) {
  AppendFile::reopen(path, size);
  for (const fs::path& left : {partial_of(path), next_partial_of(path)}) {
    std::error_code error;
    fs::remove(left, error);
    if (error) throw RecordError(left, "removing", error);
  }
  return AppendFile::create(partial_of(path));
}

}  // namespace

GrowingFile::GrowingFile(const fs::path& path, std::uintmax_t size)
    : path_(path), published_(size), partial_(start_beside(path, size)) {
  catch_up();
}

GrowingFile::~GrowingFile() {
  if (!partial_.is_open()) return;
  try {
    if (size() > published_) {
      partial_.sync();
      rename_file(partial_of(path_), path_);
    }
  } catch (const RecordError&) {  // published records stay
  }
  std::error_code none;
  fs::remove(partial_of(path_), none);
}

void GrowingFile::publish() {
  partial_.sync();
  keep(path_, next_partial_of(path_));
  rename_file(partial_of(path_), path_);
  const std::uintmax_t before = std::exchange(published_, size());
  rename_file(next_partial_of(path_), partial_of(path_));
  partial_ = AppendFile::reopen(partial_of(path_), before);
  catch_up();
}

void GrowingFile::catch_up() {
  std::ifstream file(path_, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(size()));
  std::string piece(1 << 16, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    partial_.append({piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (size() != published_) throw RecordError(path_, "reading", {errno, std::generic_category()});
}

}  // namespace stokesbook
