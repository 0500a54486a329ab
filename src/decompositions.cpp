// Compiles Eigen's decompositions of dense matrices for all libraries of the book.
#include "decompositions.hpp"

template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
template Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>&
Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>::compute(const Eigen::EigenBase<Eigen::MatrixXd>&,
                                                        int);
