// The reader of scenes and that of tables of numbers take any bytes: what they cannot use ends in a
// SceneError. libFuzzer draws the bytes, and sanitizers watch.

#include <cstdint>
#include <string_view>

#include "scene/csv_table.hpp"
#include "scene/error.hpp"
#include "scene/parse.hpp"
#include "scene/write.hpp"

namespace {

template <class Read>
void refuse_or_read(const Read& read) {
  try {
    read();
  } catch (const stokesbook::SceneError&) {
    // Where, what and what would be right.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace stokesbook;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  refuse_or_read([&] {
    scene_text::parse_csv(text, "bodies.csv", {"x,y", "x,y,theta", "cx,cy,semi_a,semi_b,theta"});
  });
  // A scene that could be read is written, and reads as the same.
  refuse_or_read([&] {
    const SceneFile file = parse_scene(text, "scene.toml", "nowhere");
    if (parse_scene(to_toml(file), "written.toml", "nowhere") != file) __builtin_trap();
  });
  return 0;
}
