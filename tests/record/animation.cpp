// Tests the pages of animations in special cases. read_outputs.py reads a page that a run wrote,
// and tests/docs opens one in a browser.

#include "record/animation.hpp"

#include <limits>

#include <boost/test/unit_test.hpp>

#include "folder.hpp"
#include "sample_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++found;
  return found;
}

std::string head(const std::string& title) {
  return animation_head(title, sample_contents().outlines);
}

/// Returns the last line of a text, which contains a data block.
std::string last_line(const std::string& text) {
  return text.substr(text.rfind('\n', text.size() - 2) + 1);
}

const std::string frame_start = "<script type=\"application/json\" class=\"frame\">";

}  // namespace

BOOST_AUTO_TEST_SUITE(animation)

BOOST_AUTO_TEST_CASE(a_page_needs_no_other_file) {
  const std::string page = head("A run");
  BOOST_TEST(page.starts_with("<!DOCTYPE html>"));
  for (const std::string reference :
       {" src=", " href=", "http:", "https:", "import ", "import(", "fetch(", "url("}) {
    BOOST_TEST(count(page, reference) == 0u, reference);
  }
}

BOOST_AUTO_TEST_CASE(no_title_ends_its_block) {
  const std::string line = last_line(head("</script><!-- <script> \"quoted\"\n\xe9"));
  BOOST_TEST(count(line, "<") == 2u);
  BOOST_TEST(count(line, "\\u003c/script>\\u003c!-- \\u003cscript> \\\"quoted\\\"\\n\\ufffd") ==
             1u);
}

BOOST_AUTO_TEST_CASE(equal_outlines_are_written_once) {
  const Outline first = sample_contents().outlines.bodies[0];
  const Outline other = sample_contents().outlines.bodies[1];
  const std::string line = last_line(animation_head("", {{first, other, first}, {first}}));
  BOOST_TEST(count(line, "\"bodies\":[0,1,0],\"walls\":[0]") == 1u);
  BOOST_TEST(count(line, "],[") == 31u + 1u + 59u);  // between points, and between the two shapes
}

BOOST_AUTO_TEST_CASE(a_frame_is_a_line) {
  const BodyState body{.position = {1.0, -2.5},
                       .orientation = 2.0 / 3.0,
                       .velocity = {-0.0, 1e-9},
                       .omega = 4.0,
                       .force = {1234567.0, 6.0},
                       .torque = 7.0};
  const ContactForce contact{{true, 1}, {false, 0}, {0.5, 0.25}, 1.0, 3.0, 0.125};
  const Frame frame{.t = 1000.0625, .bodies = {body}, .walls = {}, .contacts = {contact}};
  BOOST_TEST(animation_frame(frame) ==
             frame_start +
                 "[1000.0625,[[1,-2.5,0.666667,0,1e-09,4,1.23457e+06,6,7]],[],"
                 "[[-2,0,0.5,0.25,3,0.125]]]</script>\n");
}

BOOST_AUTO_TEST_CASE(what_json_does_not_know_is_refused) {
  Frame frame = sample_frame(0);
  frame.bodies[0].torque = std::numeric_limits<double>::infinity();
  BOOST_CHECK_THROW(animation_frame(frame), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(a_page_shows_what_is_saved_and_goes_on_after_a_checkpoint) {
  const Folder folder;
  const auto page = [&] { return read(folder.at("animation.html")); };
  std::string expected = head(sample_contents().title);
  {
    RunDirectory run = RunDirectory::create(folder.path(), sample_contents(), ExistingRun::refuse);
    BOOST_TEST(page() == expected);
    for (int k = 0; k < 3; ++k) {
      run.write_frame(sample_frame(k));
      BOOST_TEST(page() == expected);
      expected += animation_frame(sample_frame(k));
      if (k == 2) break;
      run.save({});
      BOOST_TEST(page() == expected);
    }
  }
  BOOST_TEST(page() == expected);
  write(folder.at("animation.html"), page() + frame_start + "[0.5,[[1,2");
  RunDirectory run = RunDirectory::resume(folder.path(), sample_contents()).directory;
  run.write_frame(sample_frame(2));
  run.save({});
  BOOST_TEST(page() == expected);
}

BOOST_AUTO_TEST_SUITE_END()
