#include "record/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

std::string viridis_colour(double fraction) {
  constexpr std::string_view digits = "0123456789abcdef";
  const double place = std::clamp(fraction, 0.0, 1.0) * (viridis.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double value = std::lerp(viridis[left][channel], viridis[left + 1][channel],
                                   place - static_cast<double>(left));
    const auto byte = static_cast<std::size_t>(std::lround(value));
    colour += {digits[byte / 16], digits[byte % 16]};
  }
  return colour;
}

}  // namespace stokesbook
