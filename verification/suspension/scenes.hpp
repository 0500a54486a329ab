#pragma once

#include <numbers>
#include <random>
#include <string>

#include "study/study.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "suspension/solver/solver.hpp"
#include "suspension/system/error_estimate.hpp"

namespace stokesbook::verification::suspension {

/// Node spacing of the published runs with disks of radius 1/2.
inline constexpr double node_spacing = std::numbers::pi / 32;

/// Returns a random number, uniform between two bounds. The number is the same on every machine.
double uniform(std::mt19937_64& random, double low, double high);

/// Returns a random number with a uniform logarithm. The number is the same on every machine.
double log_uniform(std::mt19937_64& random, double low, double high);

/// Reads a scene file of chapter 12.
SceneFile shipped_file(const std::string& name);

/// Reads a scene of chapter 12, and places the bodies of its fills.
Scene shipped_scene(const std::string& name);

/// Returns the crowd in extension of chapter 12 with its ellipses in place. All ellipses are equal,
/// and the strain has the rate 1 along x.
const Scene& shipped_crowd();

/// Returns 120 ellipses at random places in a circular container that turns at a rate, 10 in the
/// quick size. The separation is 0.01.
Scene turning_ellipses(study::Size size, double rate = 1.0);

/// Sets the numbers of nodes of all bodies and of all walls.
Scene with_nodes(Scene scene, int a_body, int a_wall);

/// Generates two to five circles, ellipses up to 6:1 and stars at gaps from 1e-3 to 1, in shear or
/// extension or in a container; free, loaded or held. The tolerance is as tight as rounding errors
/// permit, with 16 nodes a component.
Scene random_scene(std::mt19937_64& random);

/// Generates two or three slender, lobed or angular bodies at gaps from 1e-2 to 3, in shear or
/// extension, free or pushed against each other. Half of the scenes have automatic nodes, and the
/// others have 8 to 200 nodes a body. Tolerances are 1e-6 to 3e-2. The quotient of an ellipse's
/// axes is at least `slenderest`; the cost grows as the square of the nodes that this quotient
/// requires.
Scene hard_scene(std::mt19937_64& random, double slenderest);

/// A solution of a scene's start at given nodes.
struct Solved {
  LinearSystem discrete;
  GmresResult gmres;
  ComplexVector density;
  Completion completion;
  double scale;  ///< largest velocity in the data
};

/// Solves the start on given nodes, and accepts any error.
Solved solved_at(const SuspensionSolver& solver, const Resolutions& resolutions,
                 double gmres_tolerance);

/// Multiplies the node numbers of all components by a factor.
Resolutions times(double factor, Resolutions resolutions);

/// Returns the difference between a solution and a reference on other nodes, relative to the scale
/// of the solution.
double error(const Solved& solved, const Completion& reference);

}  // namespace stokesbook::verification::suspension
