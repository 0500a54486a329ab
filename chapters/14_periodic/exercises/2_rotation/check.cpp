// Check of exercise 14.2: the formulas for small disks against solutions of cells.
#include "chapters/check.hpp"

#include <numbers>

#include "periodic/far_sums.hpp"
#include "support/cells.hpp"

using namespace stokesbook;
using exercise::expect;
using exercise::text;
using std::numbers::pi;

double rotation_slope(Complex S2, double area);
double second_coefficient(Complex T3, double area);
double normal_stress_coefficient(Complex T3, double area);

namespace {

// A cell with its sums over disks, from a disk of sources that has no near images.
struct Case {
  Complex a1, a2;
  Complex s2, t3;
  double area;

  Case(Complex first, Complex second) : a1(first), a2(second) {
    const Lattice lattice(a1, a2);
    const double small = 0.2 * std::abs(lattice.shortest());
    const FarSums sums = far_sums(lattice, small, 1);
    s2 = sums.s[2] / (small * small);
    t3 = sums.t[3] / (small * small);
    area = lattice.area();
  }

  std::string name() const { return "the cell of " + text(a1) + " and " + text(a2); }

  // (omega + 1/2)/phi, (eta - 1 - 2 phi)/phi^2 and N_1/phi^2.
  Eigen::Vector3d coefficients(double phi) const {
    test::Cell cell = test::disk_in_a_cell(a1, a2, phi, 32);
    test::set_shear(cell);
    const test::CellMotion disk = test::solve(cell, {44, 100000}).bodies[0];
    const Complex stress = disk.stresslet / area;
    return {(disk.omega + 0.5) / phi, (stress.imag() - 2.0 * phi) / (phi * phi),
            2.0 * stress.real() / (phi * phi)};
  }

  // The limit for small disks, by extrapolation.
  Eigen::Vector3d limits() const { return 2.0 * coefficients(0.001) - coefficients(0.002); }
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{1.0, {0.3, 1.0}}, {2.0, {0.6, 1.5}}, {1.0, {0.2, 1.4}}};
  return all;
}

void check_rotation() {
  for (const Case& cell : cases()) {
    const double exact = cell.limits()[0];
    expect(
        {.what = cell.name(),
         .got = rotation_slope(cell.s2, cell.area),
         .expected = exact,
         .tolerance = 1e-4,
         .mistakes = {
             {2.0 * cell.area / pi * cell.s2.real(), "a disk rotates with half of the vorticity"},
             {cell.area / pi * cell.s2.imag(),
              "alpha is imaginary: the imaginary part of -S_2 alpha contains the real "
              "part of S_2"},
             {cell.s2.real() / pi, "the radius is that of the area fraction: a^2 = phi V/pi"},
             {-cell.area / pi * cell.s2.real(),
              "lambda_1 has a minus, and so has "
              "alpha"}}});
  }
}

void check_viscosity() {
  for (const Case& cell : cases()) {
    const double lattice_part = -4.0 * cell.area / pi * cell.t3.real();
    expect(
        {.what = cell.name(),
         .got = second_coefficient(cell.t3, cell.area),
         .expected = cell.limits()[1],
         .tolerance = 1e-3,
         .mistakes = {
             {lattice_part, "the term with pi/V is missing: without it the flow is not periodic"},
             {lattice_part - 2.0, "the term with pi/V has the conjugate of alpha"},
             {0.5 * lattice_part + 1.0, "the strain is twice the coefficient: e_1 = -2 conj(mu_1)"},
             {2.0 - lattice_part,
              "2 T_3 alpha and pi/V conj(alpha) have different "
              "signs"}}});
  }
}

void check_normal_stress() {
  for (const Case& cell : cases()) {
    const double exact = -8.0 * cell.area / pi * cell.t3.imag();
    expect({.what = cell.name(),
            .got = normal_stress_coefficient(cell.t3, cell.area),
            .expected = cell.limits()[2],
            .tolerance = 1e-3,
            .mistakes = {{-exact, "conj(T_3) has the other sign of the imaginary part"},
                         {0.5 * exact, "N_1 is the difference of two stresses: S_22 = -S_11"},
                         {-8.0 * cell.area / pi * cell.t3.real(),
                          "the factor i of the shear turns the imaginary part of T_3 into a real "
                          "number"}}});
  }
}

}  // namespace

int main() {
  return exercise::run({{.title = "the rotation",
                         .formula = "V Re(S_2)/pi",
                         .hint = "omega + 1/2 = 2 Im(lambda_1) with lambda_1 = -S_2 alpha",
                         .check = check_rotation},
                        {.title = "the viscosity",
                         .formula = "2 - 4 V Re(T_3)/pi",
                         .hint = "S = 2 pi a^2 (i + e_1), e_1 = -2 conj(2 T_3 alpha + pi/V "
                                 "conj(alpha))",
                         .check = check_viscosity},
                        {.title = "the normal stress difference",
                         .formula = "-8 V Im(T_3)/pi",
                         .hint = "the real part of the stresslet of task 2",
                         .check = check_normal_stress}});
}
