#pragma once

#include <string_view>

#include "scene/document.hpp"

namespace stokesbook::scene_text {

/// Returns the document with one value set from the command line.
///
/// @param  document  the document before
/// @param  setting   `time.dt=0.01`, `bodies.0.n_nodes=64` or `bodies[0].n_nodes=64`: path, `=`,
///                   value in TOML's syntax, or a word without quotation marks; missing tables
///                   of the path are added
/// @return           the document with the value set
/// @throws SceneError when the setting has another form, or its path does not fit the document
Node with_override(Node document, std::string_view setting);

}  // namespace stokesbook::scene_text
