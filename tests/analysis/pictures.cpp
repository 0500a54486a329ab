// Tests which pictures a run has, and what the picture of the paths contains.
#include "analysis/plots.hpp"
#include "synthetic_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(pictures)

BOOST_AUTO_TEST_CASE(a_run_has_pictures_of_what_its_scene_defines) {
  const Run run = run_of(disks(3), {0, 1, 2}, [](double t) { return t; });
  const auto drawn = draw_run(run, {0, 2});
  std::vector<std::string> names;
  for (const auto& [name, svg] : drawn) {
    names.push_back(name);
    BOOST_TEST(svg.starts_with("<svg"));
    BOOST_TEST(svg.find("nan") == std::string::npos);
  }
  BOOST_TEST(names == (std::vector<std::string>{"cost.svg", "dissipation.svg", "gaps.svg",
                                                "paths.svg", "stresslet.svg"}),
             boost::test_tools::per_element());
  const std::string& paths = drawn.at("paths.svg");
  BOOST_TEST(paths.find(">0</text>") != std::string::npos);
  BOOST_TEST(paths.find(">1</text>") == std::string::npos);
  BOOST_TEST(paths.find(">2</text>") != std::string::npos);
  BOOST_CHECK_THROW(draw_run(run, {3}), SceneError);
}

BOOST_AUTO_TEST_CASE(some_of_many_bodies_are_chosen) {
  BOOST_TEST(bodies_to_draw(disks(20)).size() == 20u);
  BOOST_TEST(bodies_to_draw(disks(100)) ==
                 (std::vector<std::size_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}),
             boost::test_tools::per_element());
  BOOST_TEST(bodies_to_draw(disks(0)).empty());
}

BOOST_AUTO_TEST_SUITE_END()
