// Check of exercise 05.4: the reader's lines against least squares, GMRES and turned matrices.
#include "chapters/check.hpp"

#include "krylov/gmres.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::VectorXd;
using exercise::expect;

double next_residual(double residual, double diagonal, double subdiagonal);
int iterations_in_disk(Complex centre, double radius, double tolerance);
int most_iterations(const std::vector<double>& diagonal, const std::vector<double>& right);
double outlier_factor(Complex centre, double radius, Complex outlier);
Complex turned_block(const std::function<Complex(Complex)>& block, double theta, Complex v);

namespace {

// The least norm of (residual, 0) - y (diagonal, subdiagonal).
void check_residual(double residual, double diagonal, double subdiagonal) {
  const Eigen::Vector2d column{diagonal, subdiagonal}, right{residual, 0.0};
  const double exact = (right - column.dot(right) / column.squaredNorm() * column).norm();
  expect({.what = "residual " + exercise::text(residual) + ", entries " + exercise::text(diagonal) +
                  " and " + exercise::text(subdiagonal),
          .got = next_residual(residual, diagonal, subdiagonal),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {residual * std::abs(diagonal) / column.norm(),
               "this is the part that stays in the row k: it is the cosine"},
              {residual * std::abs(subdiagonal / diagonal),
               "this is the residual of Galerkin's condition: it has the tangent, GMRES the sine"},
              {exact / residual, "this is the factor alone: the residual before is missing"},
              {-exact, "a residual is positive: take the modulus"}}});
}

void check_disk(Complex centre, double radius, double tolerance) {
  int needed = 1;
  while (std::pow(radius / std::abs(centre), needed) > tolerance) ++needed;
  const auto count = [&](double rate) { return std::ceil(std::log(tolerance) / std::log(rate)); };
  const double got = iterations_in_disk(centre, radius, tolerance);
  expect(
      {.what = "c = " + exercise::text(centre) + ", r = " + exercise::text(radius) +
               ", tolerance " + exercise::text(tolerance),
       .got = got,
       .expected = static_cast<double>(needed),
       .tolerance = 1e-12,
       .mistakes = {
           {count(radius), "the radius counts relative to the distance of the centre from zero"},
           {needed - 1.0, "the bound is still above the tolerance here: round up"},
           {count(radius / std::abs(centre.real())), "the modulus of c counts, not its real part"},
           {needed + 1.0, "one iteration less is enough"}}});
}

// GMRES itself counts.
void check_distinct(const std::vector<double>& diagonal, const std::vector<double>& right) {
  const Index n = static_cast<Index>(diagonal.size());
  const VectorXd entries = VectorXd::Map(diagonal.data(), n), b = VectorXd::Map(right.data(), n);
  const auto iterations = [&](const VectorXd& side) -> double {
    return gmres([&](const VectorXd& v) -> VectorXd { return entries.cwiseProduct(v); }, {}, side,
                 {1e-10, 50})
        .iterations;
  };
  std::string what = "diagonal";
  for (const double entry : diagonal) what += " " + exercise::text(entry);
  what += ", right-hand side";
  for (const double entry : right) what += " " + exercise::text(entry);
  const double got = most_iterations(diagonal, right);
  const double components = static_cast<double>((b.array() != 0.0).count());
  expect({.what = what,
          .got = got,
          .expected = iterations(b),
          .tolerance = 1e-12,
          .mistakes = {{static_cast<double>(n), "equal eigenvalues need one factor only"},
                       {iterations(VectorXd::Ones(n)),
                        "some eigenvalues do not occur in the right-hand side"},
                       {components,
                        "equal eigenvalues need one factor only, also in the "
                        "components of the right-hand side"},
                       {iterations(b) - 1.0, "a polynomial of degree k has k zeros"}}});
}

