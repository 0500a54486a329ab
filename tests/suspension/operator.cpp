// Tests that the matrix-free operator equals the dense system that closure and null_space assemble,
// and that its iteration counts on nine circles are those of the specification, for unresolved and
// resolved gaps.

#include "double_layer/double_layer.hpp"
#include "scenes.hpp"
#include "support/walls.hpp"
#include "suspension/system/linear_system.hpp"

namespace stokesbook::test {
namespace {

// Returns the operator at the start of a scene, with plain trapezoid sums.
SuspensionOperator plain_operator(const SuspensionSolver& solver) {
  return {solver.problem(solver.start(), solver.discretisation()), {}, solver.plan()};
}

LinearMap as_linear_map(const SuspensionOperator& system) {
  return [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const ComplexVector velocity = system(deinterleaved(v));
    return interleaved(velocity);
  };
}

int iterations(const SuspensionSolver& solver, bool preconditioned, double tolerance = 1e-12) {
  const SuspensionOperator system = plain_operator(solver);
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (const auto& reference : solver.discretisation()) {
    members.push_back({reference->inverse_block.get()});
  }
  LinearMap precondition;
  if (preconditioned) precondition = BlockDiagonalPreconditioner(members);
  const ComplexVector rhs = system.right_hand_side();
  return gmres(as_linear_map(system), precondition, interleaved(rhs), {tolerance, 100}).iterations;
}

Scene nine_circles(int n_nodes, const BackgroundFlow& flow) {
  std::vector<Body> circles;
  for (int i = 0; i < 9; ++i) {
    circles.push_back(body(Circle{.5}, n_nodes, 1.25 * Complex(i % 3 - 1, i / 3 - 1)));
  }
  Scene nine = scene(circles, flow);
  nine.solver.preconditioner = PreconditionerKind::block_diagonal;
  return nine;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(operators)

BOOST_AUTO_TEST_CASE(is_the_dense_system) {
  Scene cell = scene({body(lopsided_curve(0.5), 64, {1.6, 0.3}, 0.8, {{0.4, -1.0}, 0.3}),
                      held_body(Ellipse{0.6, 0.4}, 48, {-1.5, -0.5}, 0.3, {{0.2, 0.1}, 0.7})},
                     {},
                     {inner_wall(Circle{0.5}, 32, RotatingWall{1.0}, {0, 1.4}),
                      outer_wall(Ellipse{3.5, 3.0}, 96)});
  cell.viscosity = 1.3;
  const SuspensionSolver solver(cell);
  const StokesProblem problem = solver.problem(solver.start(), solver.discretisation());
  const DenseSystem dense = assemble_bounded(problem, ClosureForm::reduced);
  const SuspensionOperator system = plain_operator(solver);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Eigen::VectorXd density =
      Eigen::VectorXd::NullaryExpr(dense.rhs.size(), [&] { return uniform(random); });
  const Eigen::VectorXd difference = as_linear_map(system)(density) - dense.matrix * density;
  BOOST_TEST(difference.cwiseAbs().maxCoeff() < 1e-13);
  const ComplexVector rhs = system.right_hand_side();
  BOOST_TEST((interleaved(rhs) - dense.rhs).cwiseAbs().maxCoeff() < 1e-15);
}

// With 16 nodes a circle, the plain rule does not resolve the sums between circles. The count stays
// that of the resolved system, since the rigid parts are taken out of the sums.
BOOST_AUTO_TEST_CASE(iterations_of_nine_unresolved_circles) {
  for (const BackgroundFlow& flow :
       {BackgroundFlow{ShearFlow{1}}, BackgroundFlow{ExtensionalFlow{1}}}) {
    const SuspensionSolver solver(nine_circles(16, flow));
    BOOST_TEST(iterations(solver, false, relative_to_whole_flow(solver, 1e-12)) == 17);
    BOOST_TEST(iterations(solver, true) == 16);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
