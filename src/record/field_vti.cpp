// Writes a field of the flow for ParaView: VTK ImageData as XML, with arrays in base64.
#include "record/field_vti.hpp"

#include <bit>
#include <cstring>
#include <span>

#include "text/number_text.hpp"

namespace stokesbook {

namespace {

/// Encodes bytes in base64: 3 bytes become 4 letters of 6 bits each.
std::string base64(const std::string& bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t first = 0; first < bytes.size(); first += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - first);
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const char byte = k < count ? bytes[first + k] : '\0';
      triple = triple << 8 | static_cast<unsigned char>(byte);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? letters[triple >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

template <class T>
std::string data_array(const std::string& type, std::string_view name, int components,
                       std::span<const T> values) {
  // VTK requires the number of bytes before the bytes.
  const std::uint64_t size = values.size_bytes();
  std::string bytes(sizeof(size) + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof(size));
  std::memcpy(bytes.data() + sizeof(size), values.data(), size);
  return "<DataArray type=\"" + type + "\" Name=\"" + std::string(name) +
         "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"binary\">\n" +
         base64(bytes) + "\n</DataArray>\n";
}

std::span<const double> numbers(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Writes plane vectors as space vectors whose third component is 0.
std::string vectors(std::string_view name, const ComplexVector& values) {
  Eigen::Matrix3Xd spatial = Eigen::Matrix3Xd::Zero(3, values.size());
  spatial.row(0) = values.real();
  spatial.row(1) = values.imag();
  return data_array("Float64", name, 3, numbers(spatial.reshaped()));
}

/// Returns the attributes of the grid: extent, origin and spacing.
std::string image_attributes(const FieldGrid& grid) {
  std::string text = "WholeExtent=\"0 " + std::to_string(grid.columns - 1) + " 0 " +
                     std::to_string(grid.rows - 1) + " 0 0\" Origin=\"";
  append_number(text, grid.corner.real());
  text += ' ';
  append_number(text, grid.corner.imag());
  text += " 0\" Spacing=\"";
  append_number(text, grid.spacing);
  text += ' ';
  append_number(text, grid.spacing);
  return text + " 1\"";
}

}  // namespace

std::string field_vti(const Field& field) {
  const FieldGrid& grid = field.grid;
  const bool little = std::endian::native == std::endian::little;
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" ";
  text += "byte_order=\"" + std::string(little ? "LittleEndian" : "BigEndian") + "\" ";
  text += "header_type=\"UInt64\">\n<ImageData " + image_attributes(grid) + ">\n<Piece Extent=\"0 ";
  text += std::to_string(grid.columns - 1) + " 0 " + std::to_string(grid.rows - 1);
  text += " 0 0\">\n<PointData>\n";
  text += data_array("UInt8", "in_fluid", 1, std::span<const std::uint8_t>(field.in_fluid));
  if (field.velocity.size() > 0) text += vectors("velocity", field.velocity);
  for (const auto& [name, values, has_sign] : field_scalars) {
    if ((field.*values).size() > 0) text += data_array("Float64", name, 1, numbers(field.*values));
  }
  return text + "</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
}

}  // namespace stokesbook
