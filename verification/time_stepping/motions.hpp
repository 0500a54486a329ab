#pragma once

#include <functional>
#include <vector>

#include "scene/scene.hpp"
#include "time_stepping/rate.hpp"

namespace stokesbook::verification::time_stepping {

/// A motion whose solution is known.
struct Motion {
  Rate rate;              ///< right-hand side
  Eigen::VectorXd start;  ///< state at t = 0, of size one in the sense of an error's scale
  double t_final;         ///< end
  std::function<Eigen::VectorXd(double t)> exact;  ///< what is compared, at t
  std::function<Eigen::VectorXd(const Eigen::VectorXd& state)>
      compared;                       ///< what of a state is compared
  std::vector<double> known_at = {};  ///< times at which the solution is known; none: at all
};

/// Jeffery's equation of an ellipse 3:1 in shear of rate 1 (C9), from where it is at a time after
/// theta = 0.
Motion jeffery_in_shear(double t_final, double t_start = 0.0);

/// The same in extension, theta' = -B sin 2 theta, from theta = 1.2.
Motion jeffery_in_extension(double t_final);

/// Two unit circles that approach each other on the axis of u = (-x, y), from a distance of 4, by
/// full solves (C13); the distance is compared.
Motion approaching_circles(double t_final);

/// Scene of two unit circles that pass each other in shear, u = (y, 0), in 12 units of time (NT1).
Scene passing_circles();

/// Their motion by full solves: position of the first in radii, and its angle. Known at t = 12 from
/// an independent code (NT1), and at 0.5, 1, ..., 11.5 by the pair 8(7) to 1e-12.
Motion passing();

/// Nine circles in three rows that shear slides past each other, by full solves; known at the end,
/// by the pair 8(7).
Motion nine_circles();

/// Six ellipses in a Couette cell that turns a seventh of a turn, likewise.
Motion couette_cell();

/// Right-hand side of a scene by full solves.
Rate solved_rate(const Scene& scene);

/// State of a scene at the start.
Eigen::VectorXd start_of(const Scene& scene);

}  // namespace stokesbook::verification::time_stepping
