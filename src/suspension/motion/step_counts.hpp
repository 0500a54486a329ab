#pragma once

#include <set>
#include <utility>
#include <vector>

#include "record/run_data.hpp"
#include "suspension/contact/contact.hpp"
#include "suspension/solver/solver.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Begins to count what a step does.
///
/// @param  first    solution at its beginning
/// @param  seconds  wall time of that
/// @return          counts of that solve
StepInfo begun_step(const Solution& first, double seconds);

/// Adds a solve to what a step has done.
///
/// @param  step      so far
/// @param  solution  of the solve
/// @param  seconds   wall time of it
/// @return           counts with the solve
StepInfo with_solve(StepInfo step, const Solution& solution, double seconds);

/// Adds the contact of a stage to what a step has done.
///
/// @param  step     so far
/// @param  outcome  of the stage
/// @param  cost     of its responses, those of all tries
/// @param  seconds  wall time, likewise
/// @return          counts with these
StepInfo with_contact(StepInfo step, const ContactOutcome& outcome, const SolveCost& cost,
                      double seconds);

/// Adds what a try that was rejected has cost, nothing else of it.
///
/// @param  step      before the try
/// @param  rejected  the same with the try
/// @return           counts for the next try
StepInfo with_costs_of(StepInfo step, const StepInfo& rejected);

/// Adds what contact did in a stage of a step that is taken.
///
/// @param  step      so far
/// @param  outcome   of the stage
/// @param  duration  for which its forces act
/// @return           with residual, imbalances, power and energy
StepInfo with_forces(StepInfo step, const ContactOutcome& outcome, double duration);

/// Lists the pairs that are in contact.
///
/// @param  forces  of a stage
/// @return         pairs with a force between them, each once
std::set<std::pair<ContactParty, ContactParty>> pairs_in_contact(
    const std::vector<ContactForce>& forces);

/// @}

}  // namespace stokesbook
