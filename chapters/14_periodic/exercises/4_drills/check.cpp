// Check of exercise 14.4: lattices and images by the library, and sums by other ways.
#include "chapters/check.hpp"

#include "periodic/far_sums.hpp"
#include "trapezoid/plane.hpp"

using namespace stokesbook;
using exercise::expect;
using exercise::text;

double reduced_shear(double shear, double L1, double L2);
int near_images(double R);
Complex pressure_gradient(const std::vector<Complex>& free, const std::vector<Complex>& held,
                          double area);
Complex image_velocity(Complex U, double shear_rate, Complex w);
double contact_stress(Complex F, Complex c_A, Complex c_B, Complex w, double area);

namespace {

// The vector of the row above that is nearest to the axis.
void check_shear(double shear, double L1, double L2) {
  double exact = shear * L2;
  while (exact > 0.5 * L1) exact -= L1;
  while (exact < -0.5 * L1) exact += L1;
  const double square = L2 * (shear - std::round(shear));
  expect({.what = "gamma = " + text(shear) + ", L1 = " + text(L1) + ", L2 = " + text(L2),
          .got = reduced_shear(shear, L1, L2),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact + L1, "with floor the component may be nearly a whole L1: round"},
                       {square, "the sides of the cell differ: n is a number of vectors a_1"},
                       {shear * L2, "this is the component without reduction"}}});
}

void check_images(double R) {
  const double exact =
      static_cast<double>(stokesbook::near_images(Lattice(1.0, imaginary), R).size());
  const double most = 2.0 * std::floor(3.0 * R) + 1.0;
  expect({.what = "R = " + text(R),
          .got = static_cast<double>(::near_images(R)),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{exact + 1.0, "the vector 0 is no image"},
                       {most * most - 1.0,
                        "these vectors fill a square; near images are a disk of vectors"}}});
}

// The total force is that of one force at a time.
void check_gradient(const std::vector<Complex>& free, const std::vector<Complex>& held,
                    double area) {
  const auto total = [](const std::vector<Complex>& forces) {
    return Eigen::Map<const ComplexVector>(forces.data(), std::ssize(forces)).sum();
  };
  const Complex exact = (total(free) + total(held)) / area;
  expect({.what = std::to_string(free.size()) + " free bodies, " + std::to_string(held.size()) +
                  " held bodies, V = " + text(area),
          .got = pressure_gradient(free, held, area),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{total(free) / area, "held bodies count: the fluid feels their forces"},
                       {-exact, "the pressure rises along the force on the fluid"},
                       {exact * area, "the gradient is a force for each area"}}});
}

// The image moves with its lattice vector: a difference of places at two times.
void check_velocity(Complex U, double rate, Complex w) {
  const double dt = 0.5;
  const Complex carried = w + rate * dt * w.imag();
  const Complex exact = U + (carried - w) / dt;
  expect({.what = "U = " + text(U) + ", rate " + text(rate) + ", w = " + text(w),
          .got = image_velocity(U, rate, w),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{U, "the mean flow differs between a body and its image"},
                       {2.0 * U - exact, "the image is at c + w, in the direction of w"},
                       {U + imaginary * (exact - U), "the shear flow has the direction of x"}}});
}

void check_stress(Complex F, Complex c_A, Complex c_B, Complex w, double area) {
  const Complex image = c_B + w;
  const double exact = F.real() * (image - c_A).imag() / area;
  expect({.what = "F = " + text(F) + ", c_A = " + text(c_A) + ", c_B = " + text(c_B) +
                  ", w = " + text(w) + ", V = " + text(area),
          .got = contact_stress(F, c_A, c_B, w, area),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{F.real() * (c_B - c_A).imag() / area,
                        "the image is at c_B + w, beyond the edge of the cell"},
                       {-exact, "F pushes the bodies apart; the stress has a minus"},
                       {F.imag() * (image - c_A).real() / area,
                        "this is the component 21: the first index belongs to the force"},
                       {exact * area, "the stress is a mean over the cell"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the reduced shear",
                         .formula = "gamma L2 - L1 round(gamma L2/L1)",
                         .hint = "n = round(gamma L2/L1)",
                         .check =
                             [] {
                               check_shear(0.8, 1.5, 2.0);
                               check_shear(3.7, 1.5, 1.0);
                               check_shear(0.7, 2.0, 2.0);
                             }},
                        {.title = "near images",
                         .formula = "the number of (j, k) != 0 with j^2 + k^2 < 9 R^2",
                         .hint = "count, with both signs",
                         .check =
                             [] {
                               check_images(0.75);
                               check_images(1.1);
                             }},
                        {.title = "the pressure gradient",
                         .formula = "sum of all forces on the fluid, over V",
                         .hint = "(14.12)",
                         .check =
                             [] {
                               check_gradient({{1.0, 0.5}, {-0.3, 0.2}}, {{0.4, -1.0}}, 2.0);
                               check_gradient({{0.5, 0.5}}, {{1.0, 2.0}, {0.25, -0.5}}, 4.0);
                             }},
                        {.title = "the velocity of an image",
                         .formula = "U + (rate w_2, 0)",
                         .hint = "the difference of the mean flow at c + w and at c",
                         .check =
                             [] {
                               check_velocity({0.2, -0.1}, 2.0, {0.5, 1.5});
                               check_velocity({1.0, 0.3}, 0.5, {-2.0, -1.0});
                             }},
                        {.title = "the stress of a contact",
                         .formula = "-F_1 (c_A - c_B - w)_2/V",
                         .hint = "the vector from the image to A",
                         .check = [] {
                           check_stress({1.0, -0.5}, {0.1, 0.4}, {0.2, -0.3}, {0.3, 1.0}, 1.0);
                           check_stress({-0.6, 0.8}, {0.0, -0.7}, {0.1, 0.6}, {-0.5, -1.5}, 2.0);
                         }}});
}
