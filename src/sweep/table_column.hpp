#pragma once

#include <filesystem>
#include <span>

#include "sweep/sweep.hpp"

namespace stokesbook {

/// Averages a function of time over an interval: the integral of its piecewise linear interpolant
/// (the trapezoid rule), divided by the length of the interval.
///
/// Before the first time the function is taken to have its first value, since `steps.csv` has no
/// row at t = 0.
/// @param  t     times, ascending, at least one
/// @param  y     values at these times
/// @param  from  beginning of the interval
/// @param  to    end of the interval, > from
/// @throws std::invalid_argument when the interval ends after the last time
/// @par Accuracy  exact if the function is linear between the times
double time_average(std::span<const double> t, std::span<const double> y, double from, double to);

/// Reads a quantity from the tables in the folder of a run that is done; nan if the scene does not
/// define the quantity.
///
/// @throws RecordError when the table cannot be read, has no row of the body or wall, or ends too
///         early
double value_of(const std::filesystem::path& run, const Quantity& quantity);

}  // namespace stokesbook
