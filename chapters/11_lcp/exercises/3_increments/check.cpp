// Check of exercise 11.3: the library's loop, and what the naive answer does to two contacts.
#include "chapters/check.hpp"

#include <Eigen/LU>

#include "lcp/contact_loop.hpp"

using namespace stokesbook;
using Eigen::Matrix2d;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using exercise::expect;

using Function = std::function<double(double)>;

double total_loop(const Function& gap, const Function& slope, double u_free, int iterations);
double increment_loop(const Function& gap, const Function& slope, double u_free, int iterations);
double breaking_velocity(double left);
Vector2d naive_pull();

namespace {

double gap(double u) {
  return std::exp(u) - 0.5;
}

double slope(double u) {
  return std::exp(u);
}

VectorXd one(double x) {
  return VectorXd::Constant(1, x);
}

// By the library, which does not stop at an open gap.
double by_the_book(double u_free, int iterations) {
  const ContactStep step{
      .free_velocity = one(u_free),
      .dt = 1.0,
      .separation = 1.0,
      .tolerance = 1e-15,
      .rows =
          [](const VectorXd& u) {
            return ContactRows{
                one(gap(u[0])), MatrixXd(one(slope(u[0]))).sparseView(), {}, {{0, 0}}};
          },
      .respond = [](const Eigen::SparseMatrix<double>& forces) -> MatrixXd { return forces; }};
  return resolve_contact(
             step, {.max_iterations = iterations, .open_gap_after = iterations, .open_gap = 1e-15})
      .velocity[0];
}

// Tangents without a look at the sign of the force.
double by_newton(double u, int iterations) {
  for (int k = 0; k < iterations; ++k) u -= gap(u) / slope(u);
  return u;
}

// The gap's value at u taken for that of its tangent at u_free.
double by_stale_gaps(double u_free, int iterations) {
  double u = u_free;
  for (int k = 0; k < iterations; ++k) u = u_free + std::max(0.0, -gap(u) / slope(u));
  return u;
}

void check_total(double u_free, int iterations) {
  const double stuck = iterations == 0 ? u_free : by_newton(u_free, 1);
  expect(
      {.what =
           "u_free = " + exercise::text(u_free) + ", " + std::to_string(iterations) + " iterations",
       .got = total_loop(gap, slope, u_free, iterations),
       .expected = by_the_book(u_free, iterations),
       .tolerance = 1e-12,
       .mistakes = {{by_stale_gaps(u_free, iterations),
                     "the gap is linearised at u, not at u_free: slope(u) (u_free - u) is missing"},
                    {stuck, "this is the loop in increments"}}});
}

void check_increments(double u_free, int iterations) {
  // A convex gap is open after the first increment.
  const double once = gap(u_free) < 0.0 ? by_newton(u_free, 1) : u_free;
  expect({.what = "u_free = " + exercise::text(u_free) + ", " + std::to_string(iterations) +
                  " iterations",
          .got = increment_loop(gap, slope, u_free, iterations),
          .expected = once,
          .tolerance = 1e-12,
          .mistakes = {{by_newton(u_free, iterations),
                        "this increment may be negative: it takes force back, or pulls"}}});
}

void check_breaking(double left) {
  const double u = breaking_velocity(left);
  expect({.what = "the gap left by an increment, u_free = " + exercise::text(u),
          .got = gap(by_newton(u, 1)),
          .expected = left,
          .tolerance = 1e-9,
          .mistakes = {{gap(by_newton(std::log(0.5 - left), 1)),
                        "this is how deep the free motion goes, not what is left after the "
                        "increment"},
                       {gap(by_newton(std::log(0.5 + left), 1)),
                        "the free motion has to violate the gap: u_free < log(1/2)"}}});
}

void check_naive() {
  const Matrix2d matrix = (Matrix2d() << 2.0, -1.0, -1.0, 2.0).finished();
  const Vector2d q = naive_pull(), z = (-matrix.inverse() * q).cwiseMax(0.0);
  expect({.what = "q = (" + exercise::text(q[0]) + ", " + exercise::text(q[1]) +
                  "): the first gap with the naive answer",
          .got = q[0] + matrix.row(0).dot(z),
          .expected = -1.0,
          .tolerance = 1e-12,
          .mistakes = {{0.0, "the naive answer is right here: no force comes out negative"},
                       {1.0, "this gap is open: it is not violated"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "total forces",
                         .formula = "f = max(0, -(g + s (u_free - u))/s^2), u = u_free + s f",
                         .hint = "the force replaces the one before",
                         .check =
                             [] {
                               for (const int k : {1, 2, 4}) check_total(-1.5, k);
                               check_total(0.3, 2);
                             }},
                        {.title = "increments",
                         .formula = "f = max(0, -g/s^2), u = u + s f",
                         .hint = "an open gap gets no force, and loses none",
                         .check =
                             [] {
                               for (const int k : {1, 2, 4}) check_increments(-1.5, k);
                               check_increments(0.3, 2);
                             }},
                        {.title = "a motion that breaks increments",
                         .formula = "g(u - g(u)/s(u)) = left",
                         .hint = "the deeper the free motion, the wider the gap that is left",
                         .check =
                             [] {
                               for (const double left : {0.01, 0.3}) check_breaking(left);
                             }},
                        {.title = "a pull that is dropped",
                         .formula = "q = -M z with z = (a, -b)",
                         .hint = "the first gap changes by M_12 b",
                         .check = check_naive}});
}
