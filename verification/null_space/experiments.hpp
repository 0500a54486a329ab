#pragma once

#include <functional>
#include <vector>

#include "study/study.hpp"
#include "support/eccentric_annulus.hpp"

namespace stokesbook::verification::null_space {

/// @name Experiments of the study
/// @{
study::Experiment couette();
study::Experiment null_vectors();
study::Experiment bodies_in_wall();
study::Experiment without();
study::Experiment scale();
study::Experiment conditioning();
study::Experiment residuals();
study::Experiment iterations();
study::Experiment leak();
study::Experiment source();
study::Experiment eccentric();
study::Experiment density();
study::Experiment closing_gap();
study::Experiment balance();
study::Experiment choices();
study::Experiment work();
/// @}

/// Circles of radii 1 and 2, away from the origin, their centres on a slanted line, both moving.
/// @param  relative_gap  the least gap as a part of the gap between concentric ones
test::EccentricAnnulus eccentric_annulus(double relative_gap);

/// delta = log(R_2 / (R_1 + e)): the distance from the real axis at which the parameter of the
/// outer circle, made complex, finds the nearest point of the inner one.
double wall_distance(const test::EccentricAnnulus& annulus);

/// Error with N nodes on a circle.
using ErrorOfNodes = std::function<double(Eigen::Index)>;

/// Measures over even N with rate N from first to last, equidistant as far as they can be.
/// @param  curves  of N nodes each
study::Measure over_nodes(double rate, double first, double last, const ErrorOfNodes& error,
                          int curves = 2);

/// Measures over given N.
study::Measure over_nodes(const std::vector<Eigen::Index>& counts, const ErrorOfNodes& error,
                          int curves = 2);

/// Measures over given numbers, the same in a quick study and a full one.
study::Measure over(const std::vector<double>& points, const std::function<double(double)>& error);

/// The matrix of the reduced system of an annulus, with N_0; or with a defect.
using AnnulusMatrix = Eigen::MatrixXd (*)(const StokesProblem&);

/// @name Matrices of an annulus: the right one, and planted defects
/// @{
Eigen::MatrixXd right_matrix(const StokesProblem& problem);
/// N_0 of the other sign.
Eigen::MatrixXd matrix_with_other_sign(const StokesProblem& problem);
/// No N_0.
Eigen::MatrixXd matrix_without_n0(const StokesProblem& problem);
/// The integral forgotten: -n (n . eta) at every node.
Eigen::MatrixXd matrix_with_local_n0(const StokesProblem& problem);
/// The mean of the density instead of its normal part: -<eta>.
Eigen::MatrixXd matrix_with_mean(const StokesProblem& problem);
/// The wall's normal into the fluid.
Eigen::MatrixXd matrix_with_turned_wall(const StokesProblem& problem);
/// @}

/// Factor in front of N_0 on a wall of that length.
using Factor = double (*)(double length);

/// @name Factors that ought not to be
/// @{
double zero_factor(double length);
/// + \int n(x) n(y) . eta ds of the draft.
double draft_factor(double length);
/// @}

/// A solved annulus.
struct AnnulusSolution {
  ComplexVector inner, outer;  ///< densities
  Load load;                   ///< of the inner circle on the fluid
};

/// Solves for the problem's data with a matrix.
AnnulusSolution solve_annulus(const StokesProblem& problem, const Eigen::MatrixXd& matrix);

/// The velocity of a solved annulus away from the boundary.
ComplexVector velocity_at(const StokesProblem& problem, const AnnulusSolution& solution,
                          const ComplexVector& points);

/// Flux of velocities or densities through a curve, \int n . v ds.
double flux_through(const Curve& curve, const ComplexVector& v);

/// Distance of two loads relative to the second, torques as forces at the distance 1.
double relative_difference(const Load& load, const Load& exact);

}  // namespace stokesbook::verification::null_space
