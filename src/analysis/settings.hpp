#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace stokesbook {

/// The settings on which the accuracy and the cost of a run depend.
struct Settings {
  SteppingMethod method = SteppingMethod::dormand_prince54;  ///< method that advances the bodies
  bool adaptive = true;         ///< whether `step` is time.tolerance; otherwise it is time.dt
  double step = 0.0;            ///< time.tolerance or time.dt
  double solver = 0.0;          ///< solver.tolerance
  std::vector<int> nodes = {};  ///< of each body, then of each wall; empty: automatic
};

/// Describes settings in one line, "dormand_prince54, time.tolerance 0.001, ...".
std::string to_text(const Settings& settings);

/// Returns a scene with other settings, and with global coupling. The result has no bounds on its
/// steps; with contact, where adapted steps require a longest step, time.dt is that of the scene.
/// @param  scene  a scene with [time] and without fills
Scene with_settings(Scene scene, const Settings& settings);

/// Returns a scene that writes nothing but tables, for runs with other numbers of nodes.
/// @throws SceneError when contact.minimum_separation is in node spacings: other numbers of nodes
///         would change the separation
Scene with_tables_only(Scene scene);

/// Returns a scene with tighter tolerances, whose run shows the error of the scene's own run:
/// solver.tolerance and GMRES' tolerance are a hundredth, time.tolerance is a tenth, or time.dt is
/// half, and all numbers of nodes are automatic. Only tables are written.
/// @param  scene  a scene with [time] and without fills
/// @throws SceneError as with_tables_only() does, when the scene writes no tables, and when it adapts
///         its steps by effort, whose bounds do not limit the error
Scene tightened(Scene scene);

}  // namespace stokesbook
