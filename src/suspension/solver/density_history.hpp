#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "suspension/bodies/configuration.hpp"
#include "suspension/bodies/discretised_shape.hpp"

namespace stokesbook {

/// @addtogroup suspension
/// @{

/// Densities of earlier solutions, in the frames of their components: from them the next one is
/// guessed. There may be several of one time, a column each.
///
/// A density in its body's own frame changes little while bodies move, and smoothly: its values at
/// points of the body are extrapolated by the polynomial in time through all that are kept.
class DensityHistory {
 public:
  /// Starts without any.
  ///
  /// @param  most  number of densities that are kept, >= 1; the polynomial's degree is one less
  explicit DensityHistory(std::size_t most) : most_(most) {}

  /// Tells whether nothing is kept.
  /// @return true at the start
  bool empty() const { return entries_.empty(); }

  /// Returns the nodes of the latest density.
  /// @return of each component; empty where nothing is kept
  Resolutions latest_resolutions() const {
    return entries_.empty() ? Resolutions{} : entries_.back().resolutions;
  }

  /// Adds a density; it takes the place of one at the same time, or else of the oldest one if all
  /// places are taken.
  ///
  /// @param  t               time
  /// @param  configuration   where the components are
  /// @param  discretisation  that the density lives on, one a component
  /// @param  densities       at all n nodes, length / time; as many columns every time
  void add(double t, const Configuration& configuration, const Discretisation& discretisation,
           Eigen::MatrixXcd densities);

  /// Reverses flow, walls and loads: what was done is then undone, with
  /// densities of the other sign.
  ///
  /// @param  t  time of the reversal; densities from a time before belong as long after it
  void reverse(double t);

  /// Guesses the density at a time.
  ///
  /// @param  t               time
  /// @param  configuration   where the components are
  /// @param  discretisation  of each component; nodes need not be those of earlier solutions
  /// @return                 at all n nodes, length / time; no rows where nothing is kept
  /// @par Cost              O(n) where nodes are the same, O(N^2) a component where they crowd
  ///                        elsewhere
  Eigen::MatrixXcd guess(double t, const Configuration& configuration,
                         const Discretisation& discretisation) const;

  /// Packs what is kept into numbers.
  /// @return one vector a density, the oldest first
  std::vector<Eigen::VectorXd> packed() const;

  /// Takes what packed() returned.
  ///
  /// @param  packed      from a history of the same components
  /// @param  components  number of them
  void unpack(const std::vector<Eigen::VectorXd>& packed, std::size_t components);

 private:
  // Hidden, because Doxygen 1.9 links to a list of private nested types that it does not write.
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
