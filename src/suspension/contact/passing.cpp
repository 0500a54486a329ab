// Finds steps that take bodies through each other. The space-time interference of chapter 10 tests
// the paths of a step, with polygons that are as coarse as the depth of an overlap allows.
#include "suspension/contact/passing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stiv/interferences.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/bodies/configuration.hpp"
#include "suspension/contact/gap_constraints.hpp"

namespace stokesbook {

namespace {

// Largest distance of a polygon from its curve, over the smallest radius of gyration.
constexpr double sag_of_passing = 1e-3;

// Depth of the deepest overlap that is not found, over this distance.
constexpr double accepted_sags = 10.0;

double smallest_radius(const Discretisation& discretisation) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& discretised : discretisation) {
    smallest = std::min(smallest, discretised->gyration_radius);
  }
  return smallest;
}

// Returns whether no gap can close. A gap shrinks by at most the sum of two displacements.
bool is_short(const ContactShapes& shapes, const Configuration& start, const Configuration& end,
              double closest) {
  double longest = 0.0;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double turn = std::abs(end[k].orientation - start[k].orientation);
    longest =
        std::max(longest, std::abs(end[k].position - start[k].position) + turn * shapes[k]->radius);
  }
  return 2.0 * longest < closest;
}

}  // namespace

PassingTest::PassingTest(const SuspensionSolver& solver)
    : solver_(solver),
      sag_(sag_of_passing * smallest_radius(solver.discretisation())),
      shapes_(contact_shapes(solver.discretisation(), sag_)) {}

std::string PassingTest::error(const Configuration& start, const Configuration& end,
                               double closest) const {
  if (is_short(shapes_, start, end, closest)) return {};
  const Eigen::VectorXd displacement = to_state(end) - to_state(start);
  const ContactRules rules{{sag_}, accepted_sags * sag_};
  const Interferences found =
      interferences(shapes_, straight_paths(start, displacement, 1.0), rules);
  const auto passing = std::ranges::find_if(found.contacts, &Contact::is_violated);
  if (passing == found.contacts.end()) return {};
  return component_of(solver_.scene(), passing->a).name() + " and " +
         component_of(solver_.scene(), passing->b).name() +
         " overlap or pass through each other within a step: take smaller steps, or give [contact]";
}

}  // namespace stokesbook
