// Finds the pairs of components whose gap may be within the reach of their trapezoid rules (06.5),
// and the closest pair. Bounding circles and an R-tree select the pairs, and closest_points()
// measures their gaps (chapter 06, section "Sums over bodies").
#include "suspension/bodies/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "near_singular/near_field.hpp"
#include "stiv/near_pairs.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

// Selects pairs by the bounding circles of the components.
class BroadPhase {
 public:
  BroadPhase(const Configuration& configuration, const Discretisation& discretisation)
      : configuration_(configuration) {
    ComplexVector corners(2 * static_cast<Eigen::Index>(discretisation.size()));
    for (std::size_t k = 0; k < discretisation.size(); ++k) {
      encloses_.push_back(discretisation[k]->kind == ComponentKind::enclosing_wall);
      radius_.push_back(outer_radius(discretisation[k]->curve, 0.0));
      rectangles_.push_back(square_about(configuration[k].position, radius_[k]));
      corners.segment<2>(2 * static_cast<Eigen::Index>(k)) << rectangles_[k].lower,
          rectangles_[k].upper;
    }
    // The rectangle of an enclosing wall contains all others, so that the wall is a neighbour of
    // every component.
    for (std::size_t k = 0; k < discretisation.size(); ++k) {
      if (encloses_[k]) rectangles_[k] = bounding_rectangle(corners);
    }
    index_.emplace(rectangles_);
  }

  // Returns a lower bound of a gap: the distance of the bounding circles; 0 for an enclosing wall,
  // whose bounding circle gives no bound of its gap to a body inside.
  double least_gap(const ComponentPair& pair) const {
    const auto [a, b] = pair;
    if (encloses_[a] || encloses_[b]) return 0.0;
    return std::abs(configuration_[a].position - configuration_[b].position) - radius_[a] -
           radius_[b];
  }

  // Returns the pairs whose lower bound is less than the distance of at least one of the two
  // components, in ascending order.
  std::vector<ComponentPair> pairs_within(const std::vector<double>& distance) const {
    std::vector<ComponentPair> pairs;
    for (std::size_t a = 0; a < distance.size(); ++a) {
      for (const std::size_t b : index_->meeting(widened(rectangles_[a], distance[a]))) {
        const ComponentPair pair = std::minmax(a, b);
        if (a != b && least_gap(pair) < distance[a]) pairs.push_back(pair);
      }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

 private:
  const Configuration& configuration_;
  std::vector<bool> encloses_;
  std::vector<double> radius_;
  std::vector<Rectangle> rectangles_;
  std::optional<RectangleIndex> index_;
};

std::vector<SmoothCurve> placed_curves(const Configuration& configuration,
                                       const Discretisation& discretisation) {
  std::vector<SmoothCurve> curves;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    curves.push_back(smooth_curve(*discretisation[k], configuration[k]));
  }
  return curves;
}

std::vector<Gap> measure(const std::vector<ComponentPair>& pairs,
                         const std::vector<SmoothCurve>& curves) {
  std::vector<Gap> gaps;
  for (const auto& [a, b] : pairs) gaps.push_back({a, b, {}});
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    gaps[i].points = closest_points(curves[gaps[i].a], curves[gaps[i].b]);
  }
  return gaps;
}

// Returns the closest of the pairs out of reach if its gap is less than a bound.
std::optional<Gap> closest_beyond_reach(const BroadPhase& broad, const std::vector<double>& reach,
                                        const std::vector<SmoothCurve>& curves, double bound) {
  const auto least_gap = [&](const ComponentPair& pair) { return broad.least_gap(pair); };
  std::optional<Gap> closest;
  // The search distance doubles, because for distant bodies no bound on the gap is known
  // beforehand.
  for (double within = std::min(bound, std::ranges::min(reach));;
       within = std::min(bound, 2.0 * within)) {
    std::vector<ComponentPair> pairs =
        broad.pairs_within(std::vector<double>(reach.size(), within));
    std::erase_if(pairs, [&](const ComponentPair& pair) {
      return least_gap(pair) < std::max(reach[pair.first], reach[pair.second]);
    });
    std::ranges::stable_sort(pairs, {}, least_gap);
    for (const auto& [a, b] : pairs) {
      if (least_gap({a, b}) >= bound) break;
      const Gap gap{a, b, closest_points(curves[a], curves[b])};
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
  const BroadPhase broad(configuration, discretisation);
  std::vector<double> reach;
  for (const auto& discretised : discretisation) {
    reach.push_back(near_reach(discretised->curve, tolerance));
  }
  const std::vector<SmoothCurve> curves = placed_curves(configuration, discretisation);
  std::vector<Gap> gaps = measure(broad.pairs_within(reach), curves);
  const auto width = [](const Gap& gap) { return gap.points.gap; };
  std::ranges::stable_sort(gaps, {}, width);
  // A pair out of reach is added only if it is the closest of all pairs.
  const double bound = gaps.empty() ? std::numeric_limits<double>::infinity() : width(gaps.front());
  if (const auto closest = closest_beyond_reach(broad, reach, curves, bound)) {
    gaps.insert(gaps.begin(), *closest);
  }
  return gaps;
}

std::vector<Gap> gaps_within(const Configuration& configuration,
                             const Discretisation& discretisation, double distance) {
  const BroadPhase broad(configuration, discretisation);
  return measure(broad.pairs_within(std::vector<double>(configuration.size(), distance)),
                 placed_curves(configuration, discretisation));
}

}  // namespace stokesbook
