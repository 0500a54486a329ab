#pragma once

#include "fmm/fmm.hpp"
#include "periodic/lattice.hpp"

namespace stokesbook::verification::periodic {

/// Changes the local expansion of the far images of a disk of the given radius.
using Defect = void (*)(const Lattice& lattice, double radius,
                        Eigen::Ref<const Expansion> multipole, Eigen::Ref<Expansion> local);

/// Returns the images of a cell with a planted defect; those of images_in() without one.
FmmImagePlan images_with(const Lattice& lattice, Defect defect);

/// @name Terms of the far operator that are left out (14.9), (14.10)
/// @{
void without_the_layer(const Lattice&, double, Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>);
void without_the_torques(const Lattice&, double, Eigen::Ref<const Expansion>,
                         Eigen::Ref<Expansion>);
void without_the_forces(const Lattice&, double, Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>);
void without_the_mean(const Lattice&, double, Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>);
void without_the_logarithm(const Lattice&, double, Eigen::Ref<const Expansion>,
                           Eigen::Ref<Expansion>);
/// @}

/// The sum T_3 over all images set to zero.
void without_third_sum(const Lattice&, double, Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>);

/// The sum S_2 by rows along the shortest vector.
void sum_by_rows(const Lattice&, double, Eigen::Ref<const Expansion>, Eigen::Ref<Expansion>);

/// Returns the images of a cell of which only the eight neighbours, in a given basis, are near.
FmmImagePlan eight_neighbours(Complex a1, Complex a2);

}  // namespace stokesbook::verification::periodic
