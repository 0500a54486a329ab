// Maps the multipole expansion of a cell to the local expansion of its far images, with the terms
// that make the flow periodic and its mean zero.
#include "periodic/far_operator.hpp"

#include <cmath>
#include <numbers>

#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

FarOperator::FarOperator(const Lattice& lattice, double radius, int order)
    : order_(order),
      sums_(far_sums(lattice, radius, order)),
      share_(std::numbers::pi * radius / lattice.area() * radius),
      constant_(logarithm_constant(lattice) - 0.5) {
  require(order >= 2, "the expansions of a periodic cell must have an order of at least 2, got ",
          order);
  for (const Complex w : near_images(lattice, radius)) constant_ += std::log(std::abs(w)) - 0.5;
}

void FarOperator::operator()(Eigen::Ref<const Expansion> multipole,
                             Eigen::Ref<Expansion> local) const {
  const auto a = [&](Index k) { return Complex{multipole(0, k), multipole(1, k)}; };
  const auto b = [&](Index k) { return Complex{multipole(2, k), multipole(3, k)}; };
  const auto add = [&](Index l, Complex phi, Complex psi) {
    local.col(l) += Coefficients{phi.real(), phi.imag(), psi.real(), psi.imag()};
  };
  for (Index l = 0; l <= order_; ++l) {
    Complex phi{}, psi{};
    double h = 1.0;  // H_lk
    for (Index k = 1; k <= order_; ++k) {
      if ((k + l) % 2 == 0) {
        const double factor = k % 2 == 0 ? h : -h;
        const Complex s = sums_.s[k + l], t = sums_.t[k + l + 1];
        phi += factor * (s * a(k));
        psi += factor * (s * b(k) - static_cast<double>(k + l) * (t * a(k)));
      }
      h *= static_cast<double>(k + l) / static_cast<double>(k);
    }
    if (l % 2 == 0) psi += sums_.t[l + 1] * a(0);
    if (l % 2 == 0 && l > 0) {
      const Complex s = sums_.s[l] / static_cast<double>(l);
      phi -= s * a(0);
      psi -= s * b(0);
    }
    add(l, phi, psi);
  }
  add(0, share_ * b(2) - 2.0 * constant_ * a(0), 0.0);
  add(1, -0.5 * share_ * b(1).imag() * imaginary, share_ * std::conj(a(1)));
  add(2, 0.5 * share_ * std::conj(a(0)), 0.0);
}

FmmImagePlan images_in(const Lattice& lattice) {
  return [lattice](double radius, int order) {
    return FmmImages{near_images(lattice, radius), FarOperator(lattice, radius, order)};
  };
}

}  // namespace stokesbook
