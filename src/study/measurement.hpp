#pragma once

#include <limits>

namespace stokesbook::study {

/// @addtogroup study
/// @{

/// The value of a quantity that was not measured.
inline constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

/// A measurement of an experiment: the varied quantity, the error, and the costs.
struct Measurement {
  double x = 0.0;                  ///< the varied quantity: nodes, distance, tolerance
  double error = 0.0;              ///< in the norm and unit that the experiment names, >= 0
  double unknowns = unmeasured;    ///< size of the system or number of samples
  double operations = unmeasured;  ///< counted: kernel evaluations, matrix-vector products
  double seconds = unmeasured;     ///< for diagrams only: no claim is about seconds
};

/// @}

}  // namespace stokesbook::study
