#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "record/run_data.hpp"

namespace stokesbook {

/// Writes a configuration as VTK PolyData (XML, ASCII), with one cell for each wall and body.
///
/// Enclosing walls are closed polylines and come first, since VTK orders lines before polygons.
/// Each body and inner wall is a polygon, which may be concave. Cell data: `id` as in
/// ContactParty::id(), `velocity` and `omega` (0 for walls), `theta`, `force` and `torque` (by the
/// body or wall on the fluid).
/// @throws std::invalid_argument when outlines and frame do not match
std::string configuration_vtp(const Frame& frame, const Outlines& outlines);

/// Writes the network of contacts as VTK PolyData (XML, ASCII), with one polyline for each contact.
///
/// A line goes from the centre of a through the contact point to the centre of b; the end at a wall
/// is the contact point itself. Cell data: `a` and `b` (ContactParty::id()), `normal`, `force` and
/// `gap` as in ContactForce. All bodies in contact must be in the frame.
std::string contacts_vtp(const Frame& frame);

/// Writes the tracers as VTK PolyData (XML, ASCII), with one vertex for each. Cell data: `id`, the
/// number of the tracer as in tracers.csv.
std::string tracers_vtp(const Frame& frame);

/// Writes a field as VTK ImageData (XML, data in base64), about 11 bytes for each double.
///
/// Point data: `in_fluid`, 0 or 1; `velocity`, whose third component is 0; and the scalars, by
/// their names in field_scalars. All arrays but the first hold the exact doubles.
std::string field_vti(const Field& field);

/// A kind of file that a run writes for each frame, and the ParaView collection of these files.
struct FrameFiles {
  std::string_view stem;       ///< start of the files' names
  std::string_view extension;  ///< end of the files' names

  /// Returns the file name of a frame, `bodies_000042.vtp`; more digits if six do not suffice.
  std::string name(std::size_t frame) const;

  /// Returns the number of a frame, read from its file name; none for other names.
  std::optional<std::size_t> frame_of(const std::string& file) const;

  /// Returns the file name of the collection, `bodies.pvd`.
  std::string collection() const { return std::string(stem) + ".pvd"; }

  /// Writes a collection that lists the files of all frames, from the first, with their times.
  /// @param  frame_times  times of all frames of the run
  /// @param  first        the first frame that has a file
  std::string collection_text(std::span<const double> frame_times, std::size_t first = 0) const;
};

/// Files with polygons of the bodies and walls, by configuration_vtp().
inline constexpr FrameFiles body_files{"bodies", ".vtp"};
/// Files with the network of contacts, by contacts_vtp().
inline constexpr FrameFiles contact_files{"contacts", ".vtp"};
/// Files with the tracers, by tracers_vtp().
inline constexpr FrameFiles tracer_files{"tracers", ".vtp"};
/// Files with fields on a grid, by field_vti().
inline constexpr FrameFiles field_files{"fields", ".vti"};

}  // namespace stokesbook
