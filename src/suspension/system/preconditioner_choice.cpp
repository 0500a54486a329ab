// Chooses the preconditioner that takes the least time for a configuration, by its number of nodes
// and its narrow gaps (chapter 05, section "Bodies that nearly touch").
#include "suspension/system/preconditioner_choice.hpp"

#include <algorithm>

#include "suspension/system/clusters.hpp"

namespace stokesbook {

namespace {

// Gaps, over the smaller radius of gyration, that slow GMRES down so much that a factorisation
// pays, or clusters, or clusters in a crowd.
constexpr double tight_for_direct = 0.02, tight = 0.003, tight_in_crowd = 0.005;

// Gaps of pairs that a step may press together, over the separation.
constexpr double in_contact = 1.1;

// Most nodes of a factorised system, its most nodes per contact, and most nodes of a component in
// clusters.
constexpr Eigen::Index most_nodes_of_direct = 1000, most_nodes_a_contact = 400,
                       most_nodes_in_clusters = 256;

bool is_inner(const std::shared_ptr<const DiscretisedShape>& discretised) {
  return discretised->kind != ComponentKind::enclosing_wall;
}

// Counts the pairs whose gap is less than `reach` times the smaller radius of gyration.
std::size_t pairs_within(double reach, const std::vector<Gap>& gaps,
                         const Discretisation& discretisation) {
  return static_cast<std::size_t>(std::ranges::count_if(gaps, [&](const Gap& gap) {
    const double radius =
        std::min(discretisation[gap.a]->gyration_radius, discretisation[gap.b]->gyration_radius);
    return gap.points.gap < reach * radius;
  }));
}

std::vector<Gap> inner_gaps(const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  std::vector<Gap> inner;
  std::ranges::copy_if(gaps, std::back_inserter(inner), [&](const Gap& gap) {
    return is_inner(discretisation[gap.a]) && is_inner(discretisation[gap.b]);
  });
  return inner;
}

}  // namespace

bool direct_pays(const std::vector<Gap>& gaps, const Discretisation& discretisation,
                 double separation) {
  Eigen::Index nodes = 0;
  for (const auto& discretised : discretisation) nodes += discretised->curve.size();
  if (nodes > most_nodes_of_direct) return false;
  const auto contacts = std::ranges::count_if(
      gaps, [&](const Gap& gap) { return gap.points.gap < in_contact * separation; });
  return nodes <= most_nodes_a_contact * contacts ||
         3 * pairs_within(tight_for_direct, gaps, discretisation) >= discretisation.size();
}

bool clusters_pay(const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  if (std::ranges::any_of(discretisation, [](const auto& discretised) {
        return is_inner(discretised) && discretised->curve.size() > most_nodes_in_clusters;
      })) {
    return false;
  }
  const std::vector<Gap> inner = inner_gaps(gaps, discretisation);
  const std::size_t count = discretisation.size();
  if (count >= cluster_crowd && pairs_within(tight_in_crowd, inner, discretisation) > 0)
    return true;
  return 3 * pairs_within(tight, inner, discretisation) >= count;
}

PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation) {
  if (plan.direct_at_tight_gaps && direct_pays(gaps, discretisation, separation)) {
    return PreconditionerKind::direct;
  }
  if (plan.clusters_at_tight_gaps && clusters_pay(gaps, discretisation)) {
    return PreconditionerKind::clusters;
  }
  return plan.preconditioner;
}

}  // namespace stokesbook
