#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <boost/test/unit_test.hpp>
#include <stdlib.h>

#include "sweep/sweep_folder.hpp"

namespace stokesbook::test {

/// A folder for the files of one test, with a scene in it.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "stokesbook-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
    write("scene.toml",
          "seed = 7\n[flow]\nkind = 'shear'\nrate = 1.0\n"
          "[[bodies]]\nshape = { kind = 'ellipse', semi_axes = [1.0, 0.5] }\nn_nodes = 32\n"
          "[time]\nt_final = 2.0\ndt = 0.5\n");
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }
  std::string text_of(const std::filesystem::path& name) const {
    std::ifstream file(path_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  /// Adds a fill to the scene, which depends on the seed.
  void add_fill() const {
    std::string text = text_of("scene.toml");
    text.insert(text.find("[time]"),
                "[[fill]]\nshape = { kind = 'circle', radius = 0.1 }\ncount = 2\n"
                "region = { box = [2, 2, 4, 4] }\nn_nodes = 32\n");
    write("scene.toml", text);
  }

  /// Reads a sweep on the scene of this folder from a text; line 1 of the file names the scene.
  Sweep sweep(const std::string& text) const {
    return read_sweep(write("sweep.toml", "scene = 'scene.toml'\n" + text));
  }

 private:
  std::filesystem::path path_;
};

/// Opens a sweep in a new folder, and returns its list of tasks.
inline std::string manifest(const Sweep& sweep) {
  const Folder folder;
  open_sweep(folder.path() / "new", sweep);
  return folder.text_of("new/tasks.csv");
}

/// Returns the message of an error that an action throws, without the folder, or "no error".
template <class Error, class Action>
std::string message_of(const Folder& folder, Action action) {
  try {
    action();
  } catch (const Error& error) {
    std::string message = error.what();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = 0; (at = message.find(prefix)) != std::string::npos;) {
      message.erase(at, prefix.size());
    }
    return message;
  }
  return "no error";
}

}  // namespace stokesbook::test
