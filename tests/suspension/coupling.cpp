// Tests the lagged coupling, which is a block Jacobi iteration: the coupled solution is its fixed
// point, and its sweeps contract by the spectral radius of I - M^{-1} A, or diverge (chapter 12).

#include <cmath>
#include <string>

#include "double_layer/double_layer.hpp"
#include "scenes.hpp"
#include "support/recorded_run.hpp"
#include "support/touching.hpp"

namespace stokesbook::test {
namespace {

Scene pair(double gap) {
  Scene pair = scene({body(Circle{1.0}, 96, {-1.0 - 0.5 * gap, 0.0}),
                      body(Circle{1.0}, 96, {1.0 + 0.5 * gap, 0.1})},
                     ShearFlow{1.0});
  pair.solver.tolerance = 1e-9;
  pair.solver.preconditioner = PreconditionerKind::block_diagonal;
  return pair;
}

// Returns the largest modulus of an eigenvalue of I - M^{-1} A.
double spectral_radius(const Solved& solved) {
  const LinearSystem discrete =
      solved.solver.linear_system(solved.solution.instant, solved.solution.discretisation);
  const Eigen::Index n = 2 * solved.solution.density.size();
  Eigen::MatrixXd sweep(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, j);
    const ComplexVector image = discrete.system(deinterleaved(unit));
    sweep.col(j) = unit - discrete.precondition(interleaved(image));
  }
  // The radius follows from powers of the matrix. The QR iteration may fail: the matrix has so many
  // nearly zero eigenvalues that rounding decides whether the iteration converges.
  for (int square = 0; square < 6; ++square) sweep = (sweep * sweep).eval();
  return std::pow((sweep * sweep).norm() / sweep.norm(), 1.0 / 64.0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE(couplings)

BOOST_AUTO_TEST_CASE(sweeps_contract_to_the_coupled_solution_by_the_spectral_radius) {
  for (double gap : {1.0, 0.3, 0.1}) {
    const Solved solved(pair(gap));
    const double radius = spectral_radius(solved);
    const auto lagged = [&](const ComplexVector& before) {
      return solved.solver.solve_lagged(solved.solution.instant,
                                        [&](const Discretisation&) { return before; });
    };
    const ComplexVector& exact = solved.solution.density;
    BOOST_TEST((lagged(exact).density - exact).norm() < 1e-8 * exact.norm());
    ComplexVector density = ComplexVector::Zero(exact.size());
    double error = exact.norm(), factor = 0.0;
    for (int sweep = 0; sweep < 14; ++sweep) {
      const Solution swept = lagged(density);
      const double true_error = largest_difference(swept.motions, solved.solution.motions) /
                                solved.solution.velocity_scale;
      BOOST_TEST(swept.error_estimate > 0.3 * true_error);
      BOOST_TEST(swept.error_estimate < 3.0 * true_error);
      density = swept.density;
      factor = (density - exact).norm() / std::exchange(error, (density - exact).norm());
    }
    BOOST_TEST(factor < 1.02 * radius);
    BOOST_TEST(factor > 0.6 * radius);
  }
}

// The spectral radii are those of the specification.
BOOST_AUTO_TEST_CASE(the_narrower_the_gap_the_slower) {
  const double gaps[] = {1.0, 0.5, 0.2, 0.1, 0.05}, radii[] = {0.29, 0.48, 0.72, 0.86, 0.94};
  for (std::size_t k = 0; k < 5; ++k) {
    Scene aligned = pair(gaps[k]);
    for (Body& body : aligned.bodies) body.position.imag(0.0);
    BOOST_TEST(std::abs(spectral_radius(Solved(aligned)) - radii[k]) < 0.006);
  }
}

// The sweeps of these 48 ellipses diverge: the run stops after the same number of steps, whatever
// their length, and reports the reason.
BOOST_AUTO_TEST_CASE(a_crowd_is_refused_whatever_the_step) {
  constexpr int most = 16;
  Scene crowd = ellipses_in_vortices(1e-2);
  const auto run = [&](double dt) {
    return recorded_run(over(crowd, most * dt, dt), Refusals::recorded);
  };
  BOOST_TEST(run(1e-6).steps.size() == most);
  crowd.solver.coupling = Coupling::local;
  const RecordedRun longer = run(1e-6), shorter = run(1e-8);
  BOOST_TEST(longer.steps.size() < most);
  BOOST_TEST(longer.steps.size() == shorter.steps.size());
  BOOST_TEST(longer.stopped.find("the lagged coupling diverges") != std::string::npos);
  // The number in the message shows that the residual is larger than the data.
  const std::string before = "a residual of ";
  const std::size_t at = longer.stopped.find(before);
  BOOST_REQUIRE(at != std::string::npos);
  BOOST_TEST(std::stod(longer.stopped.substr(at + before.size())) > 1.0);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
