#include "record/vtk.hpp"

#include <algorithm>

#include "record/number_text.hpp"

namespace stokesbook {

namespace {

/// A closed curve with its data.
struct Cell {
  long id;
  bool encloses;
  ComplexVector points;
  BodyState state;
};

/// Lists walls and bodies as VTK orders cells: lines before polygons.
std::vector<Cell> list_cells(const Frame& frame, const std::vector<Outline>& bodies,
                             const std::vector<Outline>& walls) {
  std::vector<Cell> cells;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const BodyState& body = frame.bodies[k];
    cells.push_back({static_cast<long>(k), bodies[k].encloses,
                     placed(bodies[k], body.position, body.orientation), body});
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const WallLoad& wall = frame.walls[k];
    cells.push_back({-1 - static_cast<long>(k),
                     walls[k].encloses,
                     placed(walls[k], wall.position, wall.orientation),
                     {wall.position, wall.orientation, {}, 0.0, wall.force, wall.torque}});
  }
  std::stable_partition(cells.begin(), cells.end(), [](const Cell& cell) { return cell.encloses; });
  return cells;
}

std::string data_array(const std::string& type, const std::string& name, int components,
                       const std::string& values) {
  return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
         std::to_string(components) + "\" format=\"ascii\">\n" + values + "</DataArray>\n";
}

void append_line(std::string& text, auto value) {
  append_number(text, value);
  text += '\n';
}

/// A plane vector becomes a space vector.
void append_line(std::string& text, Complex value) {
  append_number(text, value.real());
  text += ' ';
  append_number(text, value.imag());
  text += " 0\n";
}

std::string ids(const std::vector<Cell>& cells) {
  std::string values;
  for (const Cell& cell : cells) append_line(values, cell.id);
  return data_array("Int64", "id", 1, values);
}

std::string scalars(const std::string& name, const std::vector<Cell>& cells,
                    double BodyState::*member) {
  std::string values;
  for (const Cell& cell : cells) append_line(values, cell.state.*member);
  return data_array("Float64", name, 1, values);
}

std::string vectors(const std::string& name, const std::vector<Cell>& cells,
                    Complex BodyState::*member) {
  std::string values;
  for (const Cell& cell : cells) append_line(values, cell.state.*member);
  return data_array("Float64", name, 3, values);
}

std::string points(const std::vector<Cell>& cells) {
  std::string values;
  for (const Cell& cell : cells) {
    for (const Complex point : cell.points) append_line(values, point);
  }
  return data_array("Float64", "points", 3, values);
}

/// Lists the points of the cells that are closed polylines (true) or polygons (false).
std::string topology(const std::vector<Cell>& cells, bool polylines) {
  std::string connectivity;
  std::string offsets;
  Eigen::Index first = 0;
  Eigen::Index offset = 0;
  for (const Cell& cell : cells) {
    const Eigen::Index next = first + cell.points.size();
    if (cell.encloses == polylines) {
      for (Eigen::Index k = first; k < next; ++k) append_line(connectivity, k);
      if (polylines) append_line(connectivity, first);
      offset += cell.points.size() + (polylines ? 1 : 0);
      append_line(offsets, offset);
    }
    first = next;
  }
  return data_array("Int64", "connectivity", 1, connectivity) +
         data_array("Int64", "offsets", 1, offsets);
}

/// Returns the opening tag of the piece with its counts.
std::string piece(const std::vector<Cell>& cells) {
  Eigen::Index n_points = 0;
  for (const Cell& cell : cells) n_points += cell.points.size();
  const auto n_lines = std::ranges::count(cells, true, &Cell::encloses);
  const auto n_polygons = std::ranges::count(cells, false, &Cell::encloses);
  return "<Piece NumberOfPoints=\"" + std::to_string(n_points) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(n_lines) +
         "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(n_polygons) + "\">\n";
}

}  // namespace

std::string configuration_vtp(const Frame& frame, const std::vector<Outline>& bodies,
                              const std::vector<Outline>& walls) {
  require_outlines(frame, bodies, walls);
  const std::vector<Cell> cells = list_cells(frame, bodies, walls);
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n" +
         piece(cells) + "<CellData Scalars=\"id\" Vectors=\"velocity\">\n" + ids(cells) +
         vectors("velocity", cells, &BodyState::velocity) +
         scalars("omega", cells, &BodyState::omega) +
         scalars("theta", cells, &BodyState::orientation) +
         vectors("force", cells, &BodyState::force) + scalars("torque", cells, &BodyState::torque) +
         "</CellData>\n<Points>\n" + points(cells) + "</Points>\n<Lines>\n" +
         topology(cells, true) + "</Lines>\n<Polys>\n" + topology(cells, false) +
         "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace stokesbook
