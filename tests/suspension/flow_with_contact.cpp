// Tests that the flow around bodies in contact is that of their loads and contact forces together.

#include <optional>

#include <boost/test/unit_test.hpp>

#include "suspension/contact_setup.hpp"

namespace stokesbook::test {

BOOST_AUTO_TEST_SUITE(flow_with_contact)

// Without the contact forces, the velocity between the disks would be 0.05 and more.
BOOST_AUTO_TEST_CASE(fields_of_pressed_disks_are_zero) {
  Scene scene = pressed_disks();
  scene.output.fields = FieldSettings{{-1.0, 0.0, 1.0, 2.0}, 9};
  const SuspensionSolver solver(scene);
  std::optional<Field> field;
  Observer observer;
  observer.frame = [&](const Frame& frame) { field = frame.field; };
  Simulation(solver, observer).solve_once();
  BOOST_REQUIRE(field.has_value());
  int in_fluid = 0;
  for (Eigen::Index i = 0; i < field->velocity.size(); ++i) {
    if (field->in_fluid[static_cast<std::size_t>(i)] == 0) continue;
    ++in_fluid;
    BOOST_TEST(std::abs(field->velocity[i]) < 1e-6);
    BOOST_TEST(std::abs(field->pressure[i]) < 1e-6);
  }
  BOOST_TEST(in_fluid > 10);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
