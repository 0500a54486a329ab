// Writes configurations, contacts, tracers and fields for ParaView in VTK's XML formats, and
// collections that list these files with their times.
#include "record/vtk.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "text/number_text.hpp"

namespace stokesbook {

namespace {

/// Points, and the way in which they are joined.
struct Cell {
  ComplexVector points;
  enum { not_at_all, in_line, in_loop, in_polygon } joined;

  bool is_line() const { return joined == in_line || joined == in_loop; }

  /// Returns the name of VTK's list of such cells.
  std::string list() const {
    return is_line() ? "Lines" : joined == in_polygon ? "Polys" : "Verts";
  }
};

/// A wall or body.
struct Component : BodyState, Cell {
  long id;
};

using Attributes = std::vector<std::pair<std::string, std::string>>;

std::string element(const std::string& name, const Attributes& attributes,
                    const std::string& contents) {
  std::string text = '<' + name;
  for (const auto& [key, value] : attributes) text += ' ' + key + "=\"" + value + '"';
  return text + ">\n" + contents + "</" + name + ">\n";
}

std::string vtk_file(const Attributes& attributes, const std::string& contents) {
  return "<?xml version=\"1.0\"?>\n" + element("VTKFile", attributes, contents);
}

std::string data_array(const std::string& type, const std::string& name, int components,
                       const std::string& format, const std::string& values) {
  return element("DataArray",
                 {{"type", type},
                  {"Name", name},
                  {"NumberOfComponents", std::to_string(components)},
                  {"format", format}},
                 values);
}

/// Writes numbers with blanks between them.
std::string words(auto... numbers) {
  std::string text = ((exact_number(numbers) + ' ') + ...);
  text.pop_back();
  return text;
}

std::string line(auto number) {
  return words(number) + '\n';
}

/// Writes a plane vector as a space vector whose third component is 0.
std::string line(Complex vector) {
  return words(vector.real(), vector.imag(), 0) + '\n';
}

/// Writes one member of all items, or one value computed from each, as a data array.
std::string cell_data(const std::string& name, const auto& items, auto member) {
  using Value = std::decay_t<decltype(std::invoke(member, items.front()))>;
  std::string values;
  for (const auto& item : items) values += line(std::invoke(member, item));
  return data_array(std::integral<Value> ? "Int64" : "Float64", name,
                    std::same_as<Value, Complex> ? 3 : 1, "ascii", values);
}

/// Writes one of VTK's lists of cells: their point numbers as connectivity and offsets.
std::string topology(const auto& cells, const std::string& list) {
  std::string connectivity;
  std::string offsets;
  Eigen::Index first = 0;
  Eigen::Index offset = 0;
  for (const Cell& cell : cells) {
    const Eigen::Index next = first + cell.points.size();
    if (cell.list() == list) {
      const bool closed = cell.joined == Cell::in_loop;
      for (Eigen::Index k = first; k < next; ++k) connectivity += line(k);
      if (closed) connectivity += line(first);
      offset += cell.points.size() + (closed ? 1 : 0);
      offsets += line(offset);
    }
    first = next;
  }
  return element(list, {},
                 data_array("Int64", "connectivity", 1, "ascii", connectivity) +
                     data_array("Int64", "offsets", 1, "ascii", offsets));
}

/// Writes cells, lines before polygons, or single points, with their data, of which a viewer first
/// shows the named scalars and vectors.
std::string poly_data(const auto& cells, const std::string& scalars, const std::string& vectors,
                      const std::string& data) {
  std::string points;
  Eigen::Index n_points = 0;
  for (const Cell& cell : cells) {
    for (const Complex point : cell.points) points += line(point);
    n_points += cell.points.size();
  }
  const auto number_in = [&](const std::string& list) {
    return std::to_string(std::ranges::count(cells, list, &Cell::list));
  };
  const Attributes counts{{"NumberOfPoints", std::to_string(n_points)},
                          {"NumberOfVerts", number_in("Verts")},
                          {"NumberOfLines", number_in("Lines")},
                          {"NumberOfStrips", "0"},
                          {"NumberOfPolys", number_in("Polys")}};
  const std::string piece =
      element("CellData", {{"Scalars", scalars}, {"Vectors", vectors}}, data) +
      element("Points", {}, data_array("Float64", "points", 3, "ascii", points)) +
      (number_in("Verts") == "0" ? "" : topology(cells, "Verts")) + topology(cells, "Lines") +
      topology(cells, "Polys");
  return vtk_file({{"type", "PolyData"}, {"version", "1.0"}},
                  element("PolyData", {}, element("Piece", counts, piece)));
}

/// Encodes bytes in base64: a letter for every 6 bits, filled up to a multiple of 4 letters.
std::string base64(const std::string& bytes) {
  using namespace boost::archive::iterators;
  using Letters = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  std::string text(Letters(bytes.begin()), Letters(bytes.end()));
  return text.append((4 - text.size() % 4) % 4, '=');
}

/// Writes contiguous numbers as a binary data array.
std::string binary_array(const std::string& type, std::string_view name, int components,
                         const auto& numbers) {
  // VTK requires the number of bytes before the bytes.
  const std::uint64_t size = sizeof(*numbers.data()) * static_cast<std::size_t>(numbers.size());
  std::string bytes(reinterpret_cast<const char*>(&size), sizeof(size));
  bytes.append(reinterpret_cast<const char*>(numbers.data()), size);
  return data_array(type, std::string(name), components, "binary", base64(bytes) + '\n');
}

}  // namespace

std::string configuration_vtp(const Frame& frame, const Outlines& outlines) {
  require_outlines(frame, outlines);
  std::vector<Component> components;
  const auto add = [&](const Outline& outline, const BodyState& state, const ContactParty& party) {
    const Cell cell{placed(outline, state), outline.encloses ? Cell::in_loop : Cell::in_polygon};
    components.push_back({state, cell, party.id()});
  };
  for (std::size_t k = 0; k < frame.bodies.size(); ++k) {
    add(outlines.bodies[k], frame.bodies[k], {false, k});
  }
  for (std::size_t k = 0; k < frame.walls.size(); ++k) {
    const auto& [position, orientation, force, torque] = frame.walls[k];
    add(outlines.walls[k], {position, orientation, {}, 0.0, force, torque}, {true, k});
  }
  // VTK requires lines before polygons.
  std::stable_partition(components.begin(), components.end(), std::mem_fn(&Cell::is_line));
  const std::string data = cell_data("id", components, &Component::id) +
                           cell_data("velocity", components, &Component::velocity) +
                           cell_data("omega", components, &Component::omega) +
                           cell_data("theta", components, &Component::orientation) +
                           cell_data("force", components, &Component::force) +
                           cell_data("torque", components, &Component::torque);
  return poly_data(components, "id", "velocity", data);
}

std::string contacts_vtp(const Frame& frame) {
  const std::vector<ContactForce>& contacts = frame.contacts;
  std::vector<Cell> cells;
  for (const ContactForce& contact : contacts) {
    // A line to the centre of a wall would cross other bodies; it ends at the contact instead.
    const auto [a, b] = contact_ends(frame, contact);
    cells.push_back({ComplexVector{{a, contact.point, b}}, Cell::in_line});
  }
  const auto id_a = [](const ContactForce& contact) { return contact.a.id(); };
  const auto id_b = [](const ContactForce& contact) { return contact.b.id(); };
  const std::string data = cell_data("a", contacts, id_a) + cell_data("b", contacts, id_b) +
                           cell_data("normal", contacts, &ContactForce::normal) +
                           cell_data("force", contacts, &ContactForce::force) +
                           cell_data("gap", contacts, &ContactForce::gap);
  return poly_data(cells, "force", "normal", data);
}

std::string tracers_vtp(const Frame& frame) {
  std::vector<Cell> cells;
  std::vector<std::size_t> numbers;
  for (const Complex tracer : frame.tracers) {
    numbers.push_back(cells.size());
    cells.push_back({ComplexVector{{tracer}}, Cell::not_at_all});
  }
  return poly_data(cells, "id", "", cell_data("id", numbers, std::identity{}));
}

std::string field_vti(const Field& field) {
  const auto& [corner, spacing, columns, rows] = field.grid;
  const std::string extent = words(0, columns - 1, 0, rows - 1, 0, 0);
  const Attributes grid{{"WholeExtent", extent},
                        {"Origin", words(corner.real(), corner.imag(), 0)},
                        {"Spacing", words(spacing, spacing, 1)}};
  std::string arrays = binary_array("UInt8", "in_fluid", 1, field.in_fluid);
  if (field.velocity.size() > 0) {
    Eigen::Matrix3Xd spatial = Eigen::Matrix3Xd::Zero(3, field.velocity.size());
    spatial.row(0) = field.velocity.real();
    spatial.row(1) = field.velocity.imag();
    arrays += binary_array("Float64", "velocity", 3, spatial);
  }
  for (const auto& [name, values, has_sign] : field_scalars) {
    if ((field.*values).size() > 0) arrays += binary_array("Float64", name, 1, field.*values);
  }
  constexpr bool little = std::endian::native == std::endian::little;
  const std::string piece =
      element("Piece", {{"Extent", extent}}, element("PointData", {}, arrays));
  return vtk_file({{"type", "ImageData"},
                   {"version", "1.0"},
                   {"byte_order", little ? "LittleEndian" : "BigEndian"},
                   {"header_type", "UInt64"}},
                  element("ImageData", grid, piece));
}

std::string FrameFiles::name(std::size_t frame) const {
  return std::string(stem) + '_' + padded_number(frame, 6) + std::string(extension);
}

std::optional<std::size_t> FrameFiles::frame_of(const std::string& file) const {
  std::size_t frame = 0;
  const std::size_t digits = std::min(file.find_first_of("0123456789"), file.size());
  std::from_chars(file.data() + digits, file.data() + file.size(), frame);
  return file == name(frame) ? std::optional(frame) : std::nullopt;
}

std::string FrameFiles::collection_text(std::span<const double> frame_times,
                                        std::size_t first) const {
  std::string entries;
  for (std::size_t k = first; k < frame_times.size(); ++k) {
    entries += "<DataSet timestep=\"" + words(frame_times[k]) + "\" file=\"" + name(k) + "\"/>\n";
  }
  return vtk_file({{"type", "Collection"}, {"version", "1.0"}}, element("Collection", {}, entries));
}

}  // namespace stokesbook
