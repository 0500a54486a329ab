// Tests that a whole solve gives the same bits with one and with two threads, in every part of the
// operator.

#include <omp.h>

#include "suspension/random_scenes.hpp"

namespace stokesbook::test {

BOOST_AUTO_TEST_CASE(threads_do_not_change_a_bit) {
  Scene cell = contained_bodies(25);
  cell.walls.push_back(inner_wall(Circle{0.5}, 128, RotatingWall{0.8}));
  omp_set_num_threads(1);
  const Solved one(cell);
  omp_set_num_threads(2);
  const Solved two(cell);
  BOOST_TEST((one.solution.density.array() == two.solution.density.array()).all());
  ComplexVector points(2);
  points << Complex{0.1, 0.9}, Complex{0.5001, 0.0};
  omp_set_num_threads(1);
  const ComplexVector velocity = one.velocity(points);
  omp_set_num_threads(2);
  BOOST_TEST((velocity.array() == two.velocity(points).array()).all());
}

}  // namespace stokesbook::test
