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

/// Returns circles of radii 1 and 2 away from the origin, with centres on an oblique line. Both
/// circles move.
/// @param  relative_gap  the least gap relative to the gap of concentric circles
test::EccentricAnnulus eccentric_annulus(double relative_gap);

/// Returns d = log(R_2 / (R_1 + e)) (04.11): the imaginary part of the outer circle's parameter at
/// the nearest point of the inner circle.
double wall_distance(const test::EccentricAnnulus& annulus);

/// Returns the error for N nodes on each circle.
using ErrorOfNodes = std::function<double(Eigen::Index)>;

/// Measures over even N from first / rate to last / rate, as equidistant as possible.
/// @param  curves  number of curves with N nodes each
study::Measure over_nodes(double rate, double first, double last, const ErrorOfNodes& error,
                          int curves = 2);

/// Measures at given N.
study::Measure over_nodes(const std::vector<Eigen::Index>& counts, const ErrorOfNodes& error,
                          int curves = 2);

/// Measures at given points, the same in a quick study and in a full one.
study::Measure over(const std::vector<double>& points, const std::function<double(double)>& error);

/// Returns the matrix of an annulus' reduced system with N_0, or with a defect.
using AnnulusMatrix = Eigen::MatrixXd (*)(const StokesProblem&);

/// @name Matrices of an annulus: the correct matrix, and planted defects
/// @{
Eigen::MatrixXd right_matrix(const StokesProblem& problem);
/// N_0 has the opposite sign.
Eigen::MatrixXd matrix_with_other_sign(const StokesProblem& problem);
/// N_0 is missing.
Eigen::MatrixXd matrix_without_n0(const StokesProblem& problem);
/// N_0 lacks the integral: -n (n . eta) at every node.
Eigen::MatrixXd matrix_with_local_n0(const StokesProblem& problem);
/// N_0 contains the mean of the density instead of its normal part: -<eta>.
Eigen::MatrixXd matrix_with_mean(const StokesProblem& problem);
/// The wall's normal points into the fluid.
Eigen::MatrixXd matrix_with_turned_wall(const StokesProblem& problem);
/// @}

/// Returns the factor of N_0 on a wall of the given length.
using Factor = double (*)(double length);

/// @name Factors of N_0 that differ from 1
/// @{
double zero_factor(double length);
/// Returns the factor of the unscaled term + \int n(x) n(y) . eta ds.
double unscaled_factor(double length);
/// @}

/// Holds a solved annulus.
struct AnnulusSolution {
  ComplexVector inner, outer;  ///< densities
  Load load;                   ///< of the inner circle on the fluid
};

/// Solves for the problem's data with a matrix.
AnnulusSolution solve_annulus(const StokesProblem& problem, const Eigen::MatrixXd& matrix);

/// Returns the velocity of a solved annulus away from the boundary.
ComplexVector velocity_at(const StokesProblem& problem, const AnnulusSolution& solution,
                          const ComplexVector& points);

/// Returns the flux of velocities or densities through a curve, \int n . v ds.
double flux_through(const Curve& curve, const ComplexVector& v);

/// Returns the difference of two loads relative to the second; torques count as forces at the
/// distance 1.
double relative_difference(const Load& load, const Load& exact);

}  // namespace stokesbook::verification::null_space
