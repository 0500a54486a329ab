// Check of exercise 10.2: quadrature, roots and logarithms; a disk and an ellipse of the library.
#include "chapters/check.hpp"

#include <fstream>

#include "stiv/interferences.hpp"
#include "study/plot.hpp"

using namespace stokesbook;
using Eigen::VectorXd;
using exercise::expect;

using Function = std::function<double(double)>;

double volume(double a, double separation, double depth);
double left_by_newton(double q);
double iterations_needed(double depth, double tolerance, double q);
VectorXd newton(const Function& v, const Function& slope, double start, int count);

namespace {

// The parabola's integral by Simpson's rule, which is exact for it.
void check_volume(double a, double separation, double depth) {
  const auto integral = [&](double k) {
    const double half = std::sqrt(depth / k);
    return 2.0 * half / 6.0 * (4.0 * -depth);  // it vanishes at both ends
  };
  const double exact = integral(0.5 * (1.0 / a + 1.0 / (a + separation)));
  expect({.what = "a = " + exercise::text(a) + ", separation " + exercise::text(separation) +
                  ", depth " + exercise::text(depth),
          .got = volume(a, separation, depth),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {
              {integral(1.0 / a),
               "the separation's own curvature is missing: the vertex must not enter a circle of "
               "radius a + separation"},
              {0.5 * exact, "this is one half of one side: the parabola has two arms"},
              {2.0 * exact, "this is both sides"},
              {-exact, "violations are negative"},
              {integral(1.0 / a + 1.0 / (a + separation)), "curvatures come with s^2/2"}}});
}

void check_left() {
  for (const double q : {1.0, 1.5, 2.0, 3.0}) {
    // By an iteration from p = 1: V = -1, V' = -q.
    const double exact = 1.0 - (-1.0) / (-q);
    expect({.what = "q = " + exercise::text(q),
            .got = left_by_newton(q),
            .expected = exact,
            .tolerance = 1e-12,
            .mistakes = {{1.0 - exact, "this is the part that is taken away"},
                         {0.0, "Newton's method is quadratic where the slope is not zero only"},
                         {1.0 / 3.0, "this holds for q = 3/2"}}});
  }
}

void check_iterations_needed() {
  for (const double q : {1.5, 2.0}) {
    const double exact = std::log(0.05 / 1e-4) / std::log(q / (q - 1.0));
    expect({.what = "q = " + exercise::text(q) + ", from 0.05 to 1e-4",
            .got = iterations_needed(0.05, 1e-4, q),
            .expected = exact,
            .tolerance = 1e-10,
            .mistakes = {{std::log2(std::log(1e-4) / std::log(0.05)),
                          "digits do not double here: each iteration leaves the same part"},
                         {std::log(0.05 / 1e-4) / std::log(q),
                          "the part left is (q - 1)/q, not "
                          "1/q"},
                         {-exact, "the number is positive where the tolerance is below the depth"},
                         {std::ceil(exact), "the number is asked for without rounding"}}});
  }
}

void check_newton() {
  const Function square = [](double x) { return x * x - 2.0; };
  const Function slope = [](double x) { return 2.0 * x; };
  const VectorXd got = newton(square, slope, 1.5, 4);
  // Heron's mean of x and 2/x, and the same with the slope frozen.
  VectorXd exact(5), frozen(5);
  exact[0] = frozen[0] = 1.5;
  for (int k = 0; k < 4; ++k) {
    exact[k + 1] = 0.5 * (exact[k] + 2.0 / exact[k]);
    frozen[k + 1] = frozen[k] - square(frozen[k]) / 3.0;
  }
  expect({.what = "x^2 = 2 from 1.5",
          .got = got,
          .expected = exact,
          .tolerance = 1e-14,
          .mistakes = {{frozen, "the slope has to be that of the latest place"},
                       {exact.tail(4), "the start is the first of the places"},
                       {exact.head(4), "this is one iteration short"}}});
}

// The gaps of a disk that is moved out of a fixed ellipse along the row's normal.
VectorXd gaps(RowChoice choice, int count) {
  constexpr double separation = 0.1;
  const auto polygon = [](const Shape& shape) {
    return std::make_shared<ContactShape>(contact_shape(sample(shape, 4096, Side::fluid_outside)));
  };
  const ContactShapes shapes{polygon(Ellipse{2.0, 1.0}), polygon(Circle{1.0})};
  Complex displacement{0.8, -0.42};
  VectorXd found(count + 1);
  for (int k = 0; k <= count; ++k) {
    const auto row = [&](RowChoice of) {
      return interferences(shapes, {{{0.0, 0.0}, 0.0}, {{{0.0, 2.4}, 0.0}, displacement, 0.0}},
                           {{separation}, 1e-12, of})
          .contacts.front()
          .rows.front();
    };
    found[k] = std::abs(row(RowChoice::deepest).gap);
    const ContactRow constraint = row(choice);
    const Complex normal = constraint.derivative.on_b.force;
    displacement -= constraint.gap * normal / std::norm(normal);
  }
  return found;
}

void check_experiment() {
  constexpr int count = 4;
  study::Plot plot{.title = "Newton's method for one contact",
                   .x_label = "iteration k",
                   .y_label = "gap that is left",
                   .log_x = false};
  std::ofstream table("thirds.csv");
  table << "rows,iteration,gap\n";
  const double expected = left_by_newton(1.5);
  for (const auto& [name, choice] : {std::pair{"volume", RowChoice::aggregate},
                                     std::pair{"deepest vertex", RowChoice::deepest}}) {
    const VectorXd left = gaps(choice, count);
    plot.lines.push_back({.label = name});
    for (int k = 0; k <= count; ++k) {
      plot.lines.back().points.push_back({static_cast<double>(k), left[k]});
      table << name << ',' << k << ',' << left[k] << '\n';
    }
    if (choice != RowChoice::aggregate) continue;
    expect({.what = "the part that an iteration leaves, measured",
            .got = expected,
            .expected = std::pow(left[count] / left[0], 1.0 / count),
            .tolerance = 0.03,
            .mistakes = {{2.0 / 3.0, "this is the part that is taken away"}}});
  }
  std::ofstream("thirds.svg") << draw_plot(plot) << '\n';
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the volume",
        .formula = "-4/3 p^(3/2)/sqrt(k), k = (1/a + 1/(a + separation))/2",
        .hint = "integrate -p + k s^2 between its zeros",
        .check =
            [] {
              check_volume(0.5, 0.05, 1e-3);
              check_volume(1.0, 0.3, 2e-3);
            }},
       {.title = "what is left", .formula = "p - V/V'", .hint = "V/V' = p/q", .check = check_left},
       {.title = "the iterations",
        .formula = "log(p/tol)/log(q/(q - 1))",
        .hint = "after k iterations the depth is p times left^k",
        .check = check_iterations_needed},
       {.title = "Newton's method",
        .formula = "x - V(x)/V'(x)",
        .hint = "the start comes first",
        .check = check_newton},
       {.title = "the experiment",
        .builds_on = {2},
        .formula = "the gaps of task 5 fall by 1 - 1/q an iteration, q = 3/2",
        .hint = "it uses left_by_newton()",
        .check = check_experiment}});
}
