#pragma once

#include <algorithm>

#include "fmm/fmm.hpp"
#include "support/ewald.hpp"
#include "support/point_sets.hpp"

namespace stokesbook::test {

/// Returns random points of the Voronoi cell of a centre.
inline ComplexVector points_in_cell(const Lattice& lattice, Complex centre, Eigen::Index n,
                                    unsigned seed) {
  ComplexVector points = random_vector(n, seed);
  for (Complex& z : points) {
    z = lattice.wrap(centre + z.real() * lattice.shortest() + z.imag() * lattice.second(), centre);
  }
  return points;
}

/// Returns random sources without a net source, in a Voronoi cell, whose velocities are of order
/// one in any unit of length.
inline PeriodicSources random_sources(const Lattice& lattice, Complex centre, Eigen::Index nodes,
                                      Eigen::Index points) {
  const double size = std::abs(lattice.shortest());
  PeriodicSources sources{lattice,
                          cloud(points_in_cell(lattice, centre, nodes, 1), 1e-6 * size),
                          1e6 * random_vector(nodes, 2),
                          {},
                          centre};
  const double mean = sources.net_source() / weights(sources.curve).sum();
  sources.density -= mean * normals(sources.curve);
  const ComplexVector places = points_in_cell(lattice, centre, points, 3);
  const ComplexVector random = random_vector(2 * points, 4);
  for (Eigen::Index i = 0; i < points; ++i) {
    sources.points.push_back({places[i], random[i], size * random[points + i].real()});
  }
  return sources;
}

/// Holds the point forces and torques of sources in the form that an Fmm requires.
struct PointStrengths {
  explicit PointStrengths(const PeriodicSources& sources)
      : positions(std::ssize(sources.points)), force(positions.size()), torque(positions.size()) {
    for (Eigen::Index i = 0; i < positions.size(); ++i) {
      const PointForce& point = sources.points[static_cast<std::size_t>(i)];
      positions[i] = point.position;
      force[i] = point.force;
      torque[i] = point.torque;
    }
  }
  ComplexVector positions, force;
  Eigen::VectorXd torque;
};

/// The largest errors of an Fmm with images at some targets, relative to the largest exact values.
struct PeriodicErrors {
  double velocity = 0.0;
  double derivatives = 0.0;  ///< of pressure, vorticity and strain
};

/// Compares an Fmm with Ewald sums. The pressure differs from the Ewald sum by the constant of
/// images_in().
inline PeriodicErrors errors(const PeriodicSources& sources, const ComplexVector& targets,
                             const FmmSettings& settings, const FmmImagePlan& images) {
  const PointStrengths strengths(sources);
  const Fmm fmm({sources.curve}, strengths.positions, targets, settings, images);
  const FmmStrengths all(sources.density, strengths.force, strengths.torque);
  const ComplexVector found = fmm.velocity(all);
  const std::vector<FlowDerivatives> slopes = fmm.derivatives(all);
  double constant = 0.0;
  for (const PointForce& point : sources.points) {
    constant += dot(point.force, point.position - fmm.cell().centre);
  }
  constant /= 2.0 * sources.lattice.area();
  double error = 0.0, scale = 0.0, slope_error = 0.0, slope_scale = 0.0;
  for (Eigen::Index i = 0; i < targets.size(); ++i) {
    const Complex exact = sources.velocity(targets[i]);
    error = std::max(error, std::abs(found[i] - exact));
    scale = std::max(scale, std::abs(exact));
    const FlowDerivatives slope = sources.derivatives(targets[i]);
    const FlowDerivatives& other = slopes[static_cast<std::size_t>(i)];
    slope_error = std::max({slope_error, std::abs(other.pressure - constant - slope.pressure),
                            std::abs(other.vorticity - slope.vorticity),
                            std::abs(other.strain - slope.strain)});
    slope_scale = std::max({slope_scale, std::abs(slope.pressure), std::abs(slope.strain)});
  }
  return {error / scale, slope_error / slope_scale};
}

}  // namespace stokesbook::test
