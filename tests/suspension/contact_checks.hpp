#pragma once

#include <optional>

#include "closure/closure.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::test {

/// Checks the conditions that contact must satisfy in every scene, for a run that has written all
/// of its steps:
/// - at all times, all gaps (by the curves' formulas) are at least the separation;
/// - contact forces push, and only across gaps that are hardly wider than the separation;
/// - the load that contact adds to each body equals the load computed from the list of contacts,
/// and the forces and torques of all contacts balance, including those on walls and held bodies;
/// - each step solved at most nine linear problems.
///
/// @param  least  gap that pairs keep if they begin nearer than the separation; if empty, the
///                separation
void check_contact(const Scene& scene, const RecordedRun& run, std::optional<double> least = {});

/// Returns the least gap of all written states, by the curves' formulas.
double least_gap(const Scene& scene, const RecordedRun& run);

/// Returns the largest contact force of a frame, or 0 if there is none.
double largest_force(const Frame& frame);

/// Returns the contact force on a component and its torque about a point, computed from the list of
/// contacts.
Load contact_load(const Frame& frame, const ContactParty& on, Complex about);

}  // namespace stokesbook::test
