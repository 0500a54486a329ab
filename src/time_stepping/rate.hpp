#pragma once

#include <functional>
#include <stdexcept>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// Right-hand side of \f$ \dot q = f(t, q) \f$: the rate of change, ordered as q.
using Rate = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& q)>;

/// A state at a time, and how fast it changes there.
struct TimePoint {
  double t = 0.0;         ///< time
  Eigen::VectorXd state;  ///< q, n numbers
  Eigen::VectorXd rate;   ///< f(t, q), n numbers
};

/// Thrown by a rate that is not defined at a state, as where bodies overlap: a step that meets such
/// a state is taken shorter.
class InadmissibleState : public std::runtime_error {
 public:
  /// Takes the message.
  using std::runtime_error::runtime_error;
};

/// @}

}  // namespace stokesbook
