// Tests the files of frames with a periodic cell: tables list paths, and pictures show images.

#include <cmath>
#include <numbers>
#include <regex>

#include <boost/test/unit_test.hpp>

#include "folder.hpp"
#include "record/animation.hpp"
#include "record/picture.hpp"
#include "record/run_directory.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

const Complex a1{3.0, 0.0}, a2{7.0, 2.5}, centre{10.0, -4.0};

Outline disk(double radius) {
  Outline made{ComplexVector(40)};
  for (int k = 0; k < 40; ++k) made.points[k] = std::polar(radius, std::numbers::pi * k / 20.0);
  return made;
}

// Disks of which two touch through an edge of the cell; both have left it on their paths.
Frame frame_in_a_cell() {
  const Lattice lattice(a1, a2);
  Frame frame;
  const BodyState first{centre + Complex{1.3, 0.2}, 0.0, {0.3, 0.1}, 0.0, {}, 0.0},
      second{centre + Complex{-1.0, 0.2}, 0.0, {0.2, -0.1}, 0.0, {}, 0.0};
  const BodyState third{centre + Complex{0.2, 1.1}, 0.0, {0.1, 0.1}, 0.0, {}, 0.0};
  frame.bodies = {first, second, third};
  frame.bodies[0].position += 2.0 * a2 - a1;
  frame.bodies[1].position += 2.0 * a1 - 5.0 * a2;
  frame.bodies[1].velocity = {-12.3, -0.1};
  frame.contacts = {{{false, 0},
                     {false, 1},
                     centre + Complex{1.7, 0.2} + 2.0 * a2 - a1,
                     -1.0,
                     2.0,
                     0.0,
                     {-2, 7},
                     7.0 * a2 - 2.0 * a1}};
  frame.tracers = {centre + Complex{0.1, 0.9} - 3.0 * a1};
  frame.cell = FrameCell{lattice, centre, {first, second, third}};
  return frame;
}

