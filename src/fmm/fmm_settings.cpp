#include "fmm/fmm_settings.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace stokesbook {

FmmSettings FmmSettings::for_tolerance(double tolerance) {
  if (!(tolerance > 0.0)) {
    throw std::invalid_argument("the tolerance of an FMM must be > 0, got " +
                                std::to_string(tolerance));
  }
  const double digits = -std::log10(std::clamp(tolerance, 1e-14, 1.0));
  const int order = std::max(3, static_cast<int>(std::ceil(3.03 * digits - 2.6)));
  return {order, 2 * order + 15};
}

Eigen::Index break_even(const FmmSettings& settings) {
  return 240 + 16 * settings.order;
}

}  // namespace stokesbook