void check_outlier(Complex centre, double radius, Complex outlier) {
  const Complex direction = (centre - outlier) / std::abs(centre - outlier);
  const auto factor = [&](Complex w) { return std::abs(1.0 - w / outlier); };
  const double exact = factor(centre + radius * direction);
  expect({.what = "c = " + exercise::text(centre) + ", r = " + exercise::text(radius) +
                  ", z = " + exercise::text(outlier),
          .got = outlier_factor(centre, radius, outlier),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{factor(centre), "this is the factor at the centre of the disk"},
                       {exact * std::abs(outlier),
                        "the factor has the value 1 at zero: the distance is divided by |z|"},
                       {factor(centre - radius * direction), "this is the least value on the disk"},
                       {exact * std::abs(outlier / centre), "divide by |z|, not by |c|"}}});
}

// A matrix with the principal values p and q; the first one belongs to the direction theta.
Complex applied(double p, double q, double theta, Complex v) {
  return 0.5 * (p + q) * v + 0.5 * (p - q) * std::polar(1.0, 2.0 * theta) * std::conj(v);
}

void check_turned(double p, double q, double theta) {
  const Complex v{0.8, -0.3};
  const auto block = [&](Complex w) { return applied(p, q, 0.0, w); };
  const Complex back = std::polar(1.0, -theta);
  expect({.what = "block diag(" + exercise::text(p) + ", " + exercise::text(q) +
                  "), theta = " + exercise::text(theta),
          .got = turned_block(block, theta, v),
          .expected = applied(p, q, theta, v),
          .tolerance = 1e-12,
          .mistakes = {
              {applied(p, q, -theta, v), "this body is turned the other way"},
              {block(back * v), "this result is a vector in the frame of the body: turn it, too"},
              {block(v), "this block is not turned with the body"},
              {block(v) / back, "turn the vector into the frame of the body first"},
              {back * block(back * v), "the result is turned the wrong way"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the next residual",
        .formula = "|sin phi| times the residual, tan phi = h_{k+1,k} / h_kk",
        .hint = "the rotated right-hand side is residual (cos phi, -sin phi)",
        .check =
            [] {
              check_residual(1.0, 0.6, 0.8);
              check_residual(0.3, -1.2, 0.5);
              check_residual(2.0, 0.1, 0.7);
            }},
       {.title = "the count for a disk",
        .formula = "(r/|c|)^k <= tolerance",
        .hint = "the quotient of two negative logarithms, rounded up",
        .check =
            [] {
              for (const double tolerance : {1e-3, 1e-8}) {
                check_disk({-0.5, 0.0}, 0.2, tolerance);
                check_disk({2.0, 1.0}, 0.7, tolerance);
                check_disk({0.0, 1.5}, 0.9, tolerance);
              }
            }},
       {.title = "the count of eigenvalues",
        .formula = "the number of different eigenvalues in the right-hand side",
        .hint = "std::set keeps each number once",
        .check =
            [] {
              check_distinct({1.0, 2.0, 2.0, 5.0}, {1.0, -1.0, 2.0, 0.5});
              check_distinct({1.0, 2.0, 3.0, -4.0, 6.0}, {1.0, 0.0, 0.7, 0.0, 1.0});
              check_distinct({-1.0, -1.0, 2.0, 3.0, 3.0, 4.0}, {1.0, 0.5, 0.0, 0.0, 0.3, 0.0});
            }},
       {.title = "the factor of an outlier",
        .formula = "(|z - c| + r)/|z|",
        .hint = "the point of the disk that is farthest from z",
        .check =
            [] {
              check_outlier({-0.5, 0.0}, 0.1, {-0.01, 0.0});
              check_outlier({-0.5, 0.0}, 0.1, {3.0, 1.0});
              check_outlier({1.0, 0.5}, 0.4, {0.2, -0.3});
            }},
       {.title = "the block of a turned body",
        .formula = "Q block(Q^T v) with the rotation Q = exp(i theta)",
        .hint = "into the frame, through the block, and back",
        .check = [] {
          check_turned(2.0, 0.5, 0.4);
          check_turned(1.0, 3.0, -1.1);
          check_turned(0.2, 0.7, 2.0);
        }}});
}
