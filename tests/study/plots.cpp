// Checks which elements a figure contains, and where they are.

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <boost/test/unit_test.hpp>

#include "record/svg.hpp"
#include "study/figures.hpp"
#include "study/plot.hpp"
#include "synthetic.hpp"

using namespace stokesbook;
using namespace stokesbook::study;
using namespace stokesbook::test;

namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

Plot decay(std::vector<PlotPoint> points) {
  return {
      .title = "decay", .x_label = "N", .y_label = "error", .lines = {{"a", std::move(points)}}};
}

// Returns the places of the ticks' labels with an anchor: x for "middle", y for "end".
std::vector<double> places_of_ticks(const std::string& svg, const std::string& anchor) {
  const std::regex label("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\"[^>]*text-anchor=\"" + anchor +
                         "\"[^>]*>[0-9]");
  std::vector<double> places;
  for (std::sregex_iterator at(svg.begin(), svg.end(), label), end; at != end; ++at) {
    places.push_back(std::stod((*at)[anchor == "middle" ? 1 : 2]));
  }
  return places;
}

// Returns the corners of the first marker of a line as x, y, x, y, ...
std::vector<double> corners_of_marker(const std::string& svg, int line) {
  const std::regex path("class=\"line-" + std::to_string(line) +
                        "\"[^]*?fill=\"currentColor\" d=\"M([^Z]*)Z");
  std::smatch found;
  BOOST_REQUIRE(std::regex_search(svg, found, path));
  std::istringstream numbers(found[1].str());
  std::vector<double> corners;
  for (double number; numbers >> number;) corners.push_back(number);
  return corners;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(plots)

// The bar of a point extends by its error above and below, and the axis contains the bar.
BOOST_AUTO_TEST_CASE(error_bars) {
  Plot plot = decay({{0.0, 5.0, false, 5.0}, {1.0, 5.0}});
  plot.log_x = plot.log_y = false;
  const std::regex bar(
      "d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"/>\n<path fill=\"currentColor");
  const std::string svg = draw_plot(plot);
  std::smatch found;
  BOOST_REQUIRE(std::regex_search(svg, found, bar));
  BOOST_TEST(found[1] == found[3]);
  const double low = std::stod(found[2]), high = std::stod(found[4]);
  // The frame is 280 pixels high, and extends beyond the bar by a twentieth at each end.
  BOOST_TEST(low - high == 280.0 / 1.1, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(low + high == 34.0 + 314.0, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(points_are_markers_and_left_out_ones_hollow) {
  // The legend contains one more marker.
  const std::string svg = draw_plot(decay({{8, 1e-1}, {16, 1e-2}, {32, 1e-3, true}}));
  BOOST_TEST(count(svg, "a3.6 3.6 0 1 0 7.2 0") == 4);
  BOOST_TEST(count(svg, "fill=\"none\" d=\"M") >= 1);
  BOOST_TEST(svg.starts_with("<svg"));
  BOOST_TEST(svg.ends_with("</svg>\n"));
}

BOOST_AUTO_TEST_CASE(markers_of_the_first_lines_are_regular_polygons) {
  Plot plot = decay({{8, 1e-1}, {16, 1e-2}, {32, 1e-3}});
  for (const char* label : {"b", "c", "d"}) plot.lines.push_back({label, plot.lines[0].points});
  const std::string svg = draw_plot(plot);
  for (const auto& [line, sides] : {std::pair{1, 4}, std::pair{2, 3}, std::pair{3, 4}}) {
    const std::vector<double> corners = corners_of_marker(svg, line);
    BOOST_REQUIRE_EQUAL(corners.size(), static_cast<std::size_t>(2 * sides));
    double shortest = 1e9, longest = 0.0;
    for (std::size_t k = 0; k < corners.size(); k += 2) {
      const std::size_t next = (k + 2) % corners.size();
      const double side =
          std::hypot(corners[next] - corners[k], corners[next + 1] - corners[k + 1]);
      shortest = std::min(shortest, side);
      longest = std::max(longest, side);
    }
    BOOST_TEST(shortest > 1.0);
    BOOST_TEST(longest - shortest < 0.03);  // coordinates have two decimals
  }
}

BOOST_AUTO_TEST_CASE(long_labels_take_two_rows) {
  Plot plot = decay({{8, 1e-1}, {16, 1e-2}});
  const std::string row = "as many words as there is room for above the plot, in a row";
  for (const std::string rest : {"", " and what is left"}) {
    plot.y_label = row + rest;
    const std::string svg = draw_plot(plot);
    BOOST_TEST(count(svg, ">" + row + "<") == 1);
    BOOST_TEST(count(svg, ">and what is left<") == (rest.empty() ? 0 : 1));
  }
}

BOOST_AUTO_TEST_CASE(colours_follow_the_page) {
  const std::string svg = draw_plot(decay({{8, 1e-1}, {16, 1e-2}}));
  BOOST_TEST(count(svg, "prefers-color-scheme:dark") == 2);
  BOOST_TEST(count(svg, "stroke=\"#") == 0);
  BOOST_TEST(count(svg, "fill=\"#") == 0);
}

BOOST_AUTO_TEST_CASE(axes_have_round_numbers) {
  const std::string powers_of_two = draw_plot(decay({{8, 1e-1}, {128, 1e-9}}));
  for (const char* tick : {">8<", ">16<", ">32<", ">64<", ">128<", ">10⁻⁴<"}) {
    BOOST_TEST(count(powers_of_two, tick) == 1);
  }
  BOOST_TEST(count(draw_plot(decay({{256, 1e-1}, {2048, 1e-9}})), ">1024<") == 1);
  const std::string fewer_than_two_powers = draw_plot(decay({{40, 1e-1}, {100, 1e-9}}));
  for (const char* tick : {">40<", ">60<", ">80<", ">100<"}) {
    BOOST_TEST(count(fewer_than_two_powers, tick) == 1);
  }
  BOOST_TEST(count(fewer_than_two_powers, ">64<") == 0);
  const std::string gaps = draw_plot(decay({{1e-3, 1e-1}, {1e-1, 1e-9}}));
  for (const char* tick : {">0.001<", ">0.002<", ">0.05<", ">0.1<"}) {
    BOOST_TEST(count(gaps, tick) == 1);
  }
  Plot linear = decay({{0, 1e-1}, {100, 1e-9}});
  linear.log_x = false;
  for (const char* tick : {">0<", ">20<", ">100<"}) {
    BOOST_TEST(count(draw_plot(linear), tick) == 1);
  }
}

BOOST_AUTO_TEST_CASE(powers_are_equally_far_apart) {
  const std::string svg = draw_plot(decay({{8, 1e-1}, {128, 1e-9}}));
  for (const auto& [anchor, direction] : {std::pair{"middle", 1.0}, std::pair{"end", -1.0}}) {
    const std::vector<double> places = places_of_ticks(svg, anchor);
    BOOST_REQUIRE(places.size() >= 4u);
    const double step = places[1] - places[0];
    BOOST_TEST(direction * step > 10.0);
    for (std::size_t k = 2; k < places.size(); ++k) {
      BOOST_TEST(std::abs(places[k] - places[k - 1] - step) < 0.03);
    }
  }
}

BOOST_AUTO_TEST_CASE(points_stay_clear_of_the_frame) {
  for (const bool logarithmic : {true, false}) {
    Plot plot = decay({{8, 1e-1}, {16, 1e-2}, {32, 1e-4}});
    plot.log_x = logarithmic;
    const std::string svg = draw_plot(plot);
    std::smatch edges;
    BOOST_REQUIRE(
        std::regex_search(svg, edges, std::regex("M([-0-9.]+) ([-0-9.]+)L([-0-9.]+) \\2")));
    std::vector<double> centres;
    const std::regex marker("M([-0-9.]+) [-0-9.]+a3.6 3.6");
    for (std::sregex_iterator at(svg.begin(), svg.end(), marker), end; at != end; ++at) {
      centres.push_back(std::stod((*at)[1]) + 3.6);
    }
    BOOST_REQUIRE(centres.size() == 4u);  // one marker is in the legend
    BOOST_TEST(centres[0] > std::stod(edges[1]) + 5.0);
    BOOST_TEST(centres[2] < std::stod(edges[3]) - 5.0);
  }
}

BOOST_AUTO_TEST_CASE(zeros_lie_on_the_lower_edge_and_nothing_is_not_drawn) {
  BOOST_TEST(count(draw_plot(decay({{8, 1e-1}, {16, 0.0}, {32, 1e-3}})), "nan") == 0);
  BOOST_TEST(draw_plot(decay({{8, 0.0}})).find("Nothing to plot") != std::string::npos);
  BOOST_TEST(draw_plot(decay({})).find("Nothing to plot") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_heat_map_has_a_cell_for_each_number) {
  Plot plot = decay({{1, 1e-4}, {2, 1e-2}, {3, 1.0}});
  plot.log_x = false;
  plot.cells = true;
  plot.lines.push_back({"b", {{1, 0.0}, {3, NAN}}});
  const std::string svg = draw_plot(plot);
  // The colours extend over the decades from 1e-5 to 10, of which 1e-2 is the middle.
  const std::regex path("<path fill=\"(#[0-9a-f]+)\" d=\"M([-0-9.]+) ([-0-9.]+) ([-0-9.]+) ");
  std::vector<std::string> colours;
  std::vector<double> lefts, rights, tops;
  for (std::sregex_iterator at(svg.begin(), svg.end(), path), end; at != end; ++at) {
    colours.push_back((*at)[1]);
    lefts.push_back(std::stod((*at)[2]));
    tops.push_back(std::stod((*at)[3]));
    rights.push_back(std::stod((*at)[4]));
  }
  BOOST_REQUIRE_EQUAL(colours.size(), 4u);
  BOOST_TEST(colours[0] == colour(viridis, 1.0 / 6.0));
  BOOST_TEST(colours[1] == colour(viridis, 0.5));
  BOOST_TEST(colours[2] == colour(viridis, 5.0 / 6.0));
  BOOST_TEST(colours[3] == colour(viridis, 0.0));
  const std::vector<double> places = places_of_ticks(svg, "middle");
  BOOST_REQUIRE_EQUAL(places.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    BOOST_TEST(std::abs(0.5 * (lefts[k] + rights[k]) - places[k]) < 0.03);
    BOOST_TEST(tops[k] == tops[0]);
    if (k > 0) BOOST_TEST(lefts[k] > rights[k - 1]);
  }
  BOOST_TEST(tops[3] > tops[0] + 100.0);
  for (const char* label : {">a<", ">b<", "<linearGradient"}) BOOST_TEST(count(svg, label) == 1);
  BOOST_TEST(count(svg, "class=\"line-") == 0);
}

BOOST_AUTO_TEST_CASE(only_cases_are_drawn_as_cells) {
  Study study = sample_study();
  const auto joined_lines = [&](Axes axes) {
    study.experiments[0].axes = axes;
    std::ostringstream progress;
    const std::string svg = convergence_figure(run(study, Size::quick, progress).experiments[0]);
    return count(svg, "stroke-opacity=\"0.55\"");
  };
  BOOST_TEST(joined_lines(Axes::no_law) == 2);
  BOOST_TEST(joined_lines(Axes::nominal) == 0);
}

BOOST_AUTO_TEST_CASE(laws_are_drawn_as_their_axes_have_it) {
  Study study = sample_study();
  std::ostringstream progress;
  const StudyResult algebraic = run(study, Size::quick, progress);
  const std::string triangle = convergence_figure(algebraic.experiments[0]);
  BOOST_TEST(count(triangle, ">2</text>") == 1);
  for (const Line& line : study.experiments[0].lines) {
    BOOST_TEST(count(triangle, ">" + line.label + "<") == 1);
  }
  BOOST_TEST(count(triangle, "stroke-dasharray=\"6 4\"") == 0);
  std::smatch corners;
  const std::regex right_angle(
      "stroke-width=\"1\"[^>]*d=\"M([-0-9.]+) ([-0-9.]+) ([-0-9.]+) ([-0-9.]+) ([-0-9.]+) "
      "([-0-9.]+)Z");
  BOOST_REQUIRE(std::regex_search(triangle, corners, right_angle));
  BOOST_TEST(corners[5].str() == corners[1].str());
  BOOST_TEST(corners[6].str() == corners[4].str());

  // A line of order 0 is drawn as a horizontal line.
  Line& line = study.experiments[0].lines[0];
  line.claim->law = Algebraic{0.0};
  const StudyResult steep = run(study, Size::quick, progress);
  const std::string level = convergence_figure(steep.experiments[0]);
  BOOST_TEST(count(level, ">0</text>") == 0);
  BOOST_TEST(count(level, "stroke-dasharray=\"6 4\"") == 1);
  const std::regex guide("<path[^>]*stroke-dasharray=\"6 4\"[^>]*>");
  std::smatch drawn, ends;
  BOOST_REQUIRE(std::regex_search(level, drawn, guide));
  const std::string path = drawn[0].str();
  BOOST_REQUIRE(std::regex_search(path, ends, std::regex("M([0-9.]+) [0-9.]+L([0-9.]+) ")));
  BOOST_TEST(std::stod(ends[2]) - std::stod(ends[1]) > 100.0);

  line.claim->law = Geometric{0.1};
  line.claim->window.floor = 1e-9;
  study.experiments[0].axes = Axes::semi_log;
  const StudyResult geometric = run(study, Size::quick, progress);
  const std::string dashed = convergence_figure(geometric.experiments[0]);
  BOOST_TEST(count(dashed, "stroke-dasharray=\"6 4\"") == 1);
  BOOST_TEST(count(dashed, "stroke-dasharray=\"1.5 4\"") == 1);
}

BOOST_AUTO_TEST_CASE(triangles_with_the_same_slope_do_not_cover_each_other) {
  Plot plot = decay({{8, 1e-1}, {128, 1e-9}});
  plot.guides = {{0, {16, 1e-3}, {64, 1e-6}, "5"},
                 {0, {16, 1.2e-3}, {64, 1.2e-6}, "5"},  // covers the first
                 {0, {16, 1.2e-3}, {64, 1.2e-7}, "7"},  // has another slope
                 {0, {16, 1e-5}, {64, 1e-8}, "5"}};     // is far below
  const std::string svg = draw_plot(plot);
  BOOST_TEST(count(svg, ">5</text>") == 2);
  BOOST_TEST(count(svg, ">7</text>") == 1);
}

BOOST_AUTO_TEST_CASE(an_inconclusive_claim_has_no_guide) {
  Study study = sample_study();
  Claim& claim = *study.experiments[0].lines[0].claim;
  const auto guides = [&](double from) {
    claim.window.from = from;
    std::ostringstream progress;
    const std::string svg = convergence_figure(run(study, Size::quick, progress).experiments[0]);
    return count(svg, ">2</text>") + count(svg, "stroke-dasharray=\"6 4\"");
  };
  // The points are 8, 16, ..., 128; a claim requires three of them.
  for (const Law& law : {Law{Algebraic{2.0}}, Law{Algebraic{0.0}}, Law{Geometric{0.1}}}) {
    claim.law = law;
    BOOST_TEST(guides(32.0) == 1);
    BOOST_TEST(guides(64.0) == 0);
    BOOST_TEST(guides(256.0) == 0);
  }
}

BOOST_AUTO_TEST_SUITE_END()
