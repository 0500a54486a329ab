#pragma once

#include <array>
#include <string>

namespace stokesbook {

/// @addtogroup record
/// @{

/// Colours of equal perceptual distance, dark to light: nine equidistant samples of viridis
/// (S. van der Walt and N. Smith, CC0), as red, green and blue from 0 to 255.
inline constexpr std::array<std::array<int, 3>, 9> viridis{{{0x44, 0x01, 0x54},
                                                            {0x47, 0x2d, 0x7b},
                                                            {0x3b, 0x52, 0x8b},
                                                            {0x2c, 0x72, 0x8e},
                                                            {0x21, 0x91, 0x8c},
                                                            {0x28, 0xae, 0x80},
                                                            {0x5e, 0xc9, 0x62},
                                                            {0xad, 0xdc, 0x30},
                                                            {0xfd, 0xe7, 0x25}}};

/// Returns the colour of a fraction, linear between the samples of viridis.
///
/// @param  fraction  0 dark to 1 light; beyond, the colours of the ends
/// @return           `#rrggbb`
std::string viridis_colour(double fraction);

/// @}

}  // namespace stokesbook
