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
              {.title = "missing", .check = [] { not_done(1); }},
              {.title = "last",
               .builds_on = {1, 2, 7},
               .formula = "the formula",
               .hint = "the hint",
               .check = [] { throw std::runtime_error("thrown\n1\tpassed\t"); }}});
}
