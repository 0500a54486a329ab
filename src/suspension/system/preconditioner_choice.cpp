// Chooses the preconditioner that takes the least time for a configuration, by its number of nodes
// and its narrow gaps (chapter 13, section "When it pays"). The numbers below are measured: the
// study of the chapter compares each choice with all others.
#include "suspension/system/preconditioner_choice.hpp"

#include <algorithm>
#include <cmath>

namespace stokesbook {

using Eigen::Index;

namespace {

/// Numbers of components, and of gaps between inner ones.
struct InnerGaps {
  std::size_t components;
  std::size_t wide = 0, narrow = 0, tight = 0;  // below 0.5, 0.05, 0.005 times smaller_radius()
};

using DiscretisedPointer = std::shared_ptr<const DiscretisedShape>;

bool is_prescribed(const DiscretisedPointer& discretised) {
  return discretised->kind == ComponentKind::prescribed;
}

bool is_enclosing_wall(const DiscretisedPointer& discretised) {
  return !is_inner(*discretised);
}

// Returns whether the farthest point of a body is more than 2.5 times as far from its centre as the
// nearest one.
bool is_elongated(const DiscretisedPointer& discretised) {
  const Eigen::ArrayXd distances = discretised->curve.x.cwiseAbs();
  return is_inner(*discretised) && distances.maxCoeff() > 2.5 * distances.minCoeff();
}

// Counts the pairs that a step may press together: their gaps are below 1.1 separations.
Index count_contacts(const std::vector<Gap>& gaps, double separation) {
  return std::ranges::count_if(gaps,
                               [&](const Gap& gap) { return gap.points.gap < 1.1 * separation; });
}

// Returns the smaller radius of gyration of the two components at a gap.
double smaller_radius(const Gap& gap, const Discretisation& discretisation) {
  return std::min(discretisation[gap.a]->gyration_radius, discretisation[gap.b]->gyration_radius);
}

InnerGaps count_inner_gaps(const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  InnerGaps counts{discretisation.size()};
  for (const Gap& gap : gaps) {
    if (!is_inner(*discretisation[gap.a]) || !is_inner(*discretisation[gap.b])) continue;
    const double radius = smaller_radius(gap, discretisation), width = gap.points.gap;
    if (width < 0.5 * radius) ++counts.wide;
    if (width < 0.05 * radius) ++counts.narrow;
    if (width < 0.005 * radius) ++counts.tight;
  }
  return counts;
}

}  // namespace

bool direct_pays(const Plan& plan, const std::vector<Gap>& gaps,
                 const Discretisation& discretisation, double separation) {
  // A tree of groups of free bodies takes less time for more nodes than this. Where there is one,
  // only tighter gaps, over the smaller radius of gyration, slow GMRES down so much that a
  // factorisation pays.
  const bool has_tree = plan.tree_allowed && std::ranges::none_of(discretisation, is_prescribed);
  constexpr Index few_nodes = 400;
  const Index most_nodes = has_tree ? few_nodes : 1000;
  const double largest_gap = has_tree ? 0.003 : 0.02;
  Index nodes = 0;
  for (const auto& discretised : discretisation) nodes += discretised->curve.size();
  if (nodes > most_nodes) return false;
  const auto narrow_gaps = std::ranges::count_if(gaps, [&](const Gap& gap) {
    return gap.points.gap < largest_gap * smaller_radius(gap, discretisation);
  });
  const Index components = std::ssize(discretisation);
  if (3 * narrow_gaps >= components) return true;
  // Contact forces take several solves, and where most bodies touch, many.
  constexpr Index nodes_at_contact = 256;
  const Index contacts = count_contacts(gaps, separation);
  return contacts > 0 && nodes <= (contacts >= components ? few_nodes : nodes_at_contact);
}

bool tree_pays(const Plan& plan, const std::vector<Gap>& gaps, const Discretisation& discretisation,
               double separation) {
  constexpr Index most_nodes = 256;
  // Tight or narrow gaps slow GMRES down so much that a tree pays, if there is one for this number
  // of components. With few digits, narrow gaps do so between elongated bodies alone.
  constexpr std::size_t components_a_tight_gap = 60, components_a_narrow_gap = 12;
  constexpr double few_digits = 5.5;
  // Many wide gaps between many components do so, too, unless most components are far from all
  // others. The number of iterations and the time of each grow with the number of digits.
  constexpr std::size_t components_a_wide_gap = 10;
  constexpr double many = 245e3;
  // Within a wall, many bodies move little under smooth loads, and GMRES takes few iterations
  // without a tree, unless elongated bodies lock each other. The loads of contact are not smooth.
  constexpr double many_within_wall = 3.0;
  const double digits = -std::log10(plan.gmres_tolerance);
  // Contact forces may take many solves, which share a tree: near a wall, whose film moves little,
  // and where most bodies touch. Elsewhere pairs that stay in contact take few.
  const Index contacts = count_contacts(gaps, separation);
  const bool in_wall = std::ranges::any_of(discretisation, is_enclosing_wall);
  const bool in_contact = contacts >= (in_wall ? 2 : std::ssize(discretisation));
  if (std::ranges::any_of(discretisation, [](const DiscretisedPointer& discretised) {
        return is_inner(*discretised) && discretised->curve.size() > most_nodes;
      })) {
    return false;
  }
  const InnerGaps inner = count_inner_gaps(gaps, discretisation);
  const std::size_t count = inner.components;
  const bool has_elongated = std::ranges::any_of(discretisation, is_elongated);
  if (!in_contact && in_wall && static_cast<double>(count) > many_within_wall * digits * digits) {
    return has_elongated && 2 * inner.narrow >= 3 * count;
  }
  return components_a_tight_gap * inner.tight >= count ||
         (components_a_narrow_gap * inner.narrow >= count &&
          (digits > few_digits || has_elongated)) ||
         (components_a_wide_gap * inner.wide >= count &&
          (in_contact || digits * digits * static_cast<double>(count * inner.wide) >= many));
}

bool tree_lasts(const Configuration& earlier, const Configuration& configuration,
                const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  constexpr double most_lengths = 2.0;
  const auto displacement = [&](std::size_t k) {
    return configuration[k].position - earlier[k].position;
  };
  // Path of the boundary by the rotation of a component.
  const auto turned = [&](std::size_t k) {
    return discretisation[k]->gyration_radius *
           std::abs(configuration[k].orientation - earlier[k].orientation);
  };
  return std::ranges::all_of(gaps, [&](const Gap& gap) {
    const double moved =
        std::abs(displacement(gap.a) - displacement(gap.b)) + turned(gap.a) + turned(gap.b);
    const double length = std::sqrt(gap.points.gap * smaller_radius(gap, discretisation));
    return moved < most_lengths * length;
  });
}

bool is_crystal(const std::vector<Gap>& gaps, const Discretisation& discretisation) {
  constexpr std::size_t most_in_tree = 30;
  const InnerGaps inner = count_inner_gaps(gaps, discretisation);
  return inner.components > most_in_tree && std::ranges::none_of(discretisation, is_prescribed) &&
         inner.tight >= 2 * inner.components;
}

PreconditionerKind chosen_preconditioner(const Plan& plan, const std::vector<Gap>& gaps,
                                         const Discretisation& discretisation, double separation) {
  if (plan.direct_allowed && direct_pays(plan, gaps, discretisation, separation)) {
    return PreconditionerKind::direct;
  }
  if (plan.tree_allowed && tree_pays(plan, gaps, discretisation, separation)) {
    return is_crystal(gaps, discretisation) ? PreconditionerKind::clusters
                                            : PreconditionerKind::hierarchical;
  }
  return plan.preconditioner;
}

HierarchySettings hierarchy_settings(const std::vector<Gap>& gaps,
                                     const Discretisation& discretisation) {
  const InnerGaps inner = count_inner_gaps(gaps, discretisation);
  const std::size_t count = inner.components;
  if (inner.narrow >= count) {
    return {.tolerance = 0.55, .group_tolerance = 0.33, .reach = 1.5};
  }
  // A chain with tight gaps amplifies what is left out, and few directions couple its groups.
  if (2 * inner.tight >= count && inner.wide < count) {
    // The last inverse is large, as no further level is accurate enough, but takes less than 0.25 MB
    // for each component.
    const double root = std::min(2500.0, 350.0 * std::sqrt(static_cast<double>(count)));
    return {.tolerance = 0.2, .group_tolerance = 0.06, .root = static_cast<Index>(root)};
  }
  // With the same tolerances, iterations would grow with the number of components.
  constexpr double few = 500.0;
  const double times = std::max(1.0, static_cast<double>(count) / few);
  const double fall = std::pow(times, -0.1);
  HierarchySettings settings;
  settings.tolerance *= fall;
  settings.group_tolerance *= fall;
  return settings;
}

}  // namespace stokesbook
