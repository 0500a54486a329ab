// Tests pictures of fields in special cases; read_outputs.py checks the positions in pictures.

#include <boost/test/unit_test.hpp>

#include "record/picture.hpp"
#include "record/svg.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

std::map<std::string, std::string> fields_of(const Frame& frame) {
  return draw_fields(frame, sample_contents().outlines, "A < B");
}

const std::string streamlines_of_field = "stroke-opacity=\"0.7\"";

}  // namespace

BOOST_AUTO_TEST_SUITE(field_pictures)

BOOST_AUTO_TEST_CASE(one_picture_a_quantity) {
  const auto pictures = fields_of(sample_frame(7));
  BOOST_TEST(pictures.size() == 5u);
  for (const auto& [name, picture] : pictures) {
    BOOST_TEST(is_field_picture(name), name);
    BOOST_TEST(contains(picture, "<title>A &lt; B</title>"), name);
    BOOST_TEST(contains(picture, "t = 1<"), name);
    BOOST_TEST(contains(picture, streamlines_of_field), name);
    BOOST_TEST(!contains(picture, "nan"), name);
  }
  BOOST_TEST(contains(pictures.at("fields_velocity.svg"), "speed |u|"));
  BOOST_TEST(contains(pictures.at("fields_shear_stress.svg"), "shear stress"));
  BOOST_TEST(!is_field_picture("fields_temperature.svg"));
}

// The grid begins at (-4, -2.5) with a spacing of 1/3: the squares of the grid are one unit wide.
BOOST_AUTO_TEST_CASE(tracers_are_dots_in_their_squares) {
  Frame frame = sample_frame(0);
  frame.tracers = {{-4.0, -2.5}, {-3.0, 0.5}};
  for (const auto& [name, picture] : fields_of(frame)) {
    BOOST_TEST(contains(picture, "d=\"M0.5 16.5L0.5 16.5M3.5 7.5L3.5 7.5\""), name);
  }
}

BOOST_AUTO_TEST_CASE(no_streamlines_without_velocity) {
  Frame frame = sample_frame(0);
  frame.field->velocity.resize(0);
  const auto pictures = fields_of(frame);
  BOOST_TEST(pictures.size() == 4u);
  for (const auto& [name, picture] : pictures) {
    BOOST_TEST(!contains(picture, streamlines_of_field), name);
  }
}

BOOST_AUTO_TEST_CASE(peaks_do_not_take_all_colours) {
  Frame frame = sample_frame(0);
  Eigen::VectorXd& values = frame.field->dissipation;
  values = Eigen::VectorXd::LinSpaced(values.size(), 0.0, 1.0);
  values[0] = -1e6;
  values[5] = 1e6;
  const std::string picture = fields_of(frame).at("fields_dissipation.svg");
  BOOST_TEST(contains(picture, ">0.501<"));
  BOOST_TEST(!contains(picture, "e+06"));
}

BOOST_AUTO_TEST_CASE(zero_is_grey_where_values_have_a_sign) {
  Frame frame = sample_frame(0);
  Eigen::VectorXd& values = frame.field->pressure;
  values.setConstant(0.0);
  const auto coloured = [](const std::string& text, const std::string& map_colour) {
    return contains(text, "<path stroke=\"" + map_colour + '"');
  };
  const std::string still = fields_of(frame).at("fields_pressure.svg");
  BOOST_TEST(coloured(still, "#dddddd"));
  BOOST_TEST(!coloured(still, colour(cool_to_warm, 0.0)));
  values = Eigen::VectorXd::LinSpaced(values.size(), -1.0, 3.0);
  const std::string picture = fields_of(frame).at("fields_pressure.svg");
  BOOST_TEST(contains(picture, ">0<"));
  BOOST_TEST(coloured(picture, colour(cool_to_warm, 1.0)));
  BOOST_TEST(!coloured(picture, colour(cool_to_warm, 0.0)));  // -1 is not as far from 0 as 3
}

BOOST_AUTO_TEST_CASE(constant_fields_and_fields_without_fluid) {
  Frame frame = sample_frame(0);
  frame.field->pressure.setConstant(3.0);
  BOOST_TEST(contains(fields_of(frame).at("fields_pressure.svg"), ">3<"));
  frame.field->pressure.setConstant(Rheology::undefined);
  frame.field->velocity.setConstant({Rheology::undefined, Rheology::undefined});
  for (const auto& [name, picture] : fields_of(frame)) BOOST_TEST(!contains(picture, "nan"), name);
}

BOOST_AUTO_TEST_CASE(nothing_to_draw) {
  Frame frame = sample_frame(0);
  BOOST_CHECK_THROW(draw_fields(frame, {sample_contents().outlines.bodies, {}}, ""),
                    std::invalid_argument);
  frame.field.reset();
  BOOST_CHECK_THROW(fields_of(frame), std::invalid_argument);
}

BOOST_AUTO_TEST_SUITE_END()
