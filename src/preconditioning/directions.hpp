#pragma once

#include <Eigen/Core>

#include "preconditioning/far_field.hpp"

namespace stokesbook {

// The directions of a group are singular vectors of its couplings, which are found from their Gram
// matrix. Only the lower triangles of Gram matrices are written and read.

/// Adds products of columns with themselves to a Gram matrix.
void add_products(const Eigen::MatrixXf& columns, Eigen::MatrixXf& gram);

/// Adds the couplings of a group to all far groups together to a Gram matrix.
///
/// @param  expansions  n x FarField::size(): local expansions, or transposed multipole expansions,
///                     of n unknowns
void add_far_couplings(const Eigen::MatrixXf& expansions, const FarField& far_field,
                       Eigen::MatrixXf& gram);

/// Factorises a Gram matrix approximately as \f$ FF^T \f$. F has as few columns as leave a remainder
/// with diagonal entries of at most \f$ 0.16\,\tau^2 \f$.
Eigen::MatrixXf factor_of(double tau, Eigen::MatrixXf gram);

/// Returns an orthonormal basis of the left singular vectors of a factor with singular values above
/// \f$ \tau \f$.
Eigen::MatrixXf basis_above(double tau, const Eigen::MatrixXf& factor);

/// Does the same for the part of a factor that is orthogonal to the columns of another orthonormal
/// basis.
Eigen::MatrixXf basis_above(double tau, const Eigen::MatrixXf& factor,
                            const Eigen::MatrixXf& other);

/// Returns the columns of one matrix followed by those of another.
Eigen::MatrixXf side_by_side(const Eigen::MatrixXf& left, const Eigen::MatrixXf& right);

}  // namespace stokesbook
