// Names the files of single frames, and writes the ParaView collections that list them.
#include "record/frame_files.hpp"

#include <algorithm>
#include <charconv>

#include "text/number_text.hpp"

namespace stokesbook {

std::string FrameFiles::name(std::size_t frame) const {
  const std::string digits = std::to_string(frame);
  std::string text(stem);
  text += '_' + std::string(6 - std::min<std::size_t>(6, digits.size()), '0') + digits;
  return text += extension;
}

std::optional<std::size_t> FrameFiles::frame_of(const std::string& file) const {
  std::size_t frame = 0;
  const std::size_t digits = file.find_first_of("0123456789");
  if (digits == std::string::npos) return {};
  std::from_chars(file.data() + digits, file.data() + file.size(), frame);
  if (file != name(frame)) return {};
  return frame;
}

std::string FrameFiles::collection() const {
  return std::string(stem) + ".pvd";
}

std::string FrameFiles::collection_text(std::span<const double> frame_times) const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (std::size_t k = 0; k < frame_times.size(); ++k) {
    text += "<DataSet timestep=\"";
    append_number(text, frame_times[k]);
    text += "\" file=\"" + name(k) + "\"/>\n";
  }
  return text + "</Collection>\n</VTKFile>\n";
}

}  // namespace stokesbook
