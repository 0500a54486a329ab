// Writes configurations and contacts for ParaView: VTK PolyData as XML, with arrays in ASCII.
#include "record/vtk.hpp"

#include <algorithm>
#include <concepts>

#include "text/number_text.hpp"

namespace stokesbook {

namespace {

/// The way in which the points of a cell are joined.
enum class Joined { in_line, in_loop, in_polygon };

struct Cell {
  Joined joined;
  ComplexVector points;
};

/// The cell of a wall or body.
struct Component : Cell, BodyState {
  long id;
};

/// The cell of a contact: a line from the centre of a through the contact point to the centre of b.
struct Link : Cell {
  long a, b;
  Complex normal;
  double force, gap;
};

bool is_line(const Cell& cell) {
  return cell.joined != Joined::in_polygon;
}

long id_of(const ContactParty& party) {
  const long number = static_cast<long>(party.number);
  return party.is_wall ? -1 - number : number;
}

/// Lists walls and bodies in VTK's order of cells, lines before polygons.
std::vector<Component> list_components(const Frame& frame, const std::vector<Outline>& bodies,
                                       const std::vector<Outline>& walls) {
  std::vector<Component> components;
  const auto add = [&](const Outline& outline, const BodyState& state, long id) {
    const Joined joined = outline.encloses ? Joined::in_loop : Joined::in_polygon;
    components.push_back({{joined, placed(outline, state.position, state.orientation)}, state, id});
  };
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    add(bodies[k], frame.bodies[k], id_of({.is_wall = false, .number = k}));
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const auto& [position, orientation, force, torque] = frame.walls[k];
    add(walls[k], {position, orientation, {}, 0.0, force, torque},
        id_of({.is_wall = true, .number = k}));
  }
  std::stable_partition(components.begin(), components.end(), is_line);
  return components;
}

std::vector<Link> list_links(const Frame& frame) {
  std::vector<Link> links;
  for (const ContactForce& contact : frame.contacts) {
    // A line to the centre of a wall would cross other bodies; it ends at the contact instead.
    const auto end = [&](const ContactParty& party) {
      return party.is_wall ? contact.point : frame.bodies[party.number].position;
    };
    links.push_back(
        {{Joined::in_line, ComplexVector{{end(contact.a), contact.point, end(contact.b)}}},
         id_of(contact.a),
         id_of(contact.b),
         contact.normal,
         contact.force,
         contact.gap});
  }
  return links;
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

/// Appends a plane vector as a space vector whose third component is 0.
void append_line(std::string& text, Complex value) {
  append_number(text, value.real());
  text += ' ';
  append_number(text, value.imag());
  text += " 0\n";
}

/// Writes one member of all cells as a data array.
template <class Kind, class Base, class Value>
std::string cell_data(const std::string& name, const std::vector<Kind>& cells,
                      Value Base::*member) {
  std::string values;
  for (const Kind& cell : cells) append_line(values, cell.*member);
  return data_array(std::integral<Value> ? "Int64" : "Float64", name,
                    std::same_as<Value, Complex> ? 3 : 1, values);
}

template <class Kind>
std::string points(const std::vector<Kind>& cells) {
  std::string values;
  for (const Cell& cell : cells) {
    for (const Complex point : cell.points) append_line(values, point);
  }
  return data_array("Float64", "points", 3, values);
}

/// Writes the point numbers of all lines, or of all polygons, as VTK's connectivity and offsets.
template <class Kind>
std::string topology(const std::vector<Kind>& cells, bool lines) {
  std::string connectivity;
  std::string offsets;
  Eigen::Index first = 0;
  Eigen::Index offset = 0;
  for (const Cell& cell : cells) {
    const Eigen::Index next = first + cell.points.size();
    if (is_line(cell) == lines) {
      const bool closed = cell.joined == Joined::in_loop;
      for (Eigen::Index k = first; k < next; ++k) append_line(connectivity, k);
      if (closed) append_line(connectivity, first);
      offset += cell.points.size() + (closed ? 1 : 0);
      append_line(offsets, offset);
    }
    first = next;
  }
  return data_array("Int64", "connectivity", 1, connectivity) +
         data_array("Int64", "offsets", 1, offsets);
}

/// Returns the opening tag of the piece with its counts.
template <class Kind>
std::string piece(const std::vector<Kind>& cells) {
  Eigen::Index n_points = 0;
  for (const Cell& cell : cells) n_points += cell.points.size();
  const auto n_lines = std::ranges::count_if(cells, is_line);
  const auto n_polygons = std::ssize(cells) - n_lines;
  return "<Piece NumberOfPoints=\"" + std::to_string(n_points) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"" + std::to_string(n_lines) +
         "\" NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(n_polygons) + "\">\n";
}

/// Writes cells, lines before polygons, with their data.
template <class Kind>
std::string poly_data(const std::vector<Kind>& cells, const std::string& data) {
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\">\n<PolyData>\n" +
         piece(cells) + data + "<Points>\n" + points(cells) + "</Points>\n<Lines>\n" +
         topology(cells, true) + "</Lines>\n<Polys>\n" + topology(cells, false) +
         "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

std::string configuration_vtp(const Frame& frame, const std::vector<Outline>& bodies,
                              const std::vector<Outline>& walls) {
  require_outlines(frame, bodies, walls);
  const std::vector<Component> cells = list_components(frame, bodies, walls);
  return poly_data(cells, "<CellData Scalars=\"id\" Vectors=\"velocity\">\n" +
                              cell_data("id", cells, &Component::id) +
                              cell_data("velocity", cells, &BodyState::velocity) +
                              cell_data("omega", cells, &BodyState::omega) +
                              cell_data("theta", cells, &BodyState::orientation) +
                              cell_data("force", cells, &BodyState::force) +
                              cell_data("torque", cells, &BodyState::torque) + "</CellData>\n");
}

std::string contacts_vtp(const Frame& frame) {
  const std::vector<Link> cells = list_links(frame);
  return poly_data(cells, "<CellData Scalars=\"force\" Vectors=\"normal\">\n" +
                              cell_data("a", cells, &Link::a) + cell_data("b", cells, &Link::b) +
                              cell_data("normal", cells, &Link::normal) +
                              cell_data("force", cells, &Link::force) +
                              cell_data("gap", cells, &Link::gap) + "</CellData>\n");
}

}  // namespace stokesbook
