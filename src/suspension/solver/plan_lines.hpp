#pragma once

#include <string>
#include <vector>

#include "suspension/system/plan.hpp"

namespace stokesbook {

/// One decision of a Plan with its reason, as text for the user.
struct PlanLine {
  std::string topic,  ///< subject of the decision
      decision,       ///< the decision
      reason;         ///< its reason
};

/// Explains all decisions of the plan of a scene, in the order in which a run prints them.
std::vector<PlanLine> plan_lines(const Plan& plan, const Scene& scene);

}  // namespace stokesbook
