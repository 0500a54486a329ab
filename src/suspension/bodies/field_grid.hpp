#pragma once

#include "record/field.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Places the points of a grid in its box.
///
/// The first and last point along the longer side are the box's ends, and `resolution` points make
/// up that side. Cells are square: along the shorter side there are as many as fit it best, one at
/// least, and the grid is centred in the box, so that it ends within half a cell of the box's
/// corners.
/// @param  settings  box and resolution
/// @return           the grid
FieldGrid field_grid(const FieldSettings& settings);

/// @}

}  // namespace stokesbook
