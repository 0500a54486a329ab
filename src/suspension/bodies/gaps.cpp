// Finds the pairs of components whose gap may be within the reach of their trapezoid rules (06.5),
// and the closest pair. Bounding circles and an R-tree select the pairs, and closest_points()
// measures their gaps (chapter 06, section "Sums over bodies").
#include "suspension/bodies/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "near_singular/near_field.hpp"
#include "stiv/separation.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

bool encloses(const DiscretisedShape& discretised) {
  return discretised.curve.side == Side::fluid_inside;
}

// Returns squares about the bounding circles of the components. The rectangle of an enclosing wall
// contains all squares, so that the wall is a neighbour of every component.
std::vector<Rectangle> rectangles_of(const Configuration& configuration,
                                     const Discretisation& discretisation) {
  std::vector<Rectangle> rectangles;
  ComplexVector corners(2 * static_cast<Eigen::Index>(discretisation.size()));
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    rectangles.push_back(
        square_about(configuration[k].position, outer_radius(discretisation[k]->curve, 0.0)));
    corners.segment<2>(2 * static_cast<Eigen::Index>(k)) << rectangles[k].lower,
        rectangles[k].upper;
  }
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    if (encloses(*discretisation[k])) rectangles[k] = bounding_rectangle(corners);
  }
  return rectangles;
}

// Selects pairs by the bounding circles of the components and the reach of their trapezoid rules.
class BroadPhase {
 public:
  BroadPhase(const Configuration& configuration, const Discretisation& discretisation,
             double tolerance)
      : configuration_(configuration),
        discretisation_(discretisation),
        rectangles_(rectangles_of(configuration, discretisation)),
        index_(rectangles_) {
    for (const auto& discretised : discretisation) {
      radius_.push_back(outer_radius(discretised->curve, 0.0));
      reach_.push_back(near_reach(discretised->curve, tolerance));
    }
  }

  // Returns a lower bound of a gap: the distance of the bounding circles; 0 for an enclosing wall,
  // whose bounding circle gives no bound of its gap to a body inside.
  double least_gap(const ComponentPair& pair) const {
    const auto [a, b] = pair;
    if (encloses(*discretisation_[a]) || encloses(*discretisation_[b])) return 0.0;
    return std::abs(configuration_[a].position - configuration_[b].position) - radius_[a] -
           radius_[b];
  }

  bool in_reach(const ComponentPair& pair) const {
    return least_gap(pair) < std::max(reach_[pair.first], reach_[pair.second]);
  }

  std::vector<ComponentPair> pairs_in_reach() const { return pairs_within(reach_); }

  // Returns the pairs out of reach whose gap may be less than a distance, in ascending order of
  // their lower bounds.
  std::vector<ComponentPair> pairs_beyond_reach(double distance) const {
    std::vector<ComponentPair> pairs = pairs_within(std::vector<double>(reach_.size(), distance));
    std::erase_if(pairs, [&](const ComponentPair& pair) { return in_reach(pair); });
    std::ranges::stable_sort(pairs, {}, [&](const ComponentPair& pair) { return least_gap(pair); });
    return pairs;
  }

  double smallest_reach() const { return std::ranges::min(reach_); }

 private:
  // Returns the pairs whose lower bound is less than the distance of at least one of the two
  // components, in ascending order.
  std::vector<ComponentPair> pairs_within(const std::vector<double>& distance) const {
    std::vector<ComponentPair> pairs;
    for (std::size_t a = 0; a < distance.size(); ++a) {
      for (const std::size_t b : index_.meeting(widened(rectangles_[a], distance[a]))) {
        const ComponentPair pair = std::minmax(a, b);
        const double gap = least_gap(pair);
        // If both components find each other, only the one with the smaller number adds the pair.
        if (b != a && gap < distance[a] && (a < b || gap >= distance[b])) pairs.push_back(pair);
      }
    }
    std::ranges::sort(pairs);
    return pairs;
  }

  const Configuration& configuration_;
  const Discretisation& discretisation_;
  std::vector<Rectangle> rectangles_;
  RectangleIndex index_;
  std::vector<double> radius_, reach_;
};

bool is_narrower(const Gap& p, const Gap& q) {
  return p.points.gap < q.points.gap;
}

// Returns the closest of the pairs out of reach if its gap is less than a bound.
std::optional<Gap> closest_beyond_reach(const BroadPhase& broad,
                                        const std::vector<SmoothCurve>& curves, double bound) {
  std::optional<Gap> closest;
  // The search distance doubles, because for distant bodies no bound on the gap is known
  // beforehand.
  for (double within = std::min(bound, broad.smallest_reach());;
       within = std::min(bound, 2.0 * within)) {
    for (const ComponentPair& pair : broad.pairs_beyond_reach(within)) {
      if (broad.least_gap(pair) >= bound) break;
      const Gap gap{pair.first, pair.second,
                    closest_points(curves[pair.first], curves[pair.second])};
      if (gap.points.gap >= bound) continue;
      closest = gap;
      bound = gap.points.gap;
    }
    if (within >= bound) return closest;
  }
}

}  // namespace

std::vector<Gap> find_gaps(const Configuration& configuration, const Discretisation& discretisation,
                           double tolerance) {
  if (configuration.size() < 2) return {};
  const BroadPhase broad(configuration, discretisation, tolerance);
  std::vector<SmoothCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    curves.push_back(smooth_curve(*discretisation[k], configuration[k]));
  }
  std::vector<Gap> gaps;
  for (const auto& [a, b] : broad.pairs_in_reach()) gaps.push_back({a, b, {}});
  const auto close_pairs = static_cast<std::ptrdiff_t>(gaps.size());
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t i = 0; i < close_pairs; ++i) {
    Gap& gap = gaps[static_cast<std::size_t>(i)];
    gap.points = closest_points(curves[gap.a], curves[gap.b]);
  }
  std::ranges::stable_sort(gaps, is_narrower);
  // A pair out of reach is added only if it is the closest of all pairs.
  const double bound =
      gaps.empty() ? std::numeric_limits<double>::infinity() : gaps.front().points.gap;
  if (const std::optional<Gap> closest = closest_beyond_reach(broad, curves, bound)) {
    gaps.insert(gaps.begin(), *closest);
  }
  return gaps;
}

}  // namespace stokesbook
