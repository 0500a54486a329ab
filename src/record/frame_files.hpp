#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A kind of file that a run writes for each frame, and the collection that lists files and times.
struct FrameFiles {
  std::string_view stem;       ///< start of their names
  std::string_view extension;  ///< end of their names

  /// Returns the file name of a frame.
  /// @param  frame  number of the frame, from 0
  /// @return        `bodies_000042.vtp`; more digits if six do not suffice
  std::string name(std::size_t frame) const;

  /// Returns the number of a frame, read from its file name.
  /// @param  file  name of any file
  /// @return       the number; none for other names
  std::optional<std::size_t> frame_of(const std::string& file) const;

  /// Returns the file name of the collection.
  /// @return `bodies.pvd`
  std::string collection() const;

  /// Writes a ParaView collection that lists the files of all frames with their times.
  /// @param  frame_times  times of all frames, from the first
  /// @return              text of the collection
  std::string collection_text(std::span<const double> frame_times) const;
};

/// Files with polygons of the bodies and walls, by configuration_vtp().
inline constexpr FrameFiles body_files{"bodies", ".vtp"};
/// Files with the network of contacts, by contacts_vtp().
inline constexpr FrameFiles contact_files{"contacts", ".vtp"};
/// Files with fields on a grid, by field_vti().
inline constexpr FrameFiles field_files{"fields", ".vti"};

/// @}

}  // namespace stokesbook
