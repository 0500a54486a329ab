#pragma once

#include <functional>
#include <stdexcept>

#include <Eigen/Core>

namespace stokesbook {

/// @addtogroup time_stepping
/// @{

/// Right-hand side of \f$ \dot q = f(t, q) \f$ (09.1): the rate of change, ordered as q.
using Rate = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& q)>;

/// A state at a time, with its rate of change.
struct TimePoint {
  double t = 0.0;         ///< time
  Eigen::VectorXd state;  ///< q, n numbers
  Eigen::VectorXd rate;   ///< f(t, q), n numbers
};

/// Thrown by a rate at a state for which the rate is not defined, for example if bodies overlap. A
/// step that meets such a state is repeated with half of its length.
class InadmissibleState : public std::runtime_error {
 public:
  /// Stores the message.
  using std::runtime_error::runtime_error;
};

/// @}

}  // namespace stokesbook
