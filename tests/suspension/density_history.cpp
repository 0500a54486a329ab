// Tests the extrapolation of densities as polynomials in time, in the frames of bodies that move
// and turn, between different nodes. A guess changes the iterations, but not the solution.
#include "suspension/solver/density_history.hpp"

#include "scenes.hpp"
#include "support/vectors.hpp"

namespace stokesbook::test {
namespace {

Configuration moving(double t) {
  return {{{0.1 * t, 0.2}, 0.3 * t}, {{3.0, t}, 1.0 - t * t}};
}

Discretisation discretised(const SuspensionSolver& solver, const Grading& first, int n) {
  return solver.discretise({{n, first}, {n + 16, {}}});
}

SuspensionSolver two_bodies() {
  return SuspensionSolver(
      scene({body(Ellipse{1.0, 0.7}, 64, {0.0, 0.0}), body(Circle{0.8}, 64, {3.0, 0.0})},
            ShearFlow{1.0}));
}

// Returns a function that is cubic in time and depends on the points of the bodies, as a vector in
// the fixed frame.
ComplexVector cubic(double t, const Discretisation& nodes) {
  const Configuration at = moving(t);
  std::vector<Complex> all;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const Complex x : nodes[k]->curve.x) {
      const Complex own = (1.0 + t - 0.3 * t * t) * x + t * t * t * std::conj(x * x) / 4.0;
      all.push_back(std::polar(1.0, at[k].orientation) * own);
    }
  }
  return Eigen::Map<const ComplexVector>(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

BOOST_AUTO_TEST_SUITE(density_histories)

BOOST_AUTO_TEST_CASE(cubic_densities_of_moving_bodies_are_guessed_exactly) {
  const SuspensionSolver solver = two_bodies();
  const Discretisation nodes = discretised(solver, {}, 48);
  DensityHistory history(4);
  BOOST_TEST(history.guess(0.0, moving(0.0), nodes).size() == 0);
  for (double t : {-7.0, 0.0, 0.1, 0.25, 0.45}) history.add(t, moving(t), nodes, cubic(t, nodes));
  for (double t : {0.3, 0.6, 1.0}) {
    const ComplexVector exact = cubic(t, nodes);
    BOOST_TEST((history.guess(t, moving(t), nodes) - exact).norm() < 1e-12 * exact.norm());
  }
  // A second entry at the same time replaces the first.
  history.add(0.45, moving(0.45), nodes, 2.0 * cubic(0.45, nodes));
  BOOST_TEST((history.guess(0.45, moving(0.45), nodes) - 2.0 * cubic(0.45, nodes)).norm() < 1e-12);
  // An entry whose time differs only by rounding, as after a reversal, also replaces the earlier
  // one: three other times remain.
  history.add(std::nextafter(0.45, 1.0), moving(0.45), nodes, cubic(0.45, nodes));
  const ComplexVector exact = cubic(0.6, nodes);
  BOOST_TEST((history.guess(0.6, moving(0.6), nodes) - exact).norm() < 1e-12 * exact.norm());
}

BOOST_AUTO_TEST_CASE(nodes_may_differ_from_density_to_density) {
  const SuspensionSolver solver = two_bodies();
  const Grading here{{{0.3, 0.2}}}, there{{{2.0, 0.1}, {4.0, 0.3}}, 1.0};
  DensityHistory history(4);
  const std::vector<Discretisation> nodes = {
      discretised(solver, {}, 48), discretised(solver, here, 96), discretised(solver, there, 128),
      discretised(solver, {}, 64)};
  for (std::size_t k = 0; k < 4; ++k) {
    const double t = 0.2 * static_cast<double>(k);
    history.add(t, moving(t), nodes[k], cubic(t, nodes[k]));
  }
  for (const Discretisation& now : {discretised(solver, here, 112), discretised(solver, {}, 32)}) {
    const ComplexVector exact = cubic(0.9, now);
    BOOST_TEST((history.guess(0.9, moving(0.9), now) - exact).norm() < 1e-9 * exact.norm());
  }
}

BOOST_AUTO_TEST_CASE(after_a_reversal_the_past_is_the_future_with_the_other_sign) {
  const SuspensionSolver solver = two_bodies();
  const Discretisation nodes = discretised(solver, {}, 48);
  DensityHistory history(4);
  for (double t : {0.0, 0.2, 0.4, 0.6}) history.add(t, moving(t), nodes, cubic(t, nodes));
  history.reverse(0.7);
  const ComplexVector exact = -cubic(0.3, nodes);
  BOOST_TEST((history.guess(1.1, moving(0.3), nodes) - exact).norm() < 1e-12 * exact.norm());
}

BOOST_AUTO_TEST_CASE(packing_keeps_every_bit) {
  const SuspensionSolver solver = two_bodies();
  const Discretisation nodes = discretised(solver, {{{0.3, 0.2}}}, 64);
  DensityHistory history(3), copy(3);
  for (double t : {0.1, 0.3}) history.add(t, moving(t), nodes, cubic(t, nodes));
  copy.unpack(history.packed(), 2);
  for (double t : {0.4, 0.5}) {
    BOOST_TEST((copy.guess(t, moving(t), nodes) - history.guess(t, moving(t), nodes)).norm() ==
               0.0);
    history.add(t, moving(t), nodes, cubic(t, nodes));
    copy.add(t, moving(t), nodes, cubic(t, nodes));
  }
}

BOOST_AUTO_TEST_CASE(a_guess_saves_iterations_and_changes_no_digit) {
  const SuspensionSolver solver = two_bodies();
  const Instant start = solver.start();
  const Solution cold = solver.solve(start);
  const auto error = [&](const Solution& other) {
    return std::abs(other.motions[0].velocity - cold.motions[0].velocity) +
           std::abs(other.motions[1].omega - cold.motions[1].omega);
  };
  for (double disturbance : {0.0, 1e-6}) {
    const Solution warm = solver.solve(start, [&](const Discretisation&) -> ComplexVector {
      return cold.density + disturbance * random_vector(cold.density.size(), 1);
    });
    BOOST_TEST(warm.gmres.iterations <= (disturbance == 0.0 ? 0 : cold.gmres.iterations - 1));
    BOOST_TEST(error(warm) < 1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
