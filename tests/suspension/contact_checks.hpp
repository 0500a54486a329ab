#pragma once

#include <optional>

#include "closure/closure.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::test {

/// Checks what contact must do in every scene, of a run that has written all of its steps:
/// - all gaps, by the curves' formulas, are the separation at least, at all times;
/// - forces push, and only across gaps that are hardly wider than the separation;
/// - what contact adds to the load of each body is what the list of contacts says, forces and
///   torques of all balance, those on walls and held bodies included;
/// - each step took at most nine linear problems.
///
/// @param  least  what all pairs keep that begin nearer than the separation; none: the separation
void check_contact(const Scene& scene, const RecordedRun& run, std::optional<double> least = {});

/// Least gap of all written states, by the curves' formulas.
double least_gap(const Scene& scene, const RecordedRun& run);

/// Largest force of contact of a frame; 0 without.
double largest_force(const Frame& frame);

/// Force of contact on a component, and its torque about a point, by the list of contacts.
Load contact_load(const Frame& frame, const ContactParty& on, Complex about);

}  // namespace stokesbook::test