Outlines outlines() {
  return {{disk(0.4), disk(0.3), disk(0.5)}, {}};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(cell_frames)

BOOST_AUTO_TEST_CASE(images_replace_paths) {
  const Frame frame = frame_in_a_cell(), images = in_cell(frame);
  BOOST_TEST(std::abs(images.bodies[1].position - (centre + Complex{-1.0, 0.2})) < 1e-15);
  BOOST_TEST((images.bodies[1].velocity == Complex{0.2, -0.1}));
  BOOST_TEST(std::abs(images.tracers[0] - (centre + Complex{0.1, 0.9})) < 1e-13);
  // The contact is next to the first body, as is the image of the second one.
  const ContactForce& contact = images.contacts[0];
  BOOST_TEST(std::abs(contact.point - (centre + Complex{1.7, 0.2})) < 1e-13);
  const auto [a, b] = contact_ends(images, contact);
  BOOST_TEST((a == images.bodies[0].position));
  BOOST_TEST(std::abs(b - (images.bodies[1].position + a1)) < 1e-13);
}

// A rod longer than the cell touches its own image and, at its tip, a disk. Other images of both
// bodies are nearer to these contacts than those that touch.
BOOST_AUTO_TEST_CASE(contacts_of_bodies_longer_than_the_cell) {
  const Complex right{1.0, 0.0}, up{0.0, 6.0}, tip{1.5, 1.5}, side{1.7, 1.2};
  const Complex rod_moved = 2.0 * right + up, disk_moved = -3.0 * right, beside{1.6, 1.6};
  const BodyState rod{0.0, 0.8, {}, 0.0, {}, 0.0}, disk{{-0.4, 1.6}, 0.0, {}, 0.0, {}, 0.0};
  Frame frame;
  frame.cell = FrameCell{Lattice(right, up), 0.0, {rod, disk}};
  frame.bodies = {rod, disk};
  frame.bodies[0].position += rod_moved;
  frame.bodies[1].position += disk_moved;
  const Complex shift = beside + rod_moved - frame.bodies[1].position;
  frame.contacts = {
      {{false, 0}, {false, 1}, tip + rod_moved, -1.0, 2.0, 0.0, {7, 1}, shift},
      {{false, 0}, {false, 0}, side + rod_moved, -1.0, 2.0, 0.0, {1, 0}, right},
  };
  const Frame images = in_cell(frame);
  const auto check = [&](const ContactForce& contact, Complex point, Complex a, Complex b) {
    const auto ends = contact_ends(images, contact);
    BOOST_TEST(std::abs(contact.point - point) < 1e-13);
    BOOST_TEST(std::abs(ends[0] - a) < 1e-13);
    BOOST_TEST(std::abs(ends[1] - b) < 1e-13);
  };
  check(images.contacts[0], tip, rod.position, beside);
  check(images.contacts[1], side, rod.position, rod.position + right);
}

BOOST_AUTO_TEST_CASE(tables_list_paths_and_polygons_are_images) {
  const Folder folder;
  const Frame frame = frame_in_a_cell(), images = in_cell(frame);
  RunContents contents = sample_contents();
  contents.outlines = outlines();
  contents.vtk = contents.svg = contents.html = contents.contacts = contents.tracers = true;
  contents.fields = contents.nodes = false;
  RunDirectory directory = RunDirectory::create(folder.at("run"), contents, ExistingRun::refuse);
  directory.write_frame(frame);
  directory.save({});
  const std::filesystem::path run = folder.at("run");
  // 10 - 1 + 2 * 3 - 5 * 7 and -4 + 0.2 - 5 * 2.5
  BOOST_TEST(contains(read(run / "trajectory.csv"), "\n0,1,-20,-16.3"));
  const auto holds = [&](const char* name, const std::string& text) {
    BOOST_TEST((read(run / name) == text), name);
  };
  holds("bodies_000000.vtp", configuration_vtp(images, contents.outlines));
  holds("contacts_000000.vtp", contacts_vtp(images));
  holds("tracers_000000.vtp", tracers_vtp(images));
  holds("configuration.svg", draw_configuration(images, contents.outlines, contents.title));
  const std::string page = read(run / "animation.html");
  BOOST_TEST(contains(page, ",[10,-4,3,0,7,2.5]]</script>"));
  BOOST_TEST(contains(page, ",[-20,-16.3,0,0.2,-0.1,0,0,0,0],"));
  BOOST_TEST(contains(page, ",[[0,1,22.7,1.2,2,0,-2,7]],"));
}

// The picture shows the bodies, the six corners of the cell, and the images that meet the rectangle
// about the corners.
BOOST_AUTO_TEST_CASE(pictures_show_the_edge_and_images) {
  const Frame images = in_cell(frame_in_a_cell());
  const auto corners = images.cell->lattice.voronoi_corners();
  double half_x = 0.0, half_y = 0.0;
  for (const Complex corner : corners) {
    half_x = std::max(half_x, corner.real());
    half_y = std::max(half_y, corner.imag());
  }
  long expected = 0;
  for (int i = -9; i <= 9; ++i) {
    for (int j = -9; j <= 9; ++j) {
      const Complex w = static_cast<double>(i) * a1 + static_cast<double>(j) * a2;
      for (const auto& [k, radius] : {std::pair{0, 0.4}, std::pair{1, 0.3}, std::pair{2, 0.5}}) {
        const Complex place = images.bodies[static_cast<std::size_t>(k)].position + w - centre;
        if (w != 0.0 && std::abs(place.real()) < half_x + radius &&
            std::abs(place.imag()) < half_y + radius) {
          ++expected;
        }
      }
    }
  }
  const std::string picture = draw_configuration(images, outlines(), "");
  const auto count = [&](const std::string& pattern) {
    const std::regex path(pattern);
    return std::distance(std::sregex_iterator(picture.begin(), picture.end(), path),
                         std::sregex_iterator());
  };
  BOOST_TEST(expected > 1);
  BOOST_TEST(count("<path fill-opacity=\"0.08\"") == expected);
  BOOST_TEST(count("<path fill=\"none\" d=\"M([-0-9.]+[ ,]){11}[-0-9.]+Z\"") == 1);
  // The line of the contact leads from body to body, and not through the cell.
  std::smatch line;
  BOOST_REQUIRE(std::regex_search(
      picture, line,
      std::regex("stroke=\"#e8710a\"[^>]*>\\s*<path[^>]* d=\"M([-0-9.]+) [-0-9.]+L"
                 "([-0-9.]+) [-0-9.]+M([-0-9.]+)")));
  const double a = std::stod(line[1]), point = std::stod(line[2]), b = std::stod(line[3]);
  BOOST_TEST((b - point) / (point - a) == 0.3 / 0.4, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_SUITE_END()
