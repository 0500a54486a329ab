// Check of exercise 06.3: functions with poles inside a body, and evaluations broken on purpose.
#include "chapters/check.hpp"

#include <numbers>

#include "near_singular/near_field.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

using Evaluation = std::function<Complex(const Curve& body, const ComplexVector& f, Complex z)>;

Complex right(const Curve& body, const ComplexVector& f, Complex z);
Complex factor(const std::string& mistake, Complex q);
std::string diagnose(const Evaluation& evaluation);

namespace {

// Analytic outside the bodies below, zero at infinity.
Complex analytic(Complex z) {
  return Complex{0.4, 0.7} / (z - Complex{0.1, 0.02}) - Complex{0.3, 0.1} / (z * z);
}

// Sums over the nodes: of W f and of W.
struct Sums {
  Sums(const Curve& body, const ComplexVector& f, Complex z) {
    const Complex unit = -1.0 / (imaginary * static_cast<double>(body.size()));
    for (Index j = 0; j < body.size(); ++j) {
      const Complex w = unit * body.dx[j] / (body.x[j] - z);
      of_f += w * f[j];
      of_one += w;
    }
  }
  Complex of_f, of_one;
};

struct Broken {
  std::string name;
  Evaluation evaluate;
};

const std::vector<Broken> evaluations{
    {"right",
     [](const Curve& body, const ComplexVector& f, Complex z) {
       const Sums sums(body, f, z);
       return sums.of_f / (1.0 + sums.of_one);
     }},
    {"without_one",
     [](const Curve& body, const ComplexVector& f, Complex z) {
       const Sums sums(body, f, z);
       return sums.of_f / sums.of_one;
     }},
    {"undivided",
     [](const Curve& body, const ComplexVector& f, Complex z) { return Sums(body, f, z).of_f; }},
    {"reversed", [](const Curve& body, const ComplexVector& f, Complex z) {
       const Sums sums(body, f, z);
       return -sums.of_f / (1.0 - sums.of_one);
     }}};

struct Body {
  std::string name;
  Curve curve;
};

const std::vector<Body> bodies{{"ellipse 2:1", sample(Ellipse{1.0, 0.5}, 128, Side::fluid_outside)},
                               {"star", sample(Star{1.0, 0.1, 3}, 160, Side::fluid_outside)}};

// A point over a node and one between nodes, at a distance in spacings.
std::vector<Complex> points_at(const Curve& body, double spacings) {
  std::vector<Complex> points;
  const double h = 2.0 * pi / static_cast<double>(body.size());
  const ComplexVector normal = normals(body);
  for (const Index j : {Index{5}, Index{40}}) {
    const Complex along = j == 5 ? Complex{} : 0.4 * h * body.dx[j];
    points.push_back(body.x[j] + along - spacings * h * std::abs(body.dx[j]) * normal[j]);
  }
  return points;
}

void check_right() {
  for (const auto& [name, body] : bodies) {
    const ComplexVector f = body.x.unaryExpr(&analytic);
    for (const double spacings : {5.0, 1.0, 0.1, 1e-3, 1e-8}) {
      for (const Complex z : points_at(body, spacings)) {
        std::vector<exercise::Mistake> mistakes;
        const std::array sentences{"", "the 1 of a body is missing",
                                   "the sum is not divided by Delta",
                                   "the orientation is reversed"};
        for (std::size_t k : {1, 2, 3}) {
          mistakes.push_back({evaluations[k].evaluate(body, f, z), sentences[k]});
        }
        expect({.what = name + ", " + exercise::text(spacings) + " spacings",
                .got = right(body, f, z),
                .expected = analytic(z),
                .tolerance = 1e-11,
                .mistakes = mistakes});
      }
    }
    const Complex got = right(body, f, body.x[7]);
    if (std::isnan(got.real())) {
      throw exercise::Rejection{exercise::line("for", name + ", on a node") +
                                exercise::difference(got, f[7]) +
                                exercise::line("mistake", "a node is divided by zero")};
    }
    expect({.what = name + ", on a node", .got = got, .expected = f[7], .tolerance = 0.0});
  }
}

void check_factor() {
  // On a circle the second preimage is at infinity, and q = z^-N exactly.
  const Curve circle = sample(Circle{1.0}, 64, Side::fluid_outside);
  const ComplexVector f = circle.x.cwiseInverse();
  for (std::size_t k : {1, 2, 3}) {
    for (const double radius : {1.2, 1.05, 1.01}) {
      const Complex z = std::polar(radius, 0.77), q = std::pow(z, -64);
      const Complex exact = evaluations[k].evaluate(circle, f, z) * z;
      expect({.what = evaluations[k].name + ", q = " + exercise::text(q),
              .got = factor(evaluations[k].name, q),
              .expected = exact,
              .tolerance = 1e-9,
              .mistakes = {{1.0 / exact, "the factor is inverted: what is returned, over f"},
                           {-exact, "the sign is the other one"},
                           {-1.0, "the divisor changes with the weights: 1 - sum W_j"}}});
    }
  }
}

void check_diagnosis() {
  for (const Broken& broken : evaluations) {
    const std::string got = diagnose(broken.evaluate);
    if (got == broken.name) continue;
    throw exercise::Rejection{
        exercise::line("for", "an evaluation with the mistake " + broken.name) +
        exercise::line("got", got) + exercise::line("expected", broken.name) +
        exercise::line("mistake", "found " + got + ", but the mistake is " + broken.name)};
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the right formula",
                         .formula = "f(z) = sum W_j f_j/(1 + sum W_j)",
                         .hint = "W_j = -x'_j h/(2 pi i (x_j - z)); a node has its own value",
                         .check = check_right},
                        {.title = "what the mistakes return",
                         .formula = "sum W_j f_j = f/(1 - q), sum W_j = q/(1 - q)",
                         .hint = "insert both into the broken formula",
                         .check = check_factor},
                        {.title = "the diagnosis",
                         .builds_on = {2},
                         .formula = "the ratio of the evaluation and f is one of the factors",
                         .hint = "close to the curve all factors differ; far away two are 1",
                         .check = check_diagnosis}});
}
