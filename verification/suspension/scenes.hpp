#pragma once

#include <numbers>
#include <random>
#include <string>

#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/solver.hpp"
#include "suspension/system/error_estimate.hpp"

namespace stokesbook::verification::suspension {

/// Node spacing of the published runs of disks of radius 1/2.
inline constexpr double node_spacing = std::numbers::pi / 32;

/// A number between two bounds, the same on every machine.
double uniform(std::mt19937_64& random, double low, double high);

/// The same, of a uniform logarithm.
double log_uniform(std::mt19937_64& random, double low, double high);

/// A scene file of chapter 12, as it is shipped.
SceneFile shipped_file(const std::string& name);

/// Its scene, with the bodies of its fills.
Scene shipped_scene(const std::string& name);

/// The crowd in extension that is shipped, its ellipses in place: all alike, in a strain of rate 1
/// along x.
const Scene& shipped_crowd();

/// Gives all bodies and all walls so many nodes.
Scene with_nodes(Scene scene, int a_body, int a_wall);

/// Two to five circles, ellipses up to 6:1 and stars at gaps from 1e-3 to 1, in shear or extension
/// or in a container; free, loaded or held. Asks for solutions as good as rounding allows, with 16
/// nodes a component.
Scene random_scene(std::mt19937_64& random);

/// Two or three slender, lobed or angular bodies at gaps from 1e-2 to 3, in shear or extension, free
/// or pushed against each other. Half of the scenes have automatic nodes, the others 8 to 200 a
/// body, with tolerances from 1e-6 to 3e-2. Ellipses are as slender as a ratio of their axes, and
/// take the square of the nodes that it asks for.
Scene hard_scene(std::mt19937_64& random, double slenderest);

/// A solution of a scene's start at given nodes.
struct Solved {
  LinearSystem discrete;
  GmresResult gmres;
  ComplexVector density;
  Completion completion;
  double scale;  ///< largest velocity in the data
};

/// Solves the start at given nodes, whatever its error.
Solved solved_at(const SuspensionSolver& solver, const Resolutions& resolutions,
                 double gmres_tolerance);

/// Gives components so many times their nodes.
Resolutions times(double factor, Resolutions resolutions);

/// Error of a solution, relative to its scale, against one at other nodes.
double error(const Solved& solved, const Completion& reference);

}  // namespace stokesbook::verification::suspension
