#pragma once

#include <array>
#include <string>

namespace stokesbook {

/// @addtogroup record
/// @{

/// A colour map: colours for numbers from 0 to 1.
struct ColourMap {
  const char* name;                           ///< one word
  std::array<std::array<int, 3>, 9> samples;  ///< equidistant: red, green and blue, 0 to 255
};

/// The map viridis, dark to light with equal perceptual distances
/// (S. van der Walt and N. Smith, CC0).
inline constexpr ColourMap viridis{"viridis",
                                   {{{0x44, 0x01, 0x54},
                                     {0x47, 0x2d, 0x7b},
                                     {0x3b, 0x52, 0x8b},
                                     {0x2c, 0x72, 0x8e},
                                     {0x21, 0x91, 0x8c},
                                     {0x28, 0xae, 0x80},
                                     {0x5e, 0xc9, 0x62},
                                     {0xad, 0xdc, 0x30},
                                     {0xfd, 0xe7, 0x25}}}};

/// A map for numbers with a sign: blue below zero, red above; zero is grey and lies at 0.5
/// (K. Moreland, Diverging Color Maps for Scientific Visualization, 2009).
inline constexpr ColourMap cool_to_warm{"cool-to-warm",
                                        {{{0x3b, 0x4c, 0xc0},
                                          {0x62, 0x82, 0xea},
                                          {0x8d, 0xb0, 0xfe},
                                          {0xb8, 0xd0, 0xf9},
                                          {0xdd, 0xdd, 0xdd},
                                          {0xf5, 0xc4, 0xad},
                                          {0xf4, 0x9a, 0x7b},
                                          {0xde, 0x60, 0x4d},
                                          {0xb4, 0x04, 0x26}}}};

/// Returns the colour of a fraction, by linear interpolation between the samples of a map.
///
/// @param  map       the colour map
/// @param  fraction  0 to 1; any number outside has the colour of the nearer end
/// @return           `#rrggbb`
std::string colour(const ColourMap& map, double fraction);

/// @}

}  // namespace stokesbook
