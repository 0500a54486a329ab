#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "scene/parse.hpp"

namespace stokesbook::test {

using Overrides = std::vector<std::string>;

inline SceneFile parse_file(const std::string& text, const Overrides& overrides = {},
                            const std::filesystem::path& directory = {}) {
  return parse_scene(text, "s.toml", directory, overrides);
}

inline Scene parse(const std::string& text, const Overrides& overrides = {},
                   const std::filesystem::path& directory = {}) {
  return parse_file(text, overrides, directory).scene;
}

/// Returns the message of the SceneError that parsing throws, or "no error".
inline std::string error_of(const std::string& text, const Overrides& overrides = {},
                            const std::filesystem::path& directory = {}) {
  try {
    parse(text, overrides, directory);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

/// A folder for the files of one test, which is removed at the end.
class Folder {
 public:
  Folder()
      : path_(std::filesystem::temp_directory_path() /
              ("stokesbook-" + boost::unit_test::framework::current_test_case().full_name())) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string at(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }

 private:
  std::filesystem::path path_;
};

/// Returns the error of a scene whose a.csv has the given lines, without the name of the folder.
inline std::string error_with_csv(const std::string& scene, const std::string& csv) {
  const Folder folder;
  folder.write("a.csv", csv);
  std::string message = error_of(scene, {}, folder.path());
  const std::string name = folder.at("");
  for (std::size_t at = 0; (at = message.find(name)) != std::string::npos;) {
    message.erase(at, name.size());
  }
  return message;
}

/// Returns a scene of one body, whose shape is on line 2.
inline std::string body_with_shape(const std::string& shape) {
  return "[[bodies]]\nshape = " + shape + "\nn_nodes = 32\n";
}

/// Returns a scene of one disk; the given lines begin with line 3.
inline std::string disk(const std::string& lines = "n_nodes = 32\n") {
  return "[[bodies]]\nshape = { kind = 'circle', radius = 0.5 }\n" + lines;
}

/// Returns a scene of an enclosing circle, in 4 lines.
inline std::string tank() {
  return "[[walls]]\nrole = 'outer'\nshape = { kind = 'circle', radius = 9 }\nn_nodes = 64\n";
}

}  // namespace stokesbook::test
