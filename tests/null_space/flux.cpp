// Checks that double layers carry no net flux through the boundary, \int n . (-1/2 + D) eta ds = 0
// for any density on the wall and on the bodies within (04.3). Double layers alone therefore cannot
// represent one dimension of the data of bounded problems, which N_0 must supply.

#include <boost/test/unit_test.hpp>

#include "double_layer/stresslet_sum.hpp"
#include "support/walls.hpp"

namespace stokesbook::test {
namespace {

std::vector<Curve> boundary() {
  const auto at = [](const Shape& shape, Eigen::Index n, Side side, Complex position,
                     double angle) { return place(sample(shape, n, side), position, angle); };
  return {at(Ellipse{3, 2.4}, 192, Side::fluid_inside, {0.2, 0.1}, 0.3),
          at(Star{0.7, 0.2, 3}, 192, Side::fluid_outside, {-1.0, 0.3}, 0.0),
          at(Circle{0.5}, 128, Side::fluid_outside, {1.3, -0.2}, 0.0)};
}

// Returns a smooth density that differs from curve to curve.
ComplexVector density_on(const Curve& curve, double phase) {
  ComplexVector density(curve.size());
  for (Eigen::Index j = 0; j < curve.size(); ++j) {
    const double t =
        2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(curve.size());
    density[j] = {std::cos(3 * t + phase) + 0.5, std::exp(std::sin(t - phase))};
  }
  return density;
}

double flux(const Curve& curve, const ComplexVector& velocity) {
  return (normals(curve).conjugate().cwiseProduct(velocity)).real().dot(weights(curve));
}

struct LayerFlux {
  std::vector<double> through;  // through each curve, for the limit from the fluid
  std::vector<double> density;  // \int n . eta ds
};

LayerFlux layer_flux(const std::vector<Curve>& curves) {
  ComplexVector density(0);
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const ComplexVector own = density_on(curves[k], static_cast<double>(k));
    density.conservativeResize(density.size() + own.size());
    density.tail(own.size()) = own;
  }
  const ComplexVector sum = StressletSum(curves)(density);
  LayerFlux result;
  Eigen::Index first = 0;
  for (const Curve& curve : curves) {
    const Eigen::Index n = curve.size();
    const ComplexVector own = density.segment(first, n);
    const ComplexVector limit = sum.segment(first, n) + diagonal_velocity(curve, own) - 0.5 * own;
    result.through.push_back(flux(curve, limit));
    result.density.push_back(flux(curve, own));
    first += n;
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(flux_identities)

BOOST_AUTO_TEST_CASE(no_net_flux_through_the_boundary) {
  const LayerFlux result = layer_flux(boundary());
  // The parts are of size one; only their sum vanishes.
  BOOST_TEST(std::abs(result.through[0]) > 0.1);
  BOOST_TEST(std::abs(result.through[0] + result.through[1] + result.through[2]) < 1e-12);
}

// The flux through every body is minus the flux of the body's own density. A density can therefore
// represent a source in a hole.
BOOST_AUTO_TEST_CASE(flux_through_bodies) {
  const LayerFlux result = layer_flux(boundary());
  for (const std::size_t body : {std::size_t{1}, std::size_t{2}}) {
    BOOST_TEST(std::abs(result.density[body]) > 0.1);
    BOOST_TEST(std::abs(result.through[body] + result.density[body]) < 1e-12);
  }
}

// A source of strength 2 pi a g in an annulus' inner circle requires an equal sink on the outer
// circle: u = a g / r.
BOOST_AUTO_TEST_CASE(source_flow_in_an_annulus) {
  const double a = 0.8, radius = 2.0, g = 0.7;
  StokesProblem problem{
      {held_body(Circle{a}, 96, {}, {}), enclosing_wall(Circle{radius}, 96, {})}, 1.3, {}, {}};
  for (Component& component : problem.components) {
    const ComplexVector& x = component.curve.x;
    component.velocity = (g * a) * x.cwiseQuotient(x.cwiseAbs2());
  }
  BOOST_TEST(std::abs(net_flux(problem)) < 1e-14);
  BOOST_TEST(flux_scale(problem) == 4 * std::numbers::pi * a * g,
             boost::test_tools::tolerance(1e-14));
  const Eigen::VectorXd solution = solve(assemble_bounded(problem, ClosureForm::reduced));
  const Completion result = complete_dense(problem, ClosureForm::reduced, solution);
  BOOST_TEST(distance(result.loads[0], {}) < 1e-13);
  const ComplexVector density = deinterleaved(solution);
  const ComplexVector points{{{1.2, 0.3}, {-0.9, 0.9}, {0.1, -1.4}}};
  const std::vector<Curve> curves{problem.components[0].curve, problem.components[1].curve};
  const ComplexVector exact = (g * a) * points.cwiseQuotient(points.cwiseAbs2());
  BOOST_TEST((StressletSum(curves)(points, density) - exact).cwiseAbs().maxCoeff() < 1e-11);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
