// Exercise 08.1: the expansion of a box of stresslets, and a sum over one level of boxes.
#include "chapters/exercise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "trapezoid/plane.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::not_done;

/// Stresslets: places, strengths a and b.
struct Sources {
  ComplexVector t, a;
  Eigen::VectorXd b;
};

// Task 1: A_1, ..., A_order about the centre.
ComplexVector phi_coefficients(const Sources& sources, Complex centre, double radius, int order) {
  //@ starter
  not_done(sources, centre, radius, order);  // your code instead of this line
  //@ solution
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius;
    Complex power = 1.0;
    for (Complex& entry : coefficients) {
      entry += sources.a[j] * power / radius;
      power *= w;
    }
  }
  return coefficients;
  //@ wrong one_power_late: the power of W is k - 1
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius;
    Complex power = w;
    for (Complex& entry : coefficients) {
      entry += sources.a[j] * power / radius;
      power *= w;
    }
  }
  return coefficients;
  //@ wrong unscaled: the factor 1/R is missing
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius;
    Complex power = 1.0;
    for (Complex& entry : coefficients) {
      entry += sources.a[j] * power;
      power *= w;
    }
  }
  return coefficients;
  //@ end
}

// Task 2: B_1, ..., B_order about the centre.
ComplexVector psi_coefficients(const Sources& sources, Complex centre, double radius, int order) {
  //@ starter
  not_done(sources, centre, radius, order);  // your code instead of this line
  //@ solution
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius;
    Complex power = 1.0, before = 0.0;  // W^(k-1), (k-1) W^(k-2)
    for (Index k = 1; k <= order; ++k) {
      coefficients[k - 1] -= (sources.b[j] * power - sources.a[j] * std::conj(w) * before) / radius;
      before = static_cast<double>(k) * power;
      power *= w;
    }
  }
  return coefficients;
  //@ wrong about_the_origin: conj(t) has to be measured from the centre
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius, origin = sources.t[j] / radius;
    Complex power = 1.0, before = 0.0;
    for (Index k = 1; k <= order; ++k) {
      coefficients[k - 1] -=
          (sources.b[j] * power - sources.a[j] * std::conj(origin) * before) / radius;
      before = static_cast<double>(k) * power;
      power *= w;
    }
  }
  return coefficients;
  //@ wrong simple_pole: the double pole is missing
  ComplexVector coefficients = ComplexVector::Zero(order);
  for (Index j = 0; j < sources.t.size(); ++j) {
    const Complex w = (sources.t[j] - centre) / radius;
    Complex power = 1.0;
    for (Complex& entry : coefficients) {
      entry -= sources.b[j] * power / radius;
      power *= w;
    }
  }
  return coefficients;
  //@ end
}

// Task 3: velocity at z of the coefficients of phi and psi.
Complex multipole_velocity(const ComplexVector& phi, const ComplexVector& psi, Complex centre,
                           double radius, Complex z) {
  //@ starter
  not_done(phi, psi, centre, radius, z);  // your code instead of this line
  //@ solution
  const Complex zeta = z - centre;
  Complex power = 1.0, value{}, slope{}, other{};
  for (Index k = 1; k <= phi.size(); ++k) {
    power *= radius / zeta;
    value += phi[k - 1] * power;
    slope -= static_cast<double>(k) / zeta * phi[k - 1] * power;
    other += psi[k - 1] * power;
  }
  return value - zeta * std::conj(slope) - std::conj(other);
  //@ wrong z_for_zeta: the slope is multiplied by z - c
  const Complex zeta = z - centre;
  Complex power = 1.0, value{}, slope{}, other{};
  for (Index k = 1; k <= phi.size(); ++k) {
    power *= radius / zeta;
    value += phi[k - 1] * power;
    slope -= static_cast<double>(k) / zeta * phi[k - 1] * power;
    other += psi[k - 1] * power;
  }
  return value - z * std::conj(slope) - std::conj(other);
  //@ end
}

// Task 4: velocities at all sources of the unit square, with side x side boxes.
ComplexVector one_level(const Sources& sources, int side, int order) {
  //@ starter
  not_done(sources, side, order);  // your code instead of this line
  //@ solution
  const auto place = [side](double x) { return std::min(side - 1, static_cast<int>(x * side)); };
  std::vector<std::vector<Index>> boxes(static_cast<std::size_t>(side * side));
  for (Index j = 0; j < sources.t.size(); ++j) {
    const int box = place(sources.t[j].imag()) * side + place(sources.t[j].real());
    boxes[static_cast<std::size_t>(box)].push_back(j);
  }
  const double radius = std::sqrt(0.5) / side;
  ComplexVector velocity = ComplexVector::Zero(sources.t.size());
  for (int box = 0; box < side * side; ++box) {
    const std::vector<Index>& of = boxes[static_cast<std::size_t>(box)];
    if (of.empty()) continue;
    const int column = box % side, row = box / side;
    const Complex centre = Complex{column + 0.5, row + 0.5} / static_cast<double>(side);
    const Sources inside{sources.t(of), sources.a(of), sources.b(of)};
    const ComplexVector phi = phi_coefficients(inside, centre, radius, order),
                        psi = psi_coefficients(inside, centre, radius, order);
    for (Index i = 0; i < sources.t.size(); ++i) {
      const Complex z = sources.t[i];
      if (std::max(std::abs(place(z.real()) - column), std::abs(place(z.imag()) - row)) > 1) {
        velocity[i] += multipole_velocity(phi, psi, centre, radius, z);
        continue;
      }
      for (const Index j : of) {
        if (i == j) continue;
        const Complex r = z - sources.t[j], c = std::conj(r);
        velocity[i] += sources.a[j] / r + sources.b[j] / c + r * std::conj(sources.a[j]) / (c * c);
      }
    }
  }
  return velocity;
  //@ wrong near_only: far boxes are left out
  const auto place = [side](double x) { return std::min(side - 1, static_cast<int>(x * side)); };
  static_cast<void>(order);
  ComplexVector velocity = ComplexVector::Zero(sources.t.size());
  for (Index i = 0; i < sources.t.size(); ++i) {
    for (Index j = 0; j < sources.t.size(); ++j) {
      const Complex r = sources.t[i] - sources.t[j], c = std::conj(r);
      if (i == j || std::abs(place(sources.t[i].real()) - place(sources.t[j].real())) > 1 ||
          std::abs(place(sources.t[i].imag()) - place(sources.t[j].imag())) > 1) {
        continue;
      }
      velocity[i] += sources.a[j] / r + sources.b[j] / c + r * std::conj(sources.a[j]) / (c * c);
    }
  }
  return velocity;
  //@ end
}
