#pragma once

#include <vector>

#include "krylov/gmres.hpp"
#include "study/study.hpp"

namespace stokesbook::verification::krylov {

/// @name Experiments of the study
/// @{
study::Experiment known_spectra();
study::Experiment least_residuals();
study::Experiment orthogonality();
study::Experiment residuals();
study::Experiment normality();
study::Experiment nine_by_form();
study::Experiment published_count();
study::Experiment one_body();
study::Experiment slender_bodies();
study::Experiment aspect_ratios();
study::Experiment restarts();
study::Experiment tolerances();
study::Experiment solvers();
study::Experiment costs_of_a_solve();
/// @}

/// Matrices that are constructed from a given spectrum have this order.
inline constexpr Eigen::Index matrix_order = 200;

/// Returns the relative residuals of GMRES that restarts after every `length` iterations. The list
/// contains the initial residual and the residual after each iteration.
std::vector<double> restarted(const LinearMap& apply, const LinearMap& precondition,
                              const Eigen::VectorXd& b, int length, int iterations);

}  // namespace stokesbook::verification::krylov
