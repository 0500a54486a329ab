// Plants defects in the sum over far images: terms that are left out, a sum in the wrong order, and
// images that are near but are treated as far.
#include "defects.hpp"

#include <numbers>

#include "periodic/far_operator.hpp"

namespace stokesbook::verification::periodic {

using Eigen::Index;
using Eigen::Ref;

namespace {

constexpr double pi = std::numbers::pi;

double share(const Lattice& lattice, double radius) {
  return pi * radius * radius / lattice.area();
}

Complex phi_coefficient(Ref<const Expansion> multipole, Index k) {
  return {multipole(0, k), multipole(1, k)};
}

Complex psi_coefficient(Ref<const Expansion> multipole, Index k) {
  return {multipole(2, k), multipole(3, k)};
}

void add(Ref<Expansion> local, Index l, Complex phi, Complex psi) {
  local.col(l) += Coefficients{phi.real(), phi.imag(), psi.real(), psi.imag()};
}

}  // namespace

FmmImagePlan images_with(const Lattice& lattice, Defect defect) {
  if (!defect) return images_in(lattice);
  return [=](double radius, int order) {
    FmmImages images = images_in(lattice)(radius, order);
    images.far = [=, far = images.far](Ref<const Expansion> multipole, Ref<Expansion> local) {
      far(multipole, local);
      defect(lattice, radius, multipole, local);
    };
    return images;
  };
}

void without_the_layer(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                       Ref<Expansion> local) {
  add(local, 1, 0.0, -share(lattice, radius) * std::conj(phi_coefficient(multipole, 1)));
}

void without_the_torques(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                         Ref<Expansion> local) {
  add(local, 1, 0.5 * share(lattice, radius) * psi_coefficient(multipole, 1).imag() * imaginary,
      0.0);
}

void without_the_forces(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                        Ref<Expansion> local) {
  add(local, 2, -0.5 * share(lattice, radius) * std::conj(phi_coefficient(multipole, 0)), 0.0);
}

void without_the_mean(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                      Ref<Expansion> local) {
  add(local, 0, -share(lattice, radius) * psi_coefficient(multipole, 2), 0.0);
}

void without_the_logarithm(const Lattice& lattice, double, Ref<const Expansion> multipole,
                           Ref<Expansion> local) {
  add(local, 0, 2.0 * logarithm_constant(lattice) * phi_coefficient(multipole, 0), 0.0);
}

void without_third_sum(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                       Ref<Expansion> local) {
  const double small = 0.2 * std::abs(lattice.shortest());  // of a disk without near images
  const Complex sum = far_sums(lattice, small, 2).t[3] * (radius / small) * (radius / small);
  add(local, 1, 0.0, -2.0 * sum * phi_coefficient(multipole, 1));
}

void sum_by_rows(const Lattice& lattice, double radius, Ref<const Expansion> multipole,
                 Ref<Expansion> local) {
  const Complex more = share(lattice, radius) * std::conj(lattice.shortest()) / lattice.shortest();
  add(local, 1, -more * phi_coefficient(multipole, 1), -more * psi_coefficient(multipole, 1));
  add(local, 2, -0.5 * more * phi_coefficient(multipole, 0),
      -0.5 * more * psi_coefficient(multipole, 0));
}

FmmImagePlan eight_neighbours(Complex a1, Complex a2) {
  const Lattice lattice(a1, a2);
  return [=](double radius, int order) {
    FmmImages images = images_in(lattice)(radius, order);
    std::vector<Box> left_out;
    const auto is_left_out = [&](Complex w) {
      const LatticeIndex index = lattice.index(w);
      return std::abs(index.first) > 1 || std::abs(index.second) > 1;
    };
    for (const Complex w : images.near) {
      if (!is_left_out(w)) continue;
      Box& box = left_out.emplace_back();
      box.centre = w;
      box.radius = radius;
    }
    std::erase_if(images.near, is_left_out);
    images.far = [=, far = images.far, translations = Translations(order)](
                     Ref<const Expansion> multipole, Ref<Expansion> local) {
      far(multipole, local);
      Expansions copies(std::ssize(left_out), 1, order);
      std::vector<Index> list;
      for (Index k = 0; k < std::ssize(left_out); ++k) {
        copies(k, 0) = multipole;
        list.push_back(k);
      }
      Box cell;
      cell.radius = radius;
      translations.m2l(left_out, copies, list, 0, cell, local);
    };
    return images;
  };
}

}  // namespace stokesbook::verification::periodic
