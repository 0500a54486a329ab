#include "suspension/system/linear_system.hpp"

#include <stdexcept>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/solver_error.hpp"

namespace stokesbook {

GmresResult solve(const LinearSystem& discrete, const ComplexVector& rhs,
                  const GmresOptions& options, const ComplexVector& guess) {
  const LinearMap apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const ComplexVector velocity = discrete.system(deinterleaved(v));
    return interleaved(velocity);
  };
  try {
    return gmres(apply, discrete.precondition, interleaved(rhs), options, interleaved(guess));
  } catch (const std::domain_error& error) {
    throw SolverError(std::string(error.what()) +
                      "; components may be too close to each other for rounding");
  }
}

}  // namespace stokesbook
