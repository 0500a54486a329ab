// Feeds any bytes to the parsers of scenes and of tables of numbers: input that they cannot use
// must end in a SceneError. libFuzzer generates the bytes, and sanitizers detect errors.

#include <cstdint>
#include <string_view>

#include "scene/csv_table.hpp"
#include "scene/parse.hpp"
#include "scene/write.hpp"

namespace {

template <class Read>
void refuse_or_read(const Read& read) {
  try {
    read();
  } catch (const stokesbook::SceneError&) {
    // A SceneError is the expected refusal: it names the place, the error and the accepted values.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stokesbook;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  refuse_or_read([&] {
    scene_text::parse_csv(text, "bodies.csv",
                          {"x,y", [](const auto& columns) { return columns.size() > 1; }});
  });
  // A scene that was read must be the same after writing and reading.
  refuse_or_read([&] {
    const SceneFile file = parse_scene(text, "scene.toml", "nowhere");
    if (parse_scene(to_toml(file), "written.toml", "nowhere") != file) __builtin_trap();
  });
  return 0;
}
