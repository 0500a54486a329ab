// Tests that the velocity field of a solution is a Stokes flow (chapter 12): its divergence is
// zero, its velocity is biharmonic and continuous up to the boundary, and it decays as its loads
// and stresslets require.

#include <numbers>

#include "circle_averages.hpp"
#include "stress/traction.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "trapezoid/fourier.hpp"
#include "units.hpp"

namespace stokesbook::test {
namespace {

Scene loaded_trio(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Scene trio = resolved(with_gauge(scene(random_bodies(random), ShearFlow{0.7}), 20.0));
  for (Body& body : trio.bodies) {
    const Load load = random_load(random);
    body.force = load.force;
    body.torque = load.torque;
  }
  return trio;
}

// Returns points of the fluid that have at least a given distance from every body.
std::vector<Complex> fluid_points(const Solved& solved, double spread, double distance) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-spread, spread);
  const auto is_free = [&](Complex point, std::size_t k) {
    const auto [position, orientation] = solved.solution.instant.configuration[k];
    const CauchyCurve& curve = *solved.solution.discretisation[k]->cauchy;
    const Complex local = (point - position) * std::polar(1.0, -orientation);
    return curve.in_fluid(local) && (curve.curve().x.array() - local).abs().minCoeff() > distance;
  };
  std::vector<Complex> points;
  while (points.size() < 10) {
    const Complex point{uniform(random), uniform(random)};
    if (is_free(point, 0) && is_free(point, 1) && is_free(point, 2)) points.push_back(point);
  }
  return points;
}

// Returns d/dx of the velocity along a direction, by central differences of order 4.
Complex derivative(const Solved& solved, Complex point, Complex step) {
  const ComplexVector u = solved.velocity(
      ComplexVector{{point - 2.0 * step, point - step, point + step, point + 2.0 * step}});
  return (u[0] - 8.0 * u[1] + 8.0 * u[2] - u[3]) / (12.0 * std::abs(step));
}

// Returns the tractions of the whole flow at the nodes of a solution.
ComplexVector tractions(const Solved& solved, const Solution& solution) {
  const StokesProblem problem =
      solved.solver.problem(solved.solution.instant, solution.discretisation);
  const ComplexVector& nodes = problem.components[0].curve.x;
  return boundary_traction(problem, solved.solver.derivatives(solution, nodes));
}

// Returns the largest difference of two functions on a curve, relative to the largest value of the
// second.
double relative_difference(const ComplexVector& f, const ComplexVector& g) {
  std::vector<double> parameters;
  for (Eigen::Index j = 0; j < g.size(); ++j) {
    parameters.push_back(2.0 * std::numbers::pi * static_cast<double>(j) /
                         static_cast<double>(g.size()));
  }
  return (interpolated(f, parameters) - g).cwiseAbs().maxCoeff() / g.cwiseAbs().maxCoeff();
}

}  // namespace

BOOST_AUTO_TEST_SUITE(fields)

BOOST_AUTO_TEST_CASE(divergence) {
  for (const Units& units : two_units) {
    const Solved solved(in_units(loaded_trio(51), units));
    for (const Complex point : fluid_points(solved, 4 * units.length, 0.1 * units.length)) {
      const double h = 5e-4 * units.length;
      const Complex along_x = derivative(solved, point, h);
      const Complex along_y = derivative(solved, point, imaginary * h);
      // The truncation error h^4 and the rounding error eps / h are both near 1e-12.
      BOOST_TEST(std::abs(along_x.real() + along_y.imag()) < 1e-10 * units.rate);
      BOOST_TEST(std::abs(along_x) + std::abs(along_y) > 1e-2 * units.rate);
    }
  }
}

