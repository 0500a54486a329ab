#pragma once

#include <functional>
#include <vector>

#include "scene/scene.hpp"
#include "time_stepping/step.hpp"

namespace stokesbook::verification::time_stepping {

/// Describes a motion whose solution is known.
struct Motion {
  Rate rate;              ///< right-hand side
  Eigen::VectorXd start;  ///< state at t = 0; its entries are of order 1 on the scale of the error
  double t_final;         ///< time at the end
  std::function<Eigen::VectorXd(double t)> exact;  ///< exact value of the compared quantities at t
  std::function<Eigen::VectorXd(const Eigen::VectorXd& state)>
      compared;                       ///< selects the compared quantities of a state
  std::vector<double> known_at = {};  ///< times at which the solution is known; empty: all times
};

/// Returns the motion by Jeffery's equation of an ellipse 3:1 in shear of rate 1 (C9). The ellipse
/// starts from its state at the time t_start after theta = 0.
Motion jeffery_in_shear(double t_final, double t_start = 0.0);

/// Returns the motion by Jeffery's equation in extension, theta' = -B sin 2 theta, from
/// theta = 1.2.
Motion jeffery_in_extension(double t_final);

/// Returns the motion of two unit circles that approach each other on the x axis of u = (-x, y),
/// from a distance of 4, by full solves (C13). The compared quantity is the distance.
Motion approaching_circles(double t_final);

/// Returns the scene of two unit circles that pass each other in shear, u = (y, 0), in 12 units of
/// time (NT1).
Scene passing_circles();

/// Returns the motion of passing_circles() by full solves. The compared quantities are the position
/// of the first circle in radii, and its angle. The reference at t = 12 is from an independent code
/// (NT1); the references at 0.5, 1, ..., 11.5 are computed by the pair 8(7) to 1e-12.
Motion passing();

/// Returns the motion of nine circles in three rows that slide past each other in shear, by full
/// solves. The reference at the end is computed by the pair 8(7).
Motion nine_circles();

/// Returns the motion of six ellipses in a Couette cell whose outer wall turns by one radian, by
/// full solves. The reference at the end is computed by the pair 8(7).
Motion couette_cell();

/// Returns the right-hand side of a scene, by full solves.
Rate solved_rate(const Scene& scene);

/// Returns the state of a scene at the start.
Eigen::VectorXd start_of(const Scene& scene);

}  // namespace stokesbook::verification::time_stepping
