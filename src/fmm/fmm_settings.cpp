// Chooses the order of expansions and the size of leaves for a tolerance, and estimates the number
// of nodes above which the fast multipole method is faster than the direct sum (chapter 08).
#include "fmm/fmm_settings.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace stokesbook {

FmmSettings FmmSettings::for_tolerance(double tolerance) {
  if (!(tolerance > 0.0)) {
    std::ostringstream message;
    message << "the tolerance of an FMM must be > 0, got " << tolerance;
    throw std::invalid_argument(message.str());
  }
  constexpr double rounding = 1e-14;
  const double digits = -std::log10(std::clamp(tolerance, rounding, 1.0));
  const int order = std::max(3, static_cast<int>(std::ceil(3.03 * digits - 0.6)));
  return {order, 2 * order + 32};
}

Eigen::Index break_even(const FmmSettings& settings) {
  return 300 + 18 * settings.order;
}

}  // namespace stokesbook
