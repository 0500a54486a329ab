#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stiv/interferences.hpp"
#include "suspension/bodies/cell.hpp"

namespace stokesbook {

/// Two components that may touch; in a periodic cell, a component and an image of another
/// component or of itself.
struct ContactPair {
  std::size_t a = 0,     ///< a component
      b = 0;             ///< another component, b > a; b = a for an own image
  LatticeIndex image{};  ///< of the vector w by which the path of b is moved; zero without a cell

  auto operator<=>(const ContactPair&) const = default;  ///< compares member by member
};

/// Gaps of the pairs that may be closer than all others, length.
using CloserGaps = std::map<ContactPair, double>;

/// Names a pair of a scene for messages, by name_pair() or name_image_pair().
std::string name_contact_pair(const Scene& scene, const ContactPair& pair);

/// The paths of all components in a step; in a periodic cell, also those of the images that may
/// come near the components, so that a search among these paths finds all pairs.
struct PathImages {
  /// A path that belongs to a component, or to an image of the component.
  struct Image {
    std::size_t component = 0;  ///< the component
    LatticeIndex index{};       ///< of the vector by which the path of the component is moved

    bool operator==(const Image&) const = default;  ///< compares member by member
  };
  std::vector<Image> images;     ///< of each path; first one of each component, in order
  std::vector<RigidPath> paths;  ///< the first ones are those of the images in the cell
  ContactShapes shapes;          ///< shape of each path
  std::size_t components;        ///< number of components

  /// Returns the pair of two paths p < q; none if the same pair has another name, under which it is
  /// found too: two images, or an image and a component in the reverse order.
  std::optional<ContactPair> pair(std::size_t p, std::size_t q) const;

  /// Returns the gaps of pairs by the numbers of their paths; pairs without a path are left out.
  CloserPairs numbered(const CloserGaps& closer) const;
};

/// Finds the images of paths that may come near the components in a step.
///
/// @param  paths    of all components, anywhere
/// @param  lattice  of the step, in a periodic cell; none: nothing repeats
/// @param  reach    pairs that come nearer to each other are found, length
/// @par Cost        O(components), times the number of lattice vectors within the size of the cell
PathImages path_images(const ContactShapes& shapes, const std::vector<RigidPath>& paths,
                       const std::optional<LatticeStep>& lattice, double reach);

/// Finds the images of components at rest, as path_images() does.
PathImages resting_images(const ContactShapes& shapes, const Placement& placement, double reach);

}  // namespace stokesbook
