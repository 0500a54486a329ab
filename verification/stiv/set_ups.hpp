// Steps of a few components, and what is asked of their contacts.
#pragma once

#include <memory>
#include <vector>

#include "stiv/interferences.hpp"

namespace stokesbook::verification::stiv {

/// Components with their paths.
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

/// Returns the earliest first contact; infinite without any.
double first_time(const std::vector<Contact>& contacts);

/// Returns the least gap of any row; 0 without any.
double least_gap(const std::vector<Contact>& contacts);

/// Returns the signed distance of two polygons at a time of a step, as far as it is below a reach.
double distance_at(const Step& step, double tau, double reach);

/// An ellipse and a star that hit each other at a slant, both turning.
/// @param size  of displacements and turns: 1 is a step as long as the bodies
/// @param m     vertices of the ellipse; the star has half as many more
Step slanting_impact(double size, Eigen::Index m);

}  // namespace stokesbook::verification::stiv
