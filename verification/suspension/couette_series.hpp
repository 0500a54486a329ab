#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace stokesbook::verification::suspension {

/// What a run of a Couette cell says at its written times, in thousandths, and what it took.
struct CouetteSeries {
  std::vector<double> revolutions, viscosity, order;
  std::vector<double>
      order_alone;  ///< if each body turned alone where it begins, see order_alone()
  long long steps = 0, gmres_iterations = 0, contact_iterations = 0;
  double seconds = 0.0;         ///< of a thread
  double least_gap = 0.0;       ///< by shapes' formulas, in separations; at most two
  double largest_estimate = 0;  ///< of the error of velocities, in tolerances
};

/// Runs a Couette cell whose outer wall turns with the rate 1.
CouetteSeries couette_series(const Scene& scene);

/// Order parameter of a Couette cell if each ellipse kept to its circle and turned by Jeffery's
/// equation in the shear that is there without bodies.
double order_alone(const Scene& scene, double t);

/// One of a series' columns, and its value without bodies.
struct CouetteProperty {
  std::vector<double> CouetteSeries::*values;
  double without;
};

inline constexpr CouetteProperty viscosity{&CouetteSeries::viscosity, 1000.0},
    order{&CouetteSeries::order, 0.0}, alone{&CouetteSeries::order_alone, 0.0};

/// Published means of a cell over the second revolution, in thousandths; NaN where there are none.
struct PrintedMeans {
  double viscosity, order;
};

inline constexpr double printed_unit = 10.0;  ///< of the last digit

/// The one of viscosity, or else of order.
inline double printed_of(const PrintedMeans& printed, const CouetteProperty& property) {
  return property.values == viscosity.values ? printed.viscosity : printed.order;
}

/// Mean of a property between two times, in revolutions.
double mean(const CouetteSeries& series, const CouetteProperty& property, double from, double to);

}  // namespace stokesbook::verification::suspension