// Vorticity and strain are those of the velocity; pressure and vorticity satisfy the momentum
// balance grad p = mu rot w. Central differences of order 4 have errors of about 1e-9.
BOOST_AUTO_TEST_CASE(derivatives_are_those_of_the_velocity) {
  for (const Units& units : two_units) {
    for (const double amplitude : {1.0, -1.0}) {
      Solved solved(in_units(loaded_trio(58), units));
      const auto& [configuration, forcing, cell, shifts] = solved.solution.instant;
      solved.solution = solved.solver.solve({configuration, scaled(amplitude, forcing)});
      const double h = 1e-3 * units.length;
      for (const Complex point : fluid_points(solved, 4 * units.length, 0.1 * units.length)) {
        const auto along = [&](Complex step) {
          const ComplexVector points{
              {point - 2.0 * step, point - step, point + step, point + 2.0 * step}};
          const auto difference = [&](const auto& f) {
            return (f(0) - 8.0 * f(1) + 8.0 * f(2) - f(3)) / (12.0 * h);
          };
          const ComplexVector u = solved.solver.velocity(solved.solution, points);
          const auto flow = solved.solver.derivatives(solved.solution, points);
          return std::array<Complex, 2>{
              difference([&](Eigen::Index i) { return u[i]; }), difference([&](Eigen::Index i) {
                const FlowDerivatives& at = flow[static_cast<std::size_t>(i)];
                return Complex{at.pressure, at.vorticity};
              })};
        };
        const auto [u_x, pw_x] = along(h);
        const auto [u_y, pw_y] = along(imaginary * h);
        const FlowDerivatives at =
            solved.solver.derivatives(solved.solution, ComplexVector{{point}})[0];
        BOOST_TEST(std::abs(at.vorticity - (u_x.imag() - u_y.real())) < 1e-7 * units.rate);
        BOOST_TEST(std::abs(at.strain - Complex(u_x.real() - u_y.imag(), u_x.imag() + u_y.real())) <
                   1e-7 * units.rate);
        const double scale = 1e-6 * units.rate / units.length;
        BOOST_TEST(std::abs(pw_x.real() + pw_y.imag()) < scale);
        BOOST_TEST(std::abs(pw_y.real() - pw_x.imag()) < scale);
      }
    }
  }
}

// In a disk without bodies the laws of circle_averages.hpp hold without force and torque: <u>(r) -
// u(0) = d r^2 makes u biharmonic, and <u_theta> = A r makes the vorticity harmonic. Together they
// are the momentum balance.
BOOST_AUTO_TEST_CASE(momentum) {
  for (const Units& units : two_units) {
    const Solved solved(in_units(loaded_trio(52), units));
    for (const Complex point : fluid_points(solved, 4 * units.length, 0.25 * units.length)) {
      const double r = 0.1 * units.length;
      const Complex centre = solved.velocity(ComplexVector{{point}})[0];
      const CircleAverage small = circle_average(solved, point, r),
                          large = circle_average(solved, point, 2 * r);
      BOOST_TEST(std::abs(large.velocity - centre - 4.0 * (small.velocity - centre)) <
                 1e-12 * units.velocity());
      BOOST_TEST(std::abs(large.azimuthal - 2.0 * small.azimuthal) < 1e-12 * units.velocity());
      BOOST_TEST(std::abs(large.radial) < 1e-12 * units.velocity());
    }
  }
}

// The points lie between the nodes of every shape, at 1e-2, 1e-6 and 0 units of length from the
// surface. The error of the field there is proportional to the tail of the density. The error of
// the motions, whose tolerance is 1e-12, is proportional to the square of this tail.
BOOST_AUTO_TEST_CASE(boundary_condition_between_nodes) {
  for (const Units& units : two_units) {
    const Solved solved(in_units(loaded_trio(53), units));
    for (std::size_t k = 0; k < 3; ++k) {
      const SmoothCurve curve = smooth_curve(*solved.solution.discretisation[k],
                                             solved.solution.instant.configuration[k]);
      const RigidMotion& motion = solved.motion(k);
      for (const double t : {0.1234, 1.777, 2.9, 4.4321, 5.9}) {
        const auto jet = curve.at(t);
        const Complex out = -imaginary * jet.first / std::abs(jet.first);
        const Complex rigid =
            motion.velocity +
            motion.omega * perp(jet.value - solved.solution.instant.configuration[k].position);
        const auto slip = [&](double height) {
          const Complex point = jet.value + height * units.length * out;
          return (solved.velocity(ComplexVector{{point}})[0] - rigid) / units.velocity();
        };
        BOOST_TEST(std::abs(slip(0.0)) < 1e-9);
        // The slip is extrapolated to the surface from two heights; a term of second order remains.
        BOOST_TEST(std::abs(2.0 * slip(1e-6) - slip(2e-6)) < 1e-9);
        BOOST_TEST(std::abs(2.0 * slip(1e-2) - slip(2e-2)) < 2e-2);
        BOOST_TEST(std::abs(slip(1e-2)) < 0.2);
      }
    }
  }
}

