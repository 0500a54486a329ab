// Defines steps of a few components, and functions of their contacts.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "stiv/interferences.hpp"

namespace stokesbook::test {

/// Holds components and their paths.
struct Step {
  ContactShapes shapes;
  std::vector<RigidPath> paths;

  void add(std::shared_ptr<const ContactShape> shape, const RigidPath& path) {
    shapes.push_back(std::move(shape));
    paths.push_back(path);
  }
};

inline std::shared_ptr<const ContactShape> body(const Shape& shape, Eigen::Index m) {
  return std::make_shared<ContactShape>(contact_shape(sample(shape, m, Side::fluid_outside)));
}

inline std::shared_ptr<const ContactShape> container(const Shape& shape, Eigen::Index m) {
  return std::make_shared<ContactShape>(contact_shape(sample(shape, m, Side::fluid_inside)));
}

inline Interferences interferences(const Step& step, const ContactRules& rules) {
  return stokesbook::interferences(step.shapes, step.paths, rules);
}

inline std::vector<Contact> violated(const Interferences& found) {
  std::vector<Contact> contacts;
  std::ranges::copy_if(found.contacts, std::back_inserter(contacts), &Contact::is_violated);
  return contacts;
}

/// Returns the time of the earliest first contact, or infinity if there is no contact.
inline double first_time(const std::vector<Contact>& contacts) {
  double time = INFINITY;
  for (const Contact& contact : contacts) {
    for (const ContactRow& row : contact.rows) time = std::min(time, row.time);
  }
  return time;
}

inline double least_gap(const std::vector<Contact>& contacts) {
  double gap = INFINITY;
  for (const Contact& contact : contacts) {
    for (const ContactRow& row : contact.rows) gap = std::min(gap, row.gap);
  }
  return gap;
}

}  // namespace stokesbook::test
