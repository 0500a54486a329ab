// Records the residuals of restarted GMRES, iteration by iteration.
#include <algorithm>

#include "experiments.hpp"

namespace stokesbook::verification::krylov {

std::vector<double> restarted(const LinearMap& apply, const LinearMap& precondition,
                              const Eigen::VectorXd& b, int length, int iterations) {
  std::vector<double> history{1.0};
  Eigen::VectorXd residual = b;
  while (static_cast<int>(history.size()) <= iterations) {
    const int left = iterations + 1 - static_cast<int>(history.size());
    const GmresResult part = gmres(apply, precondition, residual, {0.0, std::min(length, left)});
    const double start = history.back();
    for (std::size_t k = 1; k < part.history.size(); ++k) {
      history.push_back(start * part.history[k]);
    }
    residual -= apply(part.solution);
  }
  return history;
}

}  // namespace stokesbook::verification::krylov
