// Check of exercise 14.1: sums by disks against the library, the kernel against Ewald sums.
#include "chapters/check.hpp"

#include <numbers>

#include "periodic/far_sums.hpp"
#include "support/ewald.hpp"

using namespace stokesbook;
using exercise::expect;
using exercise::text;
using std::numbers::pi;

Complex sum_by_rows(Complex tau);
Complex sum_by_disks(Complex b1, Complex b2);
Complex periodic_kernel(Complex z, Complex tau);

namespace {

// The library's sum over disks, for a disk of sources that has no near images.
Complex by_disks(Complex b1, Complex b2) {
  const double small = 0.2 * std::abs(b1);
  return far_sums(Lattice(b1, b2), small, 1).s[2] / (small * small);
}

void check_rows(Complex tau) {
  const Complex exact = by_disks(1.0, tau) + pi / tau.imag();
  expect({.what = "tau = " + text(tau),
          .got = sum_by_rows(tau),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{0.5 * (exact + pi * pi / 3.0),
                        "the rows below contribute as much as the rows above"},
                       {exact - pi * pi / 3.0, "the row of the origin is missing"},
                       {by_disks(1.0, tau), "this is the sum over disks"}}});
}

void check_disks(Complex b1, Complex b2) {
  const Complex exact = by_disks(b1, b2), direction = std::conj(b1) / b1;
  const double share = pi / std::abs(cross(b1, b2));
  expect({.what = "b1 = " + text(b1) + ", b2 = " + text(b2),
          .got = sum_by_disks(b1, b2),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact + share * direction, "this is the sum by rows"},
                       {exact + 2.0 * share * direction, "the term with the area has a minus"},
                       {exact + share * (direction - 1.0),
                        "the rows have a direction, and so has the term with the area"},
                       {exact * b1 * b1, "the unit of length is missing: 1/b_1^2"}}});
}

void check_kernel(Complex z, Complex tau) {
  const Complex exact = test::ewald_functions(Lattice(1.0, tau), z).f;
  const double h = tau.imag();
  expect({.what = "z = " + text(z) + ", tau = " + text(tau),
          .got = periodic_kernel(z, tau),
          .expected = exact,
          .tolerance = 1e-11,
          .mistakes = {
              {exact - imaginary * (2.0 * pi * z.imag() / h),
               "without the linear term the sum is not periodic across the rows"},
              {exact + pi / h * std::conj(z),
               "an analytic term is not periodic along the rows: F is not analytic"},
              {exact - imaginary * (pi * z.imag() / h),
               "the sum changes by 2 pi i from row to row, half of it above and half "
               "below"},
              {exact - imaginary * (4.0 * pi * z.imag() / h), "the linear term has a plus"}}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the sum by rows",
        .formula = "pi^2/3 + 2 sum_k pi^2/sin^2(pi k tau)",
        .hint = "the row k is pi^2/sin^2(pi k tau), and so is the row -k",
        .check =
            [] {
              check_rows({0.3, 1.0});
              check_rows({-0.4, 1.3});
            }},
       {.title = "the sum over disks",
        .builds_on = {1},
        .formula = "G_2(b2/b1)/b1^2 - (pi/V) conj(b1)/b1",
        .hint = "(14.8), with a basis of any direction and length",
        .check =
            [] {
              check_disks({0.8, 0.6}, {-0.9, 1.4});
              check_disks({0.0, 2.0}, {-2.5, 0.5});
              check_disks(1.0, {0.3, 1.0});
            }},
       {.title = "the periodic kernel",
        .formula = "2 pi i y/Im(tau) + sum_k pi cot(pi (z - k tau))",
        .hint = "far rows add the constants -i pi and i pi, whose number changes by one",
        .check = [] {
          check_kernel({0.2, 0.3}, {0.3, 1.0});
          check_kernel({-0.45, 0.6}, {-0.4, 1.3});
        }}});
}
