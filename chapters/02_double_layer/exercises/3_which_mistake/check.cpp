// Check of exercise 02.3: the reader's predictions and diagnoses on matrices broken on purpose.
#include "chapters/check.hpp"

#include <functional>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;
using std::numbers::pi;

double share(const Curve& curve, const Eigen::MatrixXd& matrix);
double sign_error(const Curve& curve);
ComplexVector invisible_density(const Curve& body);
std::string diagnose(const Curve& curve, const Eigen::MatrixXd& matrix);

namespace {

struct Case {
  std::string name;
  Curve curve;
};

// Nodes that resolve the double layers to rounding.
std::vector<Case> cases() {
  std::vector<Case> result;
  for (const Side side : {Side::fluid_outside, Side::fluid_inside}) {
    const std::string where = side == Side::fluid_inside ? ", fluid inside" : ", fluid outside";
    result.push_back({"ellipse 2:1" + where, sample(Ellipse{2.0, 1.0}, 60, side)});
    result.push_back({"star" + where, place(sample(Star{0.7, 0.2, 3}, 160, side), 5.0, 0.3)});
  }
  return result;
}

// The right matrix with its diagonal times a factor.
Eigen::MatrixXd with_diagonal(const Curve& curve, double factor) {
  Eigen::MatrixXd matrix = double_layer_matrix(curve);
  for (Index j = 0; j < curve.size(); ++j) matrix.block<2, 2>(2 * j, 2 * j) *= factor;
  return matrix;
}

struct Mistaken {
  std::string name;
  std::function<Eigen::MatrixXd(const Curve&)> matrix;
};

const std::vector<Mistaken> mistakes{
    {"right", [](const Curve& curve) { return double_layer_matrix(curve); }},
    {"normal",
     [](const Curve& curve) -> Eigen::MatrixXd { return -1.0 * double_layer_matrix(curve); }},
    {"pi", [](const Curve& curve) -> Eigen::MatrixXd { return pi * double_layer_matrix(curve); }},
    {"curvature", [](const Curve& curve) { return with_diagonal(curve, -1.0); }},
    {"diagonal", [](const Curve& curve) { return with_diagonal(curve, 0.0); }}};

double largest_residual(const Curve& curve, const Eigen::MatrixXd& matrix) {
  const ComplexVector v = ComplexVector::Ones(curve.size());
  const Eigen::VectorXd residual = matrix * interleaved(v) + 0.5 * curve.sign() * interleaved(v);
  return deinterleaved(residual).cwiseAbs().maxCoeff();
}

void check_share(const Case& c) {
  const double exact = -0.5 * c.curve.sign();
  expect({.what = c.name,
          .got = share(c.curve, double_layer_matrix(c.curve)),
          .expected = exact,
          .tolerance = 1e-10,
          .mistakes = {{exact * perimeter(c.curve), "this is the integral, not the mean"},
                       {-exact, "the sign is the other one"}}});
  // Of a matrix for which weights matter: the diagonal alone.
  const Eigen::MatrixXd diagonal = double_layer_matrix(c.curve) - with_diagonal(c.curve, 0.0);
  const ComplexVector v = ComplexVector::Ones(c.curve.size());
  const Eigen::VectorXd velocity = diagonal * interleaved(v);
  const ComplexVector at_nodes = deinterleaved(velocity);
  expect({.what = c.name + ", the diagonal alone",
          .got = share(c.curve, diagonal),
          .expected = weights(c.curve).dot(at_nodes.real()) / weights(c.curve).sum(),
          .tolerance = 1e-10,
          .mistakes = {{at_nodes.real().mean(),
                        "this is the mean over the nodes: they are not equally spaced"}}});
}

void check_sign_error(const Case& c) {
  const double exact = largest_residual(c.curve, with_diagonal(c.curve, -1.0));
  const double no_direction =
      curvatures(c.curve).cwiseProduct(weights(c.curve)).cwiseAbs().maxCoeff() / pi;
  expect({.what = c.name,
          .got = sign_error(c.curve),
          .expected = exact,
          .tolerance = 1e-9,
          .mistakes = {
              {0.5 * exact, "this is the error of a missing diagonal: a wrong sign counts twice"},
              {no_direction, "the diagonal takes the part of v along the tangent"},
              {pi * exact, "the factor 1/pi is missing"}}});
}

void check_invisible(const Case& c) {
  const ComplexVector got = invisible_density(c.curve), normal = normals(c.curve);
  const ComplexVector tangent = c.curve.dx.cwiseQuotient(c.curve.dx.cwiseAbs());
  const auto limit_of = [&](const ComplexVector& density) -> ComplexVector {
    const Eigen::VectorXd layer = -double_layer_matrix(c.curve) * interleaved(density);
    return deinterleaved(layer) - 0.5 * density;
  };
  if (got.size() != c.curve.size()) {
    throw exercise::Rejection{exercise::line("for", c.name) + exercise::difference(got, normal)};
  }
  expect({.what = c.name + ", its modulus",
          .got = got.cwiseAbs().maxCoeff(),
          .expected = 1.0,
          .tolerance = 1e-10});
  expect({.what = c.name + ", what -1/2 + D with the wrong normal makes of it",
          .got = limit_of(got),
          .expected = ComplexVector(ComplexVector::Zero(c.curve.size())),
          .tolerance = 1e-10,
          .mistakes = {{limit_of(ComplexVector::Ones(c.curve.size())),
                        "rigid motions are what the right normal is blind to"},
                       {limit_of(normal),
                        "the normal is the answer on a circle; on an ellipse |x'| is missing"},
                       {limit_of(tangent), "this is the tangent: it can be a boundary velocity"}}});
}

void check_diagnosis(const Case& c) {
  for (const Mistaken& mistake : mistakes) {
    const std::string got = diagnose(c.curve, mistake.matrix(c.curve));
    if (got == mistake.name) continue;
    throw exercise::Rejection{
        exercise::line("for", c.name) + exercise::line("got", got) +
        exercise::line("expected", mistake.name) +
        exercise::line("mistake", "found " + got + ", but the mistake is " + mistake.name)};
  }
}

// Calls a check for every case.
std::function<void()> for_all(void (*check)(const Case&)) {
  return [check] {
    for (const Case& c : cases()) check(c);
  };
}

void check_invisible_bodies() {
  check_invisible({"ellipse 2:1", sample(Ellipse{2.0, 1.0}, 60, Side::fluid_outside)});
  check_invisible({"ellipse 1:2, turned and moved",
                   place(sample(Ellipse{0.5, 1.0}, 60, Side::fluid_outside), {3.0, -1.0}, 0.4)});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the share of a motion",
                         .formula = "sum_j w_j v_j.(D v)_j / sum_j w_j",
                         .hint = "v = (1, 0): the first components of D v",
                         .check = for_all(check_share)},
                        {.title = "the error of a wrong sign",
                         .formula = "largest |kappa_j w_j t_j.v|/pi",
                         .hint = "twice the diagonal, -s kappa w t (t.v)/(2 pi)",
                         .check = for_all(check_sign_error)},
                        {.title = "the invisible density",
                         .formula = "(-1/2 - D) eta = 0",
                         .hint = "a flow inside a body has no net flux; on an ellipse the matrix "
                                 "times |x'| is symmetric",
                         .check = check_invisible_bodies},
                        {.title = "the diagnosis",
                         .builds_on = {1, 2},
                         .formula = "share/(-s/2) and the largest residual over its prediction",
                         .hint = "tasks 1 and 2 hold all that is needed",
                         .check = for_all(check_diagnosis)}});
}
