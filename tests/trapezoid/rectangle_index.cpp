// Checks that the index finds the same rectangles as a comparison with all rectangles, for
// rectangles that are packed at once or inserted one after another.
#include "trapezoid/rectangle_index.hpp"

#include <limits>
#include <random>
#include <stdexcept>

#include <boost/test/unit_test.hpp>

using namespace stokesbook;

namespace {

std::vector<Rectangle> random_rectangles(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-10.0, 10.0), size(0.0, 1.0);
  std::vector<Rectangle> rectangles;
  while (rectangles.size() < count) {
    const Complex lower{place(random), place(random)};
    // The rectangles have various sizes, and some are points.
    const double scale = rectangles.size() % 10 == 0  ? 10.0
                         : rectangles.size() % 7 == 0 ? 0.0
                                                      : 1.0;
    rectangles.push_back({lower, lower + scale * Complex{size(random), size(random)}});
  }
  return rectangles;
}

bool meet(const Rectangle& a, const Rectangle& b) {
  return a.lower.real() <= b.upper.real() && b.lower.real() <= a.upper.real() &&
         a.lower.imag() <= b.upper.imag() && b.lower.imag() <= a.upper.imag();
}

std::vector<std::size_t> all_meeting(const std::vector<Rectangle>& rectangles,
                                     const Rectangle& rectangle) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < rectangles.size(); ++k) {
    if (meet(rectangles[k], rectangle)) numbers.push_back(k);
  }
  return numbers;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_index_finds_what_a_test_of_all_finds) {
  const std::vector<Rectangle> rectangles = random_rectangles(700, 1);
  const RectangleIndex packed(rectangles);
  RectangleIndex grown({rectangles.begin(), rectangles.begin() + 100});
  for (std::size_t k = 100; k < rectangles.size(); ++k) grown.insert(rectangles[k]);
  std::size_t found = 0;
  for (const Rectangle& rectangle : random_rectangles(300, 2)) {
    const std::vector<std::size_t> expected = all_meeting(rectangles, rectangle);
    BOOST_TEST(packed.meeting(rectangle) == expected, boost::test_tools::per_element());
    BOOST_TEST(grown.meeting(rectangle) == expected, boost::test_tools::per_element());
    found += expected.size();
  }
  BOOST_TEST(found > 1000u);
}

BOOST_AUTO_TEST_CASE(borders_count_and_everything_is_found_everywhere) {
  const RectangleIndex index({{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}, {{3, 0}, {4, 1}}});
  BOOST_TEST((index.meeting({{1, 1}, {1, 1}}) == std::vector<std::size_t>{0, 1}));
  BOOST_TEST(index.meeting({{2.5, 0}, {2.9, 5}}).empty());
  const double infinity = std::numeric_limits<double>::infinity();
  BOOST_TEST(index.meeting(square_about({7, 7}, infinity)).size() == 3u);
  BOOST_TEST(RectangleIndex().meeting(square_about({0, 0}, infinity)).empty());
}

BOOST_AUTO_TEST_CASE(a_rectangle_that_is_not_finite_is_refused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Rectangle> rectangles{{{0, 0}, {1, nan}}};
  BOOST_CHECK_THROW(RectangleIndex{rectangles}, std::invalid_argument);
  RectangleIndex index;
  BOOST_CHECK_THROW(index.insert(square_about({nan, 0}, 1.0)), std::invalid_argument);
}
