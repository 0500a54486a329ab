#pragma once

#include <cmath>
#include <vector>

#include "study/study.hpp"

namespace stokesbook::test {

/// Returns measurements e(x) at 8, 16, ..., 8 * 2^(n-1).
template <class Error>
std::vector<study::Measurement> doubling(int n, const Error& error) {
  std::vector<study::Measurement> measurements;
  for (int k = 0; k < n; ++k) {
    const double x = 8.0 * std::exp2(k);
    measurements.push_back({.x = x, .error = error(x)});
  }
  return measurements;
}

/// Returns measurements e(x) at x = first, first + step, ...
template <class Error>
std::vector<study::Measurement> stepping(double first, double step, int n, const Error& error) {
  std::vector<study::Measurement> measurements;
  for (int k = 0; k < n; ++k) {
    const double x = first + step * k;
    measurements.push_back({.x = x, .error = error(x)});
  }
  return measurements;
}

inline study::Claim claim_of(const study::Law& law, const study::Window& window = {}) {
  return {.id = "99_1", .statement = "a < b & c", .law = law, .window = window, .reason = "none"};
}

/// Returns a study with an experiment of a single claim, whose control is wrong by a factor x.
inline study::Study sample_study() {
  using namespace study;
  const auto second_order = [](Size) {
    return doubling(5, [](double x) { return 3.0 / (x * x); });
  };
  const auto first_order = [](Size) { return doubling(5, [](double x) { return 3.0 / x; }); };
  return {.number = "99",
          .name = "sample",
          .title = "A sample",
          .experiments = {
              {.key = "orders",
               .title = "Orders",
               .x = "nodes N",
               .error = "largest, relative",
               .lines = {{.key = "method",
                          .label = "the method",
                          .measure = second_order,
                          .claim = claim_of(Algebraic{2.0}),
                          .control = Control{"an x too many", first_order}},
                         {.key = "naive", .label = "the naive one", .measure = first_order}}}}};
}

}  // namespace stokesbook::test
