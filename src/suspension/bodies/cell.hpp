#pragma once

#include <optional>
#include <vector>

#include "closure/problem.hpp"
#include "periodic/lattice.hpp"
#include "scene/scene.hpp"
#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

/// Returns the lattice of a cell.
Lattice lattice_of(const PeriodicCell& cell);

/// Returns the centre of a scene's cell: that of the undisturbed flow, or else the origin, length.
Complex cell_centre(const Scene& scene);

/// Returns the periodic cell of a scene at a time; none in scenes without a cell.
///
/// The undisturbed flow with the gradient G carries the lattice along, whatever the bodies do:
/// \f$ a(t) = e^{Gs}a(0) \f$ with s by flow_time(). The vectors are exact up to rounding, and grow
/// without bound in a shear: the reduced basis of lattice_of() does not.
std::optional<PeriodicCell> cell_at(const Scene& scene, double t);

/// Returns the velocity G w, length / time, of an image relative to the component from which the
/// lattice vector w leads to the image, for the flow factor 1.
Complex image_velocity(const Scene& scene, Complex vector);

/// The difference between a component on its path and the image of the component in the cell.
struct PathShift {
  Complex vector;    ///< lattice vector w from the image to the component, length
  Complex velocity;  ///< velocity G w of the component relative to the image, for the flow factor 1
};

/// Returns the lattice of a scene at a time; none in scenes without a cell.
std::optional<Lattice> lattice_at(const Scene& scene, double t);

/// Finds the image of each component that is nearest to the cell_centre().
///
/// @param  paths  places of the components on paths that do not jump where a body leaves the cell
std::vector<PathShift> path_shifts(const Scene& scene, const PeriodicCell& cell,
                                   const Configuration& paths);

/// The lattices at the beginning and at the end of a step.
struct LatticeStep {
  Lattice start;  ///< at the beginning
  Lattice end;    ///< at the end

  /// Returns by how much an image moves relative to its component, length.
  Complex displacement(LatticeIndex image) const { return end.vector(image) - start.vector(image); }

  /// Returns the vector that a vector of the first lattice becomes in the second one, length.
  Complex at_end(Complex vector) const { return end.vector(start.index(vector)); }
};

/// Returns the lattices of a step; none without lattices.
std::optional<LatticeStep> lattice_step(const std::optional<Lattice>& start,
                                        const std::optional<Lattice>& end);

/// The components on their paths at a time, and the lattice with which they repeat.
struct Placement {
  Configuration paths;               ///< poses on paths that do not jump
  std::optional<Lattice> lattice{};  ///< none: nothing repeats

  /// Returns the pose of component k, moved by a lattice vector.
  Pose image(std::size_t k, LatticeIndex index) const {
    const auto [position, orientation] = paths[k];
    return {lattice ? position + lattice->vector(index) : position, orientation};
  }
};

}  // namespace stokesbook
