#pragma once

#include <cmath>
#include <cstddef>
#include <deque>
#include <vector>

#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// Densities of earlier solutions, in the frames of their components, from which the next density
/// is guessed. Several densities may belong to one time, as columns of a matrix.
///
/// In the frame of its body, a density changes little and smoothly while bodies move. Its values at
/// points of the body are extrapolated by the polynomial in time through all densities that are
/// kept (09.13).
class DensityHistory {
 public:
  /// Creates an empty history, which keeps at most `most` >= 1 times; the polynomial's degree is
  /// one less.
  explicit DensityHistory(std::size_t most) : most_(most) {}

  bool empty() const { return entries_.empty(); }  ///< returns whether no density is kept

  /// Returns the resolutions of the latest density; none if the history is empty.
  Resolutions latest_resolutions() const {
    return entries_.empty() ? Resolutions{} : entries_.back().resolutions;
  }

  /// Returns whether the latest density belongs to a time, up to rounding.
  bool ends_at(double t) const {
    return !entries_.empty() && std::abs(entries_.back().t - t) <= rounding_at(t);
  }

  /// Adds a density. The new density replaces the density of the same time; if there is none, and
  /// the history is full, the new density replaces the oldest one.
  ///
  /// @param  densities  at all n nodes, length / time; the same number of columns every time
  void add(double t, const Configuration& configuration, const Discretisation& discretisation,
           Eigen::MatrixXcd densities);

  /// Adapts the history to a reversal of flow, walls and loads at the time t: from then on bodies
  /// retrace their paths, and the density at t + s is minus the density at t - s.
  void reverse(double t);

  /// Forgets all densities: past a time at which the forcing is not smooth, none extrapolates.
  void clear() { entries_.clear(); }

  /// Guesses the density at a time on nodes that may differ from those of earlier solutions.
  ///
  /// @return    guess at all n nodes, length / time; no rows if the history is empty
  /// @par Cost  O(n) if the nodes are the same, O(N^2) for each component whose nodes crowd
  /// elsewhere
  Eigen::MatrixXcd guess(double t, const Configuration& configuration,
                         const Discretisation& discretisation) const;

  /// Packs the history into numbers: one vector per time, the oldest first.
  std::vector<Eigen::VectorXd> packed() const;

  /// Replaces the history by one that packed() returned, of the same number of components.
  void unpack(const std::vector<Eigen::VectorXd>& packed, std::size_t components);

 private:
  struct Entry {
    double t;
    Resolutions resolutions;
    Eigen::MatrixXcd densities;  // each component's in its own frame
  };

  // Returns the distance from a time within which times count as that time.
  double rounding_at(double t) const;

  std::size_t most_;
  std::deque<Entry> entries_;
};

}  // namespace stokesbook
