#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Densities of earlier solutions, in the frames of their components, from which the next density
/// is guessed. Several densities may belong to one time, as columns of a matrix.
///
/// In the frame of its body, a density changes little and smoothly while bodies move. Its values at
/// points of the body are extrapolated by the polynomial in time through all densities that are
/// kept (09.15).
class DensityHistory {
 public:
  /// Creates an empty history.
  ///
  /// @param  most  largest number of times that are kept, >= 1; the polynomial's degree is one less
  explicit DensityHistory(std::size_t most) : most_(most) {}

  /// Returns whether the history is empty.
  /// @return true at the start
  bool empty() const { return entries_.empty(); }

  /// Returns the resolutions of the latest density.
  /// @return resolution of each component; none if the history is empty
  Resolutions latest_resolutions() const {
    return entries_.empty() ? Resolutions{} : entries_.back().resolutions;
  }

  /// Adds a density. The new density replaces the density of the same time; if there is none, and
  /// the history is full, the new density replaces the oldest one.
  ///
  /// @param  t               time
  /// @param  configuration   where the components are
  /// @param  discretisation  shapes on whose nodes the density is given, one per component
  /// @param  densities       at all n nodes, length / time; the same number of columns every time
  void add(double t, const Configuration& configuration, const Discretisation& discretisation,
           Eigen::MatrixXcd densities);

  /// Adapts the history to a reversal of flow, walls and loads: from then on bodies retrace their
  /// paths, with densities of the other sign.
  ///
  /// @param  t  time of the reversal; the density of the time t - s becomes that of the time t + s
  void reverse(double t);

  /// Guesses the density at a time.
  ///
  /// @param  t               time
  /// @param  configuration   where the components are
  /// @param  discretisation  of each component; nodes may differ from those of earlier solutions
  /// @return                 guess at all n nodes, length / time; no rows if the history is empty
  /// @par Cost               O(n) if the nodes are the same, O(N^2) for each component whose nodes
  ///                         crowd elsewhere
  Eigen::MatrixXcd guess(double t, const Configuration& configuration,
                         const Discretisation& discretisation) const;

  /// Packs the history into numbers.
  /// @return one vector per time, the oldest first
  std::vector<Eigen::VectorXd> packed() const;

  /// Replaces the history by a packed one.
  ///
  /// @param  packed      from packed(), of a history of the same components
  /// @param  components  number of components
  void unpack(const std::vector<Eigen::VectorXd>& packed, std::size_t components);

 private:
  // The type is hidden, because Doxygen 1.9 links to a list of private nested types that it does
  // not write.
  /// @cond
  struct Entry {
    double t;
    Resolutions resolutions;
    Eigen::MatrixXcd densities;  // each component's in its own frame
  };
  /// @endcond

  std::size_t most_;
  std::deque<Entry> entries_;
};

/// @}

}  // namespace stokesbook
