// A check of an exercise whose reader's results are planted; test_exercises.py reads its report.
#include <stdexcept>

#include "chapters/check.hpp"

using namespace stokesbook::exercise;

namespace {

// A result for the arguments x, whose exact value is 10 x. Mistakes give 20 x, -10 x, and 0.
void result(double x, double got) {
  expect({.what = "x = " + text(x),
          .got = got,
          .expected = 10.0 * x,
          .tolerance = 1e-12,
          .mistakes = {{20.0 * x, "twice as much"},
                       {-10.0 * x, "the sign"},
                       {40.0, "this is 40"},
                       {0.0, "this is nothing"}}});
}

// A vector that is twice as large as it should be.
void vector(double x, double y) {
  const Eigen::Vector2d exact{x, y};
  expect({.what = "a vector",
          .got = 2.0 * exact,
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{2.0 * exact, "twice as much"}}});
}

void results(double first, double second) {
  result(1.0, first);
  result(2.0, second);
}

}  // namespace

int main() {
  return run({{.title = "right", .check = [] { results(10.0, 20.0); }},
              {.title = "twice", .check = [] { results(20.0, 40.0); }},
              {.title = "once", .check = [] { results(20.0, 20.0); }},
              {.title = "mixed", .check = [] { results(-10.0, 40.0); }},
              {.title = "constant", .check = [] { results(0.0, 0.0); }},
              {.title = "unknown", .check = [] { results(3.0, 40.0); }},
              {.title = "vector", .check = [] { vector(1.0, 2.0); }},
              {.title = "equal", .check = [] { vector(1.0, 1.0); }},
              {.title = "missing", .check = [] { not_done(1); }},
              {.title = "last",
               .builds_on = {1, 2, 9},
               .formula = "the formula",
               .hint = "the hint",
               .check = [] { throw std::runtime_error("thrown\n1\tpassed\t"); }}});
}
