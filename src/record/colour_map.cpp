// Interpolates a colour map linearly between its samples.
#include "record/colour_map.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

std::string colour(const ColourMap& map, double fraction) {
  constexpr std::string_view digits = "0123456789abcdef";
  const auto& samples = map.samples;
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double value = std::lerp(samples[left][channel], samples[left + 1][channel],
                                   place - static_cast<double>(left));
    const auto byte = static_cast<std::size_t>(std::lround(value));
    colour += {digits[byte / 16], digits[byte % 16]};
  }
  return colour;
}

}  // namespace stokesbook
