// Chapter 10: two circles that pass through each other unless the way is searched; a disk in a
// valley; one impact for three observers; Newton's method with two kinds of rows.
//
//   chapter_10 [DIRECTORY]    prints tables; draws chapter_10_space_time.svg and
//                             chapter_10_swept.svg into the directory
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "stiv/absolute_volume.hpp"
#include "stiv/interferences.hpp"
#include "stiv/polygon_gaps.hpp"

using namespace stokesbook;
using std::numbers::pi;

namespace {

// [body]
constexpr double separation = 0.1, tolerance = 1e-4, allowed_intrusion = 0.0;

std::shared_ptr<const ContactShape> body(const Shape& shape) {
  return std::make_shared<ContactShape>(
      contact_shape(shape, Side::fluid_outside, 0.01 * separation));
}

const ContactRules rules{{separation}, tolerance, RowChoice::deepest, allowed_intrusion};
// [body]

RigidPath moving(Complex start, Complex displacement, double rotation = 0.0) {
  return {{start, 0.0}, displacement, rotation};
}

// [tunnelling]
/// Two unit circles with a gap of .8, each of which goes half of a way towards the other.
void print_tunnelling() {
  const ContactShapes circles{body(Circle{1.0}), body(Circle{1.0})};
  std::puts("Two circles that come together: what the end of the step tells, and the way to it\n");
  std::puts("  travel   distance at the end   contact at   gap of the row");
  for (const double travel : {0.6, 1.0, 3.0, 6.0, 60.0}) {
    const std::vector<RigidPath> paths{moving(-1.4, 0.5 * travel), moving(1.4, -0.5 * travel)};
    const PolygonGap at_end =
        polygon_gaps(circles, {paths[0].at(1.0), paths[1].at(1.0)}, 1e3).front();
    const Interferences found = interferences(circles, paths, rules);
    std::printf("%8.1f%22.3f", travel, at_end.gap);
    if (found.admits_step()) {
      std::puts("            -                -");
    } else {
      const ContactRow& row = found.contacts.front().rows.front();
      std::printf("%13.4f%17.4f\n", row.time, row.gap);
    }
  }
}
// [tunnelling]

// [valley]
void print_valley() {
  const ContactShapes shapes{body(Star{1.0, 0.45, 3}), body(Circle{0.45})};
  const Complex axis = std::polar(1.0, pi / 3.0);
  const std::vector<RigidPath> paths{moving(0.0, 0.0), moving(1.8 * axis, -0.62 * axis)};
  std::puts("\nA disk that is pressed into the valley of a star\n");
  std::puts("  contact     volume      gap   first contact   normal, degrees from the axis");
  int number = 0;
  for (const Contact& contact : interferences(shapes, paths, rules).contacts) {
    ++number;
    if (!contact.is_violated()) continue;
    for (const ContactRow& row : contact.rows) {
      const double angle = std::arg(-row.normal / axis) * 180.0 / pi;
      std::printf("%9d%11.5f%9.4f%16.4f%15.1f\n", number, contact.volume, row.gap, row.time, angle);
    }
  }
}
// [valley]

// [observers]
/// Circle a comes nearer to b by .4, whoever looks.
void print_observers() {
  const ContactShapes circles{body(Circle{1.0}), body(Circle{1.0})};
  std::puts("\nOne impact for three observers: volumes, and their forces along x on A and on B\n");
  std::puts(
      "  velocities of A, B         relative: V    on A    on B     absolute: V    on A    on B");
  for (const double b : {-0.2, 0.0, 0.4}) {
    const PathPair paths{0, 1, moving(0.0, b + 0.4), moving({2.2, 0.2}, b)};
    const PairEvents events =
        pair_events(circles, paths, {separation, tolerance, 0.4, allowed_intrusion});
    const Contact contact = connected_contacts(events, tolerance, RowChoice::aggregate).front();
    const PairWrench& force = contact.rows.front().force;
    const AbsoluteVolume absolute = absolute_volume(events, tolerance);
    std::printf("%12.1f%6.1f%24.4f%8.2f%8.2f%17.4f%8.2f%8.2f\n", b + 0.4, b, contact.volume,
                force.on_a.force.real(), force.on_b.force.real(), absolute.volume,
                absolute.force.on_a.force.real(), absolute.force.on_b.force.real());
  }
}
// [observers]

// [newton]
/// The gaps of a disk that is moved out of a fixed ellipse along the row's normal, by iterations.
std::vector<double> corrected(RowChoice choice, int iterations) {
  const ContactShapes shapes{std::make_shared<ContactShape>(contact_shape(
                                 sample(Ellipse{2.0, 1.0}, 8192, Side::fluid_outside))),
                             std::make_shared<ContactShape>(
                                 contact_shape(sample(Circle{1.0}, 8192, Side::fluid_outside)))};
  Complex displacement{0.8, -0.42};
  std::vector<double> gaps;
  for (int k = 0; k <= iterations; ++k) {
    const std::vector<RigidPath> paths{moving(0.0, 0.0), moving({0.0, 2.4}, displacement)};
    const auto rows = [&](RowChoice of) {
      return interferences(shapes, paths, {{separation}, 1e-12, of}).contacts.front().rows;
    };
    gaps.push_back(rows(RowChoice::deepest).front().gap);
    const ContactRow row = rows(choice).front();
    const Complex slope = row.derivative.on_b.force;
    displacement -= row.gap * slope / std::norm(slope);
  }
  return gaps;
}
// [newton]

void print_newton() {
  constexpr int iterations = 5;
  const std::vector<double> deepest = corrected(RowChoice::deepest, iterations),
                            volume = corrected(RowChoice::aggregate, iterations);
  std::puts("\nA disk that is moved out of an ellipse by Newton's method: the gap that is left\n");
  std::puts("  iteration   deepest vertex       volume");
  for (std::size_t k = 0; k <= iterations; ++k) {
    std::printf("%11zu%17.1e%13.1e\n", k, deepest[k], volume[k]);
  }
}

/// @name The pictures
/// @{
std::string filled(const std::string& colour, double opacity) {
  return "stroke=\"none\" fill=\"" + colour + "\"" + svg::attribute("fill-opacity", opacity);
}

std::string stroke(const std::string& colour, double width) {
  return "fill=\"none\" stroke-linecap=\"round\" stroke=\"" + colour + "\"" +
         svg::attribute("stroke-width", width);
}

constexpr const char *blue = "#1c7ed6", *orange = "#e8710a", *red = "#e03131";

/// Where the line of centres meets two circles of radius 1 in the course of a step, time upward.
std::string diagram(double left, double velocity_a, double velocity_b, const std::string& text) {
  const ContactShapes circles{body(Circle{1.0}), body(Circle{1.0})};
  const RigidPath a = moving(-1.5, velocity_a), b = moving(1.5, velocity_b);
  const double time = interferences(circles, {a, b}, rules).contacts.front().rows.front().time;
  const auto pixel = [&](double x, double tau) {
    return Complex{left + 34.0 * x, 250.0 - 190.0 * tau};
  };
  const auto band = [&](const RigidPath& path) {
    const double from = path.start.position.real(), to = path.at(1.0).position.real();
    return svg::polygon(ComplexVector{{pixel(from - 1.0, 0.0), pixel(from + 1.0, 0.0),
                                       pixel(to + 1.0, 1.0), pixel(to - 1.0, 1.0)}});
  };
  const auto front_of_a = [&](double tau) { return a.at(tau).position.real() + 1.0 + separation; };
  const auto front_of_b = [&](double tau) { return b.at(tau).position.real() - 1.0; };
  const ComplexVector interference = ComplexVector{
      {pixel(front_of_b(time), time), pixel(front_of_a(1.0), 1.0), pixel(front_of_b(1.0), 1.0)}};
  const Complex start = pixel(front_of_b(time), time);
  return svg::path(band(a), filled(blue, 0.35)) + svg::path(band(b), filled(orange, 0.35)) +
         svg::path(svg::polygon(interference), filled(red, 0.8)) +
         svg::path(svg::line(start, start), stroke("currentColor", 6.0)) +
         svg::path(svg::line({left - 108.0, 250.0}, {left + 108.0, 250.0}),
                   stroke("currentColor", 1.0)) +
         svg::label({left, 280.0}, text, "text-anchor=\"middle\"");
}

std::string picture_of_space_time() {
  return svg::open({760.0, 300.0}, "Two circles in space and time, for three observers") +
         diagram(125.0, 1.0, -1.0, "both move") + diagram(355.0, 2.0, 0.0, "B at rest") +
         diagram(585.0, 3.0, 1.0, "A chases B") +
         svg::label({20.0, 24.0},
                    "time upward; blue: A, orange: B, dot: first contact, red: the "
                    "interference") +
         "</svg>\n";
}

/// Places of the vertices that end too deep, in the frame of the body that they enter: where they
/// touched first, and where they would end.
struct Swept {
  std::vector<Eigen::Index> vertices;
  std::vector<Complex> touched, ended, normals;
};

Swept swept(const ContactShapes& shapes, const PathPair& paths) {
  const PairEvents pair =
      pair_events(shapes, paths, {separation, tolerance, 4.0 * separation, allowed_intrusion});
  const RelativePath path(paths.path_a, paths.path_b);
  Swept swept;
  for (const VertexEvent& event : pair.events_a) {
    if (event.gap >= -tolerance) continue;
    const Complex x = shapes[paths.a]->polygon.vertex(event.vertex);
    swept.vertices.push_back(event.vertex);
    swept.touched.push_back(path.at(event.time)(x));
    swept.ended.push_back(path.end()(x));
    swept.normals.push_back(event.normal);
  }
  return swept;
}

std::string picture_of_swept_pair() {
  const auto coarse = [](const Shape& shape) {
    return std::make_shared<ContactShape>(contact_shape(sample(shape, 96, Side::fluid_outside)));
  };
  const ContactShapes shapes{coarse(Ellipse{1.2, 0.5}), coarse(Star{1.1, 0.2, 5})};
  const PathPair paths{0, 1, moving({-2.3, 0.8}, {1.1, -0.5}, -0.7), moving({0.4, 0.0}, 0.0)};
  const auto pixel = [](Complex z) {
    return Complex{440.0 + 110.0 * z.real(), 190.0 - 110.0 * z.imag()};
  };
  const RelativePath path(paths.path_a, paths.path_b);
  const auto outline = [&](const ContactShape& shape, const RelativeFrame& frame) {
    ComplexVector points = shape.polygon.vertices();
    for (Complex& point : points) point = pixel(frame(point));
    return svg::polygon(points);
  };
  const RelativeFrame still{0.0, 1.0};
  std::string picture = svg::open({640.0, 390.0}, "An ellipse that enters a star in one step") +
                        svg::path(outline(*shapes[1], still), filled(orange, 0.35)) +
                        svg::path(outline(*shapes[0], path.start()), filled(blue, 0.2)) +
                        svg::path(outline(*shapes[0], path.end()), filled(blue, 0.35));
  const Swept found = swept(shapes, paths);
  std::string ways, normals;
  for (std::size_t k = 0; k < found.touched.size(); ++k) {
    ways += svg::line(pixel(found.touched[k]), pixel(found.ended[k]));
    normals +=
        svg::line(pixel(found.touched[k]), pixel(found.touched[k] + 0.12 * found.normals[k]));
  }
  picture += svg::path(ways, stroke(red, 2.0)) + svg::path(normals, stroke("currentColor", 1.0));
  std::string arrows;
  for (const Contact& contact :
       interferences(shapes, {paths.path_a, paths.path_b}, {{separation}, tolerance}).contacts) {
    for (const ContactRow& row : contact.rows) {
      const auto vertex = std::ranges::find(found.vertices, row.key.vertex);
      const bool is_of_b = row.key.vertex_of == paths.b;
      if (!is_of_b && vertex == found.vertices.end()) continue;  // near, and no violation
      const Complex foot =
          is_of_b ? shapes[1]->polygon.vertex(row.key.vertex)
                  : found.touched[static_cast<std::size_t>(vertex - found.vertices.begin())];
      arrows += svg::line(pixel(foot), pixel(foot + 0.45 * row.normal));
    }
  }
  return picture + svg::path(arrows, stroke("currentColor", 3.0)) +
         svg::label({20.0, 372.0},
                    "pale: start; red: ways of vertices from first contact to the "
                    "end; bold: normals of rows") +
         "</svg>\n";
}
/// @}

}  // namespace

int main(int argc, char** argv) {
  print_tunnelling();
  print_valley();
  print_observers();
  print_newton();
  if (argc > 1) {
    const std::filesystem::path directory = argv[1];
    write_atomically(directory / "chapter_10_space_time.svg", picture_of_space_time(),
                     SafeFrom::kill);
    write_atomically(directory / "chapter_10_swept.svg", picture_of_swept_pair(), SafeFrom::kill);
  }
}
