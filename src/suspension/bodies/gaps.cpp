// Finds the pairs of components whose gap may be within the reach of their trapezoid rules (06.5),
// and the closest pair; in a periodic cell, also pairs of a component and an image. Bounding
// circles and an R-tree select the pairs, and closest_points() measures their gaps (chapter 06,
// section "Sums over bodies").
#include "suspension/bodies/gaps.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <optional>
#include <utility>

#include "near_singular/near_field.hpp"
#include "suspension/bodies/cell.hpp"
#include "trapezoid/rectangle_index.hpp"

namespace stokesbook {

namespace {

// A component a, and a component b or an image of b, which is moved by a lattice vector.
struct ImagePair {
  std::size_t a, b;
  double x, y;  // components of the vector

  Complex shift() const { return {x, y}; }
  auto operator<=>(const ImagePair&) const = default;
};

// Returns one of the two names of a pair: a with b moved by w is also b with a moved by -w.
ImagePair image_pair(std::size_t a, std::size_t b, Complex w) {
  const bool is_swapped = a > b || (a == b && std::pair(w.real(), w.imag()) < std::pair(0.0, 0.0));
  if (is_swapped) return {b, a, -w.real(), -w.imag()};
  return {a, b, w.real(), w.imag()};
}

// Selects pairs by the bounding circles of the components.
class BroadPhase {
 public:
  BroadPhase(const Configuration& configuration, const Discretisation& discretisation,
             const std::optional<PeriodicCell>& cell)
      : configuration_(configuration) {
    if (cell) lattice_ = lattice_of(*cell);
    ComplexVector corners(2 * static_cast<Eigen::Index>(discretisation.size()));
    for (std::size_t k = 0; k < discretisation.size(); ++k) {
      encloses_.push_back(!is_inner(*discretisation[k]));
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
  double least_gap(const ImagePair& pair) const {
    const std::size_t a = pair.a, b = pair.b;
    if (encloses_[a] || encloses_[b]) return 0.0;
    return std::abs(configuration_[a].position - configuration_[b].position - pair.shift()) -
           radius_[a] - radius_[b];
  }

  // Returns the pairs whose lower bound is less than the distance of at least one of the two
  // components, in ascending order.
  std::vector<ImagePair> pairs_within(const std::vector<double>& distance) const {
    std::vector<ImagePair> pairs;
    for (const Complex w : shifts_within(std::ranges::max(distance))) {
      for (std::size_t a = 0; a < distance.size(); ++a) {
        const auto [lower, upper] = widened(rectangles_[a], distance[a]);
        for (const std::size_t b : index_->meeting({lower - w, upper - w})) {
          const ImagePair pair = image_pair(a, b, w);
          const bool is_one = a == b && w == 0.0;
          if (!is_one && least_gap(pair) < distance[a]) pairs.push_back(pair);
        }
      }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

 private:
  // Returns the lattice vectors by which an image may come within a distance of the cell.
  std::vector<Complex> shifts_within(double distance) const {
    if (!lattice_) return {0.0};
    const double farthest = lattice_->circumradius() + std::ranges::max(radius_);
    return lattice_->vectors_into_disk(0.0, 0.0, 2.0 * farthest + distance);
  }

  const Configuration& configuration_;
  std::optional<Lattice> lattice_;
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

Gap measure(const ImagePair& pair, const std::vector<SmoothCurve>& curves) {
  const Complex shift = pair.shift();
  const auto closest_to = [&](const SmoothCurve& b) {
    return Gap{pair.a, pair.b, closest_points(curves[pair.a], b), shift};
  };
  if (shift == 0.0) return closest_to(curves[pair.b]);
  return closest_to(translated(curves[pair.b], shift));
}

std::vector<Gap> measure(const std::vector<ImagePair>& pairs,
                         const std::vector<SmoothCurve>& curves) {
  std::vector<Gap> gaps(pairs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i] = measure(pairs[i], curves);
  return gaps;
}

// Returns the closest of the pairs out of reach if its gap is less than a bound.
std::optional<Gap> closest_beyond_reach(const BroadPhase& broad, const std::vector<double>& reach,
                                        const std::vector<SmoothCurve>& curves, double bound) {
  const auto least_gap = [&](const ImagePair& pair) { return broad.least_gap(pair); };
  std::optional<Gap> closest;
  // The search distance doubles, because for distant bodies no bound on the gap is known
  // beforehand.
  for (double within = std::min(bound, std::ranges::min(reach));;
       within = std::min(bound, 2.0 * within)) {
    std::vector<ImagePair> pairs = broad.pairs_within(std::vector<double>(reach.size(), within));
    std::erase_if(pairs, [&](const ImagePair& pair) {
      return least_gap(pair) < std::max(reach[pair.a], reach[pair.b]);
    });
    std::ranges::stable_sort(pairs, {}, least_gap);
    for (const ImagePair& pair : pairs) {
      if (least_gap(pair) >= bound) break;
      const Gap gap = measure(pair, curves);
      if (gap.points.gap >= bound) continue;
      closest = gap;
      bound = gap.points.gap;
    }
    if (within >= bound) return closest;
  }
}

}  // namespace

std::vector<Gap> find_gaps(const Configuration& configuration, const Discretisation& discretisation,
                           double tolerance, const std::optional<PeriodicCell>& cell) {
  if (configuration.size() < 2 && !cell) return {};
  const BroadPhase broad(configuration, discretisation, cell);
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
                             const Discretisation& discretisation, double distance,
                             const std::optional<PeriodicCell>& cell) {
  const BroadPhase broad(configuration, discretisation, cell);
  return measure(broad.pairs_within(std::vector<double>(configuration.size(), distance)),
                 placed_curves(configuration, discretisation));
}

}  // namespace stokesbook
