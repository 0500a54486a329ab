#pragma once

#include <vector>

#include "scene/scene.hpp"

namespace stokesbook::verification::suspension {

/// Time series of a Couette cell's run: properties at the written times, in thousandths, and the
/// cost of the run.
struct CouetteSeries {
  std::vector<double> revolutions, viscosity, order;
  std::vector<double>
      order_alone;  ///< if each body turned alone at its first place, see order_alone()
  long long steps = 0, gmres_iterations = 0, contact_iterations = 0;
  double seconds = 0.0;         ///< seconds of one thread
  double least_gap = 0.0;       ///< least gap by the shapes' formulas, in separations; at most two
  double largest_estimate = 0;  ///< largest error estimate of velocities, in tolerances
};

/// Runs a Couette cell whose outer wall turns at the rate 1.
///
/// @param  separation  gap that contact should keep; the unit of the least gap
CouetteSeries couette_series(const Scene& scene, double separation);

/// Returns the bodies with even numbers; leaving out the others is a planted defect.
std::vector<Body> every_other(const std::vector<Body>& bodies);

/// Returns the order parameter of a Couette cell if each ellipse stayed on its circle and turned by
/// Jeffery's equation in the shear of the cell without bodies.
double order_alone(const Scene& scene, double t);

/// A property of a series, and its value without bodies.
struct CouetteProperty {
  std::vector<double> CouetteSeries::*values;
  double without;
};

inline constexpr CouetteProperty viscosity{&CouetteSeries::viscosity, 1000.0},
    order{&CouetteSeries::order, 0.0}, alone{&CouetteSeries::order_alone, 0.0};

/// Published means of a cell over the second revolution, in thousandths; NaN if not published.
struct PrintedMeans {
  double viscosity, order;
};

inline constexpr double printed_unit = 10.0;  ///< unit of the last printed digit

/// Returns the printed mean of the viscosity or of the order parameter.
inline double printed_of(const PrintedMeans& printed, const CouetteProperty& property) {
  return property.values == viscosity.values ? printed.viscosity : printed.order;
}

/// Returns the mean of a property between two times, in revolutions.
double mean(const CouetteSeries& series, const CouetteProperty& property, double from, double to);

}  // namespace stokesbook::verification::suspension
