// Builds the steps of the study, and evaluates their contacts.
#include "set_ups.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

#include "stiv/polygon_gaps.hpp"

namespace stokesbook::verification::stiv {

using Eigen::Index;

std::shared_ptr<const ContactShape> body(const Shape& shape, Index m) {
  return std::make_shared<ContactShape>(contact_shape(sample(shape, m, Side::fluid_outside)));
}

std::shared_ptr<const ContactShape> container(const Shape& shape, Index m) {
  return std::make_shared<ContactShape>(contact_shape(sample(shape, m, Side::fluid_inside)));
}

std::vector<Contact> violations(const Step& step, const ContactRules& rules) {
  std::vector<Contact> contacts;
  std::ranges::copy_if(interferences(step.shapes, step.paths, rules).contacts,
                       std::back_inserter(contacts), &Contact::is_violated);
  return contacts;
}

double first_time(const std::vector<Contact>& contacts) {
  double time = std::numeric_limits<double>::infinity();
  for (const Contact& contact : contacts) {
    for (const ContactRow& row : contact.rows) time = std::min(time, row.time);
  }
  return time;
}

double least_gap(const std::vector<Contact>& contacts) {
  double gap = 0.0;
  for (const Contact& contact : contacts) {
    for (const ContactRow& row : contact.rows) gap = std::min(gap, row.gap);
  }
  return gap;
}

double distance_at(const Step& step, double tau, double reach) {
  std::vector<Pose> poses;
  for (const RigidPath& path : step.paths) poses.push_back(path.at(tau));
  double least = reach;
  for (const PolygonGap& gap : polygon_gaps(step.shapes, poses, reach)) {
    least = std::min(least, gap.gap);
  }
  return least;
}

Step slanting_impact(double size, Index m) {
  return {{body(Ellipse{1.0, 0.4}, m), body(Star{0.8, 0.25, 5}, m + m / 2)},
          {{{{0.3, -0.2}, 0.4}, size * Complex{0.5, 0.3}, 0.4 * size},
           {{{2.4, 0.5}, -0.3}, size * Complex{-0.7, -0.5}, -0.3 * size}}};
}

}  // namespace stokesbook::verification::stiv
