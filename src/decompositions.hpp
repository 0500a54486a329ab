#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

// The compilation of Eigen's decompositions takes many seconds, so they are compiled once, in
// decompositions.cpp. No source includes this header, because it is precompiled.
extern template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
extern template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>&
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>::compute(const Eigen::EigenBase<Eigen::MatrixXd>&,
                                                        int);
