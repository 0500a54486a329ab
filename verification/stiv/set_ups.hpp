// Declares steps of a few components, and quantities of their contacts.
#pragma once

#include <memory>
#include <vector>

#include "stiv/interferences.hpp"

namespace stokesbook::verification::stiv {

/// Holds components and their paths.
struct Step {
  ContactShapes shapes;
  std::vector<RigidPath> paths;
};

/// Samples a body.
std::shared_ptr<const ContactShape> body(const Shape& shape, Eigen::Index m);

/// Samples an enclosing wall.
std::shared_ptr<const ContactShape> container(const Shape& shape, Eigen::Index m);

/// Returns the contacts of a step that are violated.
std::vector<Contact> violations(const Step& step, const ContactRules& rules);

/// Returns the time of the earliest first contact, or infinity if there is no contact.
double first_time(const std::vector<Contact>& contacts);

/// Returns the least gap of all rows, or 0 if there is no row.
double least_gap(const std::vector<Contact>& contacts);

/// Returns the signed distance of two polygons at a time of a step. Distances above the reach are
/// not computed.
double distance_at(const Step& step, double tau, double reach);

/// Returns the step of an ellipse and a star that collide at an angle. Both bodies turn.
/// @param size  scale of displacements and rotations; for 1 the step is as long as the bodies
/// @param m     vertices of the ellipse; the star has half as many more
Step slanting_impact(double size, Eigen::Index m);

}  // namespace stokesbook::verification::stiv
