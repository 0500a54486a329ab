// Tests quantities of a run's tables against exact values.

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "record/atomic_file.hpp"
#include "sweep/results.hpp"
#include "sweep_files.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(columns)

BOOST_AUTO_TEST_CASE(linear_functions_have_their_mean_whatever_the_steps) {
  const std::array t{0.0, 0.1, 0.7, 1.0, 2.5};
  std::array<double, 5> y{};
  for (std::size_t k = 0; k < t.size(); ++k) y[k] = 3.0 - 2.0 * t[k];
  for (const auto& [from, to] : {std::pair(0.0, 2.5), std::pair(0.05, 0.06), std::pair(0.3, 2.2)}) {
    BOOST_TEST(time_average(t, y, from, to) == 3.0 - (from + to),
               boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(averages_converge_with_order_two_on_uneven_steps) {
  const auto error = [](int n) {
    std::vector<double> t, y;
    for (int k = 0; k <= n; ++k) {
      const double s = static_cast<double>(k) / n;
      t.push_back(s * s * std::numbers::pi);
      y.push_back(std::sin(t.back()));
    }
    return std::abs(time_average(t, y, 0.0, std::numbers::pi) - 2.0 / std::numbers::pi);
  };
  BOOST_TEST(error(100) / error(200) == 4.0, boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(averages_add_up) {
  const std::array t{0.0, 0.3, 0.4, 1.0};
  const std::array y{2.0, -1.0, 5.0, 4.0};
  const double parts = 0.35 * time_average(t, y, 0.0, 0.35) + 0.65 * time_average(t, y, 0.35, 1.0);
  BOOST_TEST(time_average(t, y, 0.0, 1.0) == parts, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(before_the_first_row_its_value_holds) {
  const std::array t{0.5, 1.0};
  const std::array y{4.0, 4.0};
  BOOST_TEST(time_average(t, y, 0.0, 1.0) == 4.0);
  BOOST_TEST(time_average(t, y, 0.0, 0.25) == 4.0);
}

BOOST_AUTO_TEST_CASE(nothing_is_known_after_the_last_row) {
  const std::array t{0.0, 1.0};
  const std::array y{4.0, 4.0};
  BOOST_CHECK_THROW(time_average(t, y, 0.5, 1.5), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(each_reduction) {
  const Folder folder;
  folder.write("rheology.csv", "t,s11\n0,1\n1,4\n3,-2\n");
  Quantity quantity{"a", "rheology.csv", "s11", {}, Reduction::average, 0.0, 3.0, ""};
  BOOST_TEST(value_of(folder.path(), quantity).mean == 4.5 / 3.0);
  const auto value = [&](Reduction reduction) {
    quantity.reduction = reduction;
    return value_of(folder.path(), quantity).mean;
  };
  BOOST_TEST(value(Reduction::last) == -2.0);
  BOOST_TEST(value(Reduction::least) == -2.0);
  BOOST_TEST(value(Reduction::largest) == 4.0);
  BOOST_TEST(value(Reduction::sum) == 3.0);
}

BOOST_AUTO_TEST_CASE(one_body_of_several) {
  const Folder folder;
  folder.write("trajectory.csv", "t,body,x\n0,0,1\n0,1,10\n1,0,3\n1,1,30\n");
  Quantity quantity{"x", "trajectory.csv", "x", 1, Reduction::average, 0.0, 1.0, ""};
  BOOST_TEST(value_of(folder.path(), quantity).mean == 20.0);
  quantity.item = 2;
  BOOST_TEST(message_of<RecordError>(folder, [&] { value_of(folder.path(), quantity); }) ==
             "trajectory.csv: has no row of number 2");
}

BOOST_AUTO_TEST_CASE(what_is_not_defined_stays_so) {
  const Folder folder;
  folder.write("rheology.csv", "t,torque_ratio\n0,nan\n1,nan\n");
  const Quantity quantity{"a", "rheology.csv", "torque_ratio", {}, Reduction::last, 0, 0, ""};
  BOOST_TEST(std::isnan(value_of(folder.path(), quantity).mean));
}

BOOST_AUTO_TEST_CASE(damaged_tables) {
  const Folder folder;
  const Quantity quantity{"a", "rheology.csv", "s11", {}, Reduction::average, 0.0, 1.0, ""};
  const auto error_of = [&](const std::string& text) {
    folder.write("rheology.csv", text);
    return message_of<RecordError>(folder, [&] { value_of(folder.path(), quantity); });
  };
  BOOST_TEST(error_of("t,s12\n0,1\n") == "rheology.csv: has no column 's11'");
  BOOST_TEST(error_of("t,s11\n") == "rheology.csv: has no rows");
  BOOST_TEST(error_of("t,s11\n0,1\n1\n") == "rheology.csv: has a row that is not whole");
  BOOST_TEST(error_of("t,s11\n0,1.5x\n") == "rheology.csv: holds '1.5x' where a number should be");
  BOOST_TEST(error_of("t,s11\n0,1\n0.5,1\n") ==
             "rheology.csv: ends at t = 0.5, before the average over [0, 1]");
}

BOOST_AUTO_TEST_SUITE_END()
