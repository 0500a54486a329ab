#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// Files of which there is one a frame, and the collection that ties them to their times.
struct FrameFiles {
  std::string_view stem;       ///< how their names start
  std::string_view extension;  ///< how their names end

  /// Names the file of a frame.
  /// @param  frame  its number, from 0
  /// @return        `bodies_000042.vtp`; more digits where six do not do
  std::string name(std::size_t frame) const;

  /// Reads the number of the frame from the name of its file.
  /// @param  file  name of any file
  /// @return       number, or nothing for other names
  std::optional<std::size_t> frame_of(const std::string& file) const;

  /// Names the collection.
  /// @return `bodies.pvd`
  std::string collection() const;

  /// Ties the files of all frames to their times, as a ParaView collection.
  /// @param  frame_times  one a frame, from the first
  /// @return              text of the collection
  std::string collection_text(std::span<const double> frame_times) const;
};

/// Polygons of the bodies and walls, by configuration_vtp().
inline constexpr FrameFiles body_files{"bodies", ".vtp"};
/// The network of contacts, by contacts_vtp().
inline constexpr FrameFiles contact_files{"contacts", ".vtp"};
/// Fields on a grid, by field_vti().
inline constexpr FrameFiles field_files{"fields", ".vti"};

/// @}

}  // namespace stokesbook
