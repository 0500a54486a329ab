#pragma once

#include "suspension/contact/contact.hpp"
#include "suspension/motion/instant_solver.hpp"

namespace stokesbook {

/// The contact of a stage, resolved or not.
struct StageContact {
  ContactOutcome outcome{};  ///< forces, and how their iteration ended
  Solution solution{};       ///< with the contact forces, where they are resolved
  SolveCost cost{};          ///< cost of the forces, and of the flow on more nodes
  double seconds = 0.0;      ///< wall time of the same
};

/// The flow and the contact of a stage.
struct StageSolution {
  TimedSolution flow;      ///< without contact forces, on as many nodes as they require
  StageContact contact{};  ///< its cost and time are those of all attempts
};

/// Solves the stages of steps with contact: finds the contact forces, and increases the number of
/// nodes until they resolve the forces.
class ContactStages {
 public:
  /// All arguments must outlive this.
  ContactStages(const SuspensionSolver& solver, const SuspensionContact& contact,
                InstantSolver& instants, RunStatistics& statistics)
      : solver_(solver), contact_(contact), instants_(instants), statistics_(statistics) {}

  /// Resolves the contact of a stage, again and again until nodes and GMRES tolerance suffice for
  /// the contact forces. Later solves begin with the nodes and the tolerance found here.
  ///
  /// @param  problem  without free velocity and guess
  /// @param  stage    flow of the stage; contact of earlier attempts, whose cost is added up
  /// @throws SolverError with the time, as SuspensionContact::resolve() does
  StageSolution resolve(const ContactStage& problem, StageSolution stage);

  /// Gives back the nodes, columns and GMRES tolerance that contact required, when contact is over
  /// or has lasted. This precedes the solve at the end of a step, since a resumed run begins with
  /// it.
  void relax(bool in_contact);

 private:
  StageContact find_forces(ContactStage problem, const Solution& flow);
  static bool is_estimate_due(const StageSolution& stage);
  Resolutions needed_resolutions(const StageSolution& stage) const;

  const SuspensionSolver& solver_;
  const SuspensionContact& contact_;
  InstantSolver& instants_;
  RunStatistics& statistics_;
};

}  // namespace stokesbook
