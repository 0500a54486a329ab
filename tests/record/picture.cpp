// Tests pictures in special cases; read_outputs.py checks the positions in pictures.

#include "record/picture.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>

#include "record/svg.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

std::string draw(const Frame& frame, const std::string& title = "") {
  return draw_configuration(frame, sample_contents().outlines, title);
}

/// Returns the lightness that the eye perceives (relative luminance of sRGB).
double luminance(const std::string& colour) {
  const auto channel = [&](std::size_t at) {
    return std::pow(std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0, 2.2);
  };
  return 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
}

/// Polar coordinates M, s, h of the colour space CIELAB: with (L, a, b) =
/// M (cos s, sin s cos h, sin s sin h).
struct PolarLab {
  double magnitude, saturation, hue;
};

/// Returns the polar coordinates of an sRGB colour, which is not nearly black.
PolarLab polar_lab(const std::string& colour) {
  const auto linear = [&](std::size_t at) {
    const double c = std::stoi(colour.substr(at, 2), nullptr, 16) / 255.0;
    return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
  };
  const Eigen::Matrix3d xyz_of_rgb{
      {0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  const Eigen::Vector3d xyz = xyz_of_rgb * Eigen::Vector3d(linear(1), linear(3), linear(5));
  const Eigen::Array3d root = (xyz.array() / xyz_of_rgb.rowwise().sum().array()).pow(1.0 / 3.0);
  const Eigen::Vector3d lab{116.0 * root[1] - 16.0, 500.0 * (root[0] - root[1]),
                            200.0 * (root[1] - root[2])};
  return {lab.norm(), std::acos(lab[0] / lab.norm()), std::atan2(lab[2], lab[1])};
}

}  // namespace

BOOST_AUTO_TEST_SUITE(picture)

BOOST_AUTO_TEST_CASE(colours_are_those_of_viridis) {
  BOOST_TEST(colour(viridis, 0.0) == "#440154");
  BOOST_TEST(colour(viridis, 0.5) == "#21918c");
  BOOST_TEST(colour(viridis, 1.0) == "#fde725");
  BOOST_TEST(colour(viridis, -1.0) == colour(viridis, 0.0));
  BOOST_TEST(colour(viridis, 2.0) == colour(viridis, 1.0));
}

BOOST_AUTO_TEST_CASE(colours_get_lighter) {
  for (int k = 0; k < 100; ++k) {
    BOOST_TEST(luminance(colour(viridis, k / 100.0)) < luminance(colour(viridis, (k + 1) / 100.0)));
  }
}

BOOST_AUTO_TEST_CASE(colours_get_lighter_evenly) {
  // The CIE lightness is linear along the colour map viridis.
  const auto lightness = [](double at) {
    return 116.0 * std::cbrt(luminance(colour(viridis, at))) - 16.0;
  };
  for (int k = 0; k <= 10; ++k) {
    const double even = lightness(0.0) + 0.1 * k * (lightness(1.0) - lightness(0.0));
    BOOST_TEST(std::abs(lightness(0.1 * k) - even) < 3.0);
  }
}

BOOST_AUTO_TEST_CASE(numbers_with_a_sign_have_the_colours_of_their_source) {
  // Moreland (2009) leads from blue to white and from white to red along straight lines in his
  // coordinates M, s and h, on which the hue h turns by the angle of his function AdjustHue. White
  // itself has no hue.
  constexpr double coloured = 80.0, white = 88.0, saturation = 1.08;
  const double turn = saturation * std::sqrt(white * white - coloured * coloured) /
                      (coloured * std::sin(saturation));
  for (const auto& [end, hue, turned] :
       {std::tuple{0.0, -1.1, -turn}, std::tuple{1.0, 0.5, turn}}) {
    for (int k = 0; k <= 4; ++k) {
      const double part = 0.25 * k;
      const PolarLab found = polar_lab(colour(cool_to_warm, end + part * (0.5 - end)));
      BOOST_TEST(std::abs(found.magnitude - std::lerp(coloured, white, part)) < 0.2);
      BOOST_TEST(std::abs(found.saturation - (1.0 - part) * saturation) < 0.01);
      if (k < 4) BOOST_TEST(std::abs(found.hue - (hue + part * turned)) < 0.02);
    }
  }
  BOOST_TEST(colour(cool_to_warm, 0.5) == "#dddddd");
}

BOOST_AUTO_TEST_CASE(pictures_do_not_tell_where_a_scene_lies) {
  const Frame here = sample_frame(0);
  Frame far = here;
  const Complex way{4096.0, 1024.0};
  for (BodyState& body : far.bodies) body.position += way;
  for (WallLoad& wall : far.walls) wall.position += way;
  for (ContactForce& contact : far.contacts) contact.point += way;
  for (Complex& tracer : far.tracers) tracer += way;
  BOOST_TEST((draw(far) == draw(here)));
}

BOOST_AUTO_TEST_CASE(arrows_have_short_barbs_at_their_tips) {
  const std::string picture = draw(sample_frame(0));
  const std::regex path(
      "<path fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\" "
      "d=\"([^\"]*)\"");
  std::smatch found;
  BOOST_REQUIRE(std::regex_search(picture, found, path));
  const std::string data = found[1].str();
  std::vector<double> lengths;
  const std::regex line("M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) ([-0-9.]+)");
  for (std::sregex_iterator it(data.begin(), data.end(), line), end; it != end; ++it) {
    const std::smatch& ends = *it;
    lengths.push_back(std::hypot(std::stod(ends[3]) - std::stod(ends[1]),
                                 std::stod(ends[4]) - std::stod(ends[2])));
  }
  BOOST_REQUIRE(!lengths.empty());
  BOOST_REQUIRE_EQUAL(lengths.size() % 3, 0U);
  for (std::size_t k = 0; k < lengths.size(); k += 3) {
    const double barb = std::min(0.35 * lengths[k], 6.0);
    BOOST_TEST(std::abs(lengths[k + 1] - barb) < 0.05);
    BOOST_TEST(std::abs(lengths[k + 2] - barb) < 0.05);
  }
}

// The arrow of the fastest body is as long as the mean diameter of the bodies, and remains visible
// however small the bodies are in the picture.
BOOST_AUTO_TEST_CASE(arrows_fit_bodies_and_picture) {
  Frame frame = sample_frame(0);
  for (BodyState& body : frame.bodies) body.velocity = {1.0, 0.0};
  Outlines outlines = sample_contents().outlines;
  const auto longest = [&] {
    const std::string picture = draw_configuration(frame, outlines, "");
    const std::regex arrow("stroke-linecap=\"round\" d=\"M([-0-9.]+) [-0-9.]+L([-0-9.]+) ");
    std::smatch found;
    BOOST_REQUIRE(std::regex_search(picture, found, arrow));
    return std::stod(found[2]) - std::stod(found[1]);
  };
  // The outer wall has the diameter 20 and is 648 pixels wide.
  BOOST_TEST(longest() == 74.5, boost::test_tools::tolerance(0.02));
  for (Outline& body : outlines.bodies) body.points *= 0.01;
  BOOST_TEST(longest() == 0.03 * std::sqrt(2.0) * 648.0, boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(fastest_body_has_the_top_colour) {
  Frame frame = sample_frame(0);
  frame.bodies[0].velocity = 0.0;
  const std::string picture = draw(frame);
  BOOST_TEST(contains(picture, "<path fill=\"#440154\""));
  BOOST_TEST(contains(picture, "<path fill=\"#fde725\""));
  BOOST_TEST(contains(picture, "speed |U|"));
}

BOOST_AUTO_TEST_CASE(no_arrows_and_no_colour_bar_at_rest) {
  Frame frame = sample_frame(0);
  for (BodyState& body : frame.bodies) body.velocity = 0.0;
  const std::string picture = draw(frame);
  BOOST_TEST(!contains(picture, "speed |U|"));
  BOOST_TEST(!contains(picture, "nan"));
  BOOST_TEST(!contains(picture, "inf"));
}

BOOST_AUTO_TEST_CASE(forces_of_contact_are_as_wide_as_they_are_large) {
  Frame frame = sample_frame(0);
  frame.contacts.clear();
  BOOST_TEST(!contains(draw(frame), "#e8710a"));
  const ContactParty first{false, 0}, second{false, 1}, wall{true, 0};
  frame.contacts = {{first, second, {0.1, 0.2}, 1.0, 8.0, 0.01},
                    {second, wall, {0.3, 0.4}, imaginary, 2.0, 0.01}};
  const std::string picture = draw(frame);
  BOOST_TEST(contains(picture, "stroke=\"#e8710a\""));
  BOOST_TEST(contains(picture, "stroke-width=\"5\""));
  BOOST_TEST(contains(picture, "stroke-width=\"1.25\""));
}

BOOST_AUTO_TEST_CASE(title_and_time_are_text) {
  const std::string picture = draw(sample_frame(7), "<script> & co\n");
  BOOST_TEST(contains(picture, "<title>&lt;script> &amp; co </title>"));
  BOOST_TEST(contains(picture, "t = 1<"));
  BOOST_TEST(contains(picture, " width=\"760\""));
}

BOOST_AUTO_TEST_CASE(pictures_suit_light_and_dark_pages) {
  const std::string picture = draw(sample_frame(0));
  BOOST_TEST(contains(picture, "prefers-color-scheme:dark"));
  BOOST_TEST(contains(picture, "stroke=\"currentColor\""));
}

BOOST_AUTO_TEST_CASE(nothing_to_draw) {
  BOOST_CHECK_THROW(draw_configuration({}, {}, ""), std::invalid_argument);
  const std::vector<Outline> bodies = sample_contents().outlines.bodies;
  BOOST_CHECK_THROW(draw_configuration(sample_frame(0), {bodies, {}}, ""), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
