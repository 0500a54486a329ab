// Check of exercise 11.4: complex steps, Lemke's solutions, and problems of one contact.
#include "chapters/check.hpp"

#include "lcp/lemke.hpp"

using namespace stokesbook;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;
using exercise::text;

double fischer_slope(double z, double w);
double minimum(const VectorXd& q, const VectorXd& z);
double offset_of_problem(double gap, double dt, const VectorXd& gradient, const VectorXd& u,
                         const VectorXd& u_free);
double step_length(const VectorXd& dz, const VectorXd& dw);
double force_with_unit(double scaled, double a, double diagonal);

namespace {

// The imaginary part of an analytic function at z + ih is h times its derivative.
void check_slope(double z, double w) {
  constexpr double h = 1e-30;
  const Complex beside{z, h};
  const double exact = (std::sqrt(beside * beside + w * w) - beside - w).imag() / h;
  const double length = std::hypot(z, w);
  expect({.what = "z = " + text(z) + ", w = " + text(w),
          .got = fischer_slope(z, w),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {{0.5 / std::sqrt(z + w) - 1.0,
                        "this has the root of z + w: it is the root of z^2 + w^2"},
                       {exact + 1.0, "the derivative of -z is missing"},
                       {w / length - 1.0, "this is the derivative with respect to w"},
                       {0.5 / length - 1.0, "the chain rule gives a factor 2 z"}}});
}

void check_minimum(const VectorXd& q) {
  const MatrixXd matrix{{4.0, -1.0, 0.5}, {-1.0, 3.0, -1.0}, {0.5, -1.0, 2.0}};
  const VectorXd z = lemke({matrix, q}).z;
  const double linear = q.dot(z), quadratic = 0.5 * z.dot(matrix * z);
  expect({.what = "q = (" + text(q[0]) + ", " + text(q[1]) + ", " + text(q[2]) + "), z = (" +
                  text(z[0]) + ", " + text(z[1]) + ", " + text(z[2]) + ")",
          .got = minimum(q, z),
          .expected = linear + quadratic,
          .tolerance = 1e-10,
          .mistakes = {{linear, "the quadratic part is missing: z . M z = -q . z"},
                       {quadratic, "the linear part is missing: this is z . M z/2 alone"},
                       {1.5 * linear, "z . M z is minus q . z, because z . w = 0"}}});
}

// The gap is a linear function of the velocity, so that its linearisation is the gap itself.
void check_offset(double dt, const VectorXd& u) {
  const VectorXd gradient{{-0.6, 0.8, 0.5}}, u_free{{1.0, -2.0, 0.75}};
  const auto gap = [&](const VectorXd& v) { return 0.3 + dt * gradient.dot(v); };
  const double exact = gap(u_free), g = gap(u);
  expect({.what = "g = " + text(g) + ", dt = " + text(dt) +
                  ", J . (u_free - u) = " + text(gradient.dot(u_free - u)),
          .got = offset_of_problem(g, dt, gradient, u, u_free),
          .expected = exact,
          .tolerance = 1e-12,
          .mistakes = {
              {g,
               "this is the problem of an increment: the forces of this problem replace those "
               "before, so that the gap without them is needed"},
              {2.0 * g - exact, "the way goes from u to u_free, not back"},
              {g + (exact - g) / dt, "a velocity is not a displacement: dt is missing"},
              {g + exact - 0.3, "this has not subtracted u"}}});
}

// Along a step the curvature of a diagonal matrix is the mean of its entries, with the squares of
// the step's components as weights.
void check_length(double first, double second, const VectorXd& dz) {
  const VectorXd dw{{first * dz[0], second * dz[1]}};
  const double x = dz[0] * dz[0], y = dz[1] * dz[1];
  const double curvature = (first * x + second * y) / (x + y);
  expect({.what = "dz = (" + text(dz[0]) + ", " + text(dz[1]) + "), dw = (" + text(dw[0]) + ", " +
                  text(dw[1]) + ")",
          .got = step_length(dz, dw),
          .expected = 1.0 / curvature,
          .tolerance = 1e-12,
          .mistakes = {{(first * x + second * y) / (first * first * x + second * second * y),
                        "this is the second length, which weights large curvatures more"},
                       {curvature, "this is the mean curvature: the length is its inverse"},
                       {dz.norm() / dw.norm(),
                        "this is a quotient of norms, the geometric mean of both "
                        "lengths"}}});
}

// One contact: z = -q/M, and the scaled one has z' = -q'.
void check_unit(double q, double diagonal, double a) {
  const double s = 1.0 / std::sqrt(diagonal), scaled = -s * q / a, exact = -q / diagonal;
  expect(
      {.what = "z' = " + text(scaled) + ", a = " + text(a) + ", M_ii = " + text(diagonal),
       .got = force_with_unit(scaled, a, diagonal),
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{a * scaled / s,
                     "this divides by s_i: forces are s_i times scaled forces, as M' = "
                     "s M s multiplies them"},
                    {s * scaled, "the factor a is missing: q' has been divided by it"},
                    {a * scaled * s * s,
                     "s_i occurs once: M' has it on both sides, and one of them "
                     "belongs to the gap"},
                    {s * scaled / a, "q' has been divided by a: the force is multiplied by it"}}});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the slope of Fischer's function",
                         .formula = "z/r - 1 with r = sqrt(z^2 + w^2)",
                         .hint = "the chain rule for the root, and the derivative of -z",
                         .check =
                             [] {
                               check_slope(1.0, 2.0);
                               check_slope(3.0, 0.5);
                               check_slope(0.2, 1.5);
                             }},
                        {.title = "the value at the minimum",
                         .formula = "q . z/2",
                         .hint = "z . M z = z . w - q . z, and z . w = 0",
                         .check =
                             [] {
                               check_minimum(VectorXd{{-1.0, -2.0, 0.5}});
                               check_minimum(VectorXd{{-3.0, 1.0, -1.0}});
                             }},
                        {.title = "the gap without contact forces",
                         .formula = "b = g + dt J . (u_free - u)",
                         .hint = "follow the linearised gap from u to u_free",
                         .check =
                             [] {
                               check_offset(0.5, VectorXd{{0.5, -1.0, 0.25}});
                               check_offset(0.25, VectorXd{{-1.0, 0.5, 2.0}});
                             }},
                        {.title = "a length for a step",
                         .formula = "dz . dz/(dz . dw)",
                         .hint = "the curvature is dz . dw/(dz . dz)",
                         .check =
                             [] {
                               check_length(1.0, 9.0, VectorXd{{1.0, 1.0}});
                               check_length(0.5, 2.0, VectorXd{{3.0, -1.0}});
                             }},
                        {.title = "a force with its unit",
                         .formula = "z_i = a s_i z'_i",
                         .hint = "compare -q/M with -q' for one contact",
                         .check = [] {
                           check_unit(-2.0, 4.0, 0.5);
                           check_unit(-0.3, 0.25, 3.0);
                           check_unit(-5.0, 9.0, 2.0);
                         }}});
}
