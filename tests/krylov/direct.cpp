// Checks that the factorised system is the inverse of the reduced closure (03.10), for all kinds of
// problems.
#include "krylov/direct.hpp"

#include "closure/bordered_system.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "krylov/matrices.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {

namespace {

Component component(ComponentKind kind, const Shape& shape, Complex centre) {
  const Side side =
      kind == ComponentKind::enclosing_wall ? Side::fluid_inside : Side::fluid_outside;
  const Curve curve = place(sample(shape, 40, side), centre, 0.4);
  return {kind, curve, centre, {0.3, -0.2}, 0.1, ComplexVector::Zero(curve.size())};
}

// The two bodies differ in kind, shape and size, and the viscosity is not 1.
StokesProblem pair(ComponentKind second, std::optional<double> gauge) {
  return {{component(ComponentKind::free_body, Ellipse{1.0, 0.6}, {-1.2, 0.1}),
           component(second, Star{0.7, 0.2, 3}, {1.0, 0.3})},
          2.5,
          {},
          gauge};
}

StokesProblem in_container() {
  StokesProblem problem = pair(ComponentKind::prescribed, {});
  problem.components.push_back(component(ComponentKind::enclosing_wall, Circle{4.0}, {0.2, 0.1}));
  return problem;
}

double error_of_inverse(const StokesProblem& problem) {
  const LayerBlock layer = [&](const ComplexVector& targets, std::size_t source) {
    return StressletSum({problem.components[source].curve}).matrix(targets);
  };
  return inversion_error(DirectPreconditioner(problem, layer),
                         assemble_bounded(problem, ClosureForm::reduced).matrix);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(direct)

BOOST_AUTO_TEST_CASE(a_factorisation_inverts_every_closure) {
  BOOST_TEST(error_of_inverse(pair(ComponentKind::free_body, 20.0)) < 1e-11);
  BOOST_TEST(error_of_inverse(pair(ComponentKind::prescribed, 20.0)) < 1e-11);
  BOOST_TEST(error_of_inverse(pair(ComponentKind::prescribed, {})) < 1e-11);
  BOOST_TEST(error_of_inverse(in_container()) < 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
