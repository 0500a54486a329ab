#pragma once

#include <string>

#include "record/field.hpp"

namespace stokesbook {

/// @addtogroup record
/// @{

/// Writes a field as VTK ImageData (XML, data in base64), for ParaView.
///
/// Point data: `in_fluid`, 0 or 1; `velocity`, whose third component is 0; and the scalars, by
/// their names in field_scalars. All arrays but the first hold the exact doubles.
/// @param  field  quantities on a grid
/// @return        text of a `.vti` file, about 11 bytes for each double
std::string field_vti(const Field& field);

/// @}

}  // namespace stokesbook
