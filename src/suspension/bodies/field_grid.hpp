#pragma once

#include "record/field.hpp"
#include "scene/scene.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Places the points of a grid in its box.
///
/// The longer side of the box has `resolution` points, the first and the last of them at its ends.
/// Cells are square. The shorter side has the number of cells that fits best, at least one. The
/// grid is centred in the box, so that the grid ends within half a cell of the box's corners.
/// @param  settings  box and resolution
/// @return           the grid
FieldGrid field_grid(const FieldSettings& settings);

/// @}

}  // namespace stokesbook