// Close to the surface, the field equals the field of a solution with other nodes.
BOOST_AUTO_TEST_CASE(close_field_does_not_depend_on_nodes) {
  const Scene coarse = loaded_trio(54);
  Scene fine = coarse;
  for (Body& body : fine.bodies) body.n_nodes = body.n_nodes * 3 / 2 / 2 * 2;
  const Solved a(coarse), b(fine);
  for (std::size_t k = 0; k < 3; ++k) {
    const SmoothCurve curve =
        smooth_curve(*a.solution.discretisation[k], a.solution.instant.configuration[k]);
    for (const double height : {1e-9, 1e-4, 1e-2, 0.03, 0.1}) {
      ComplexVector points(7);
      for (Eigen::Index i = 0; i < 7; ++i) {
        const auto jet = curve.at(0.9 * static_cast<double>(i));
        points[i] = jet.value - height * imaginary * jet.first / std::abs(jet.first);
      }
      BOOST_TEST((a.velocity(points) - b.velocity(points)).cwiseAbs().maxCoeff() < 1e-9);
    }
  }
}

// Far away, the disturbance of a load-free suspension is the field of its stresslets, -(r.S.r) r /
// (2 pi mu rho^4), up to terms of order rho^-2.
BOOST_AUTO_TEST_CASE(far_field_of_stresslets) {
  std::mt19937_64 random(55);
  const Solved solved(resolved(scene(random_bodies(random), ShearFlow{1})));
  Complex stresslet{};
  for (std::size_t k = 0; k < 3; ++k) stresslet += solved.stresslet(k);
  const auto remainder = [&](double radius) {
    ComplexVector points(3);
    for (Eigen::Index i = 0; i < 3; ++i)
      points[i] = std::polar(radius, 2.0 * static_cast<double>(i) + 0.3);
    ComplexVector u = solved.velocity(points) - background_velocity(ShearFlow{1}, points);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Complex r = points[i];
      const double rsr = (std::conj(r * r) * stresslet).real();
      u[i] += rsr * r / (2 * std::numbers::pi * std::pow(std::abs(r), 4));
    }
    return u.cwiseAbs().maxCoeff();
  };
  BOOST_TEST(remainder(100) < 0.1 * std::abs(stresslet) / (2 * std::numbers::pi * 100));
  BOOST_TEST(remainder(100) / remainder(400) == 16.0, boost::test_tools::tolerance(0.1));
}

// A net force causes the far field -log(rho / ell) F / (4 pi mu) + r (r.F) / (4 pi mu rho^2) about
// its centre of action.
BOOST_AUTO_TEST_CASE(far_field_of_forces) {
  Scene trio = loaded_trio(56);
  trio.flow = QuiescentFlow{};
  const Solved solved(trio);
  Complex force{};
  for (const Body& body : trio.bodies) force += body.force;
  const auto remainder = [&](double radius) {
    const Complex r = std::polar(radius, 0.7);
    const Complex stokeslet =
        (-std::log(radius / 20.0) * force + r * (dot(r, force) / std::norm(r))) /
        (4 * std::numbers::pi);
    return std::abs(solved.velocity(ComplexVector{{r}})[0] - stokeslet);
  };
  BOOST_TEST(remainder(1e3) < 1e-3);
  BOOST_TEST(remainder(1e3) / remainder(1e4) == 10.0, boost::test_tools::tolerance(0.05));
}

// A held body in a stream has no net force: the fluid far away then moves at the reported uniform
// velocity.
BOOST_AUTO_TEST_CASE(uniform_velocity_at_infinity) {
  Scene held = loaded_trio(57);
  held.flow = QuiescentFlow{};
  held.gauge_length.reset();
  Body& body = held.bodies[0];
  body = held_body(body.shape, body.n_nodes, body.position, body.orientation, {{1.0, 0.3}, 0.5});
  const Solved solved(held);
  const auto remainder = [&](double radius) {
    return std::abs(solved.velocity(ComplexVector{{std::polar(radius, 0.7)}})[0] -
                    solved.solution.uniform_velocity);
  };
  BOOST_TEST(remainder(1e4) < 1e-3);
  BOOST_TEST(remainder(1e3) / remainder(1e4) == 10.0, boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(errors_of_tractions_by_a_refined_solution) {
  for (const Shape& shape : std::vector<Shape>{Ellipse{1, 0.25}, Star{0.8, 0.1, 3}}) {
    const auto alone = [&](int n_nodes) {
      return scene({body(shape, n_nodes, {2.0, 1.0}, 0.3)}, ShearFlow{0.7});
    };
    const Solved right(alone(256));
    const ComplexVector exact = tractions(right, right.solution);
    Scene rough = alone(automatic_nodes);
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      rough.solver.tolerance = tolerance;
      const Solved solved(rough);
      const Solution refined = solved.solver.solve_refined(solved.solution);
      const ComplexVector found = tractions(solved, solved.solution);
      const double estimate = 2.0 * relative_difference(found, tractions(solved, refined));
      const double error = relative_difference(found, exact);
      BOOST_TEST(error < estimate);
      BOOST_TEST(estimate < 10.0 * error);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stokesbook::test
