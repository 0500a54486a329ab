// Checks velocities, pressures, vorticities and strains of double-layer nodes, forces and torques
// in a cell against Ewald sums, with constants: directly summed near images, the tree, and points
// other than the nodes.
#include "periodic/far_operator.hpp"

#include <cmath>
#include <stdexcept>

#include <boost/test/unit_test.hpp>
#include <omp.h>

#include "fmm/fmm.hpp"
#include "support/lattices.hpp"
#include "support/periodic_sources.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::PeriodicSources;
using test::points_in_cell;
using test::random_sources;
using test::random_vector;

namespace {

// Returns the errors of velocities and of derivatives.
std::pair<double, double> errors(const PeriodicSources& sources, const ComplexVector& targets,
                                 const FmmSettings& settings) {
  const test::PeriodicErrors found =
      test::errors(sources, targets, settings, images_in(sources.lattice));
  return {found.velocity, found.derivatives};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_lattice) {
  for (const test::NamedLattice& named : test::lattices()) {
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const Complex centre = Complex{0.3, -1.2} * lattice.shortest();
      const PeriodicSources sources = random_sources(lattice, centre, 20, 3);
      const auto [velocity, slope] =
          errors(sources, points_in_cell(lattice, centre, 12, 5), {44, 1000});
      BOOST_TEST(velocity < 1e-12);
      BOOST_TEST(slope < 1e-12);
    }
  }
}

// The tree translates the expansions of the sources. Nodes, forces and torques act together; the
// sum at the nodes has no targets of its own.
BOOST_AUTO_TEST_CASE(the_tree_meets_the_tolerance) {
  for (const Lattice& lattice :
       {Lattice({10.2, 0.0}, {4.9, 10.5}), Lattice({10.2, 0.0}, {0.0, 40.0})}) {
    const std::vector<Curve> curves = test::ellipses(4, 64);
    const ComplexVector nodes = all_nodes(curves), points = 5.0 * random_vector(40, 1);
    const ComplexVector elsewhere = points_in_cell(lattice, {3.0, 4.0}, 200, 2);
    ComplexVector density = random_vector(nodes.size(), 3);
    const ComplexVector force = 0.1 * random_vector(40, 4);
    const Eigen::VectorXd torque = 0.1 * random_vector(40, 5).real();
    const FmmStrengths strengths(density, force, torque);
    // The net source of the density is not zero, but both sums have the same centre.
    const FmmSettings one_leaf{44, 10000};
    const ComplexVector exact =
        Fmm(curves, points, one_leaf, images_in(lattice)).velocity(strengths);
    const Fmm at_targets(curves, points, elsewhere, one_leaf, images_in(lattice));
    const ComplexVector exact_there = at_targets.velocity(strengths);
    const std::vector<FlowDerivatives> slopes = at_targets.derivatives(strengths);
    for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
      const FmmSettings settings = FmmSettings::for_tolerance(tolerance);
      const Fmm fmm(curves, points, settings, images_in(lattice));
      BOOST_TEST(test::relative_error(fmm.velocity(strengths).col(0), exact) < tolerance);
      const Fmm there(curves, points, elsewhere, settings, images_in(lattice));
      BOOST_TEST(test::relative_error(there.velocity(strengths).col(0), exact_there) < tolerance);
      BOOST_TEST(test::relative_error(there.derivatives(strengths), slopes) < 100.0 * tolerance);
    }
  }
}

// Few large boxes, with sources on their rims, require the highest order. The far operator alone
// therefore meets the tolerance of the settings.
BOOST_AUTO_TEST_CASE(order_from_the_tolerance) {
  for (const test::NamedLattice& named : test::lattices()) {
    if (named.name == "1:100") continue;  // for the time
    BOOST_TEST_CONTEXT(named.name) {
      const Lattice lattice = named.lattice();
      const PeriodicSources sources = random_sources(lattice, 0.0, 60, 5);
      const test::PointStrengths strengths(sources);
      const ComplexVector targets = points_in_cell(lattice, 0.0, 60, 5);
      const auto sum = [&](const FmmSettings& settings) -> ComplexVector {
        const Fmm fmm({sources.curve}, strengths.positions, targets, settings, images_in(lattice));
        return fmm.velocity({sources.density, strengths.force, strengths.torque});
      };
      const ComplexVector exact = sum({44, 1000});
      for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const int order = FmmSettings::for_tolerance(tolerance).order;
        BOOST_TEST(test::relative_error(sum({order, 1000}), exact) < tolerance);
      }
    }
  }
}

// Forces and torques that do not balance leave the flow periodic. The pressure rises by F.w / V
// along a lattice vector w; a net source Q adds Q w / 2V to the velocity.
BOOST_AUTO_TEST_CASE(periodic_flow) {
  const Complex a1{1.0, 0.0}, a2{0.3, 1.0};
  const Lattice lattice(a1, a2);
  PeriodicSources sources = random_sources(lattice, 0.0, 20, 3);
  for (const double net_source : {0.0, 0.7}) {
    sources.density += net_source / weights(sources.curve).sum() * normals(sources.curve);
    const test::PointStrengths strengths(sources);
    const Complex total = strengths.force.sum();
    BOOST_TEST(std::abs(total) > 0.1);
    const ComplexVector z = points_in_cell(lattice, 0.0, 10, 5);
    for (const Complex w : {a1, a2, a1 - 2.0 * a2}) {
      ComplexVector targets(20);
      targets << z, (z.array() + w).matrix();
      const Fmm fmm({sources.curve}, strengths.positions, targets, {44, 1000}, images_in(lattice));
      const FmmStrengths all(sources.density, strengths.force, strengths.torque);
      const ComplexVector velocity = fmm.velocity(all);
      const std::vector<FlowDerivatives> slopes = fmm.derivatives(all);
      const double scale = velocity.cwiseAbs().maxCoeff();
      for (Index i = 0; i < 10; ++i) {
        const FlowDerivatives &here = slopes[static_cast<std::size_t>(i)],
                              &there = slopes[static_cast<std::size_t>(i + 10)];
        BOOST_TEST(std::abs(velocity[i + 10] - velocity[i] - 0.5 * net_source * w) < 1e-12 * scale);
        BOOST_TEST(std::abs(there.pressure - here.pressure - dot(total, w)) < 1e-11 * scale);
        BOOST_TEST(std::abs(there.vorticity - here.vorticity) < 1e-11 * scale);
        BOOST_TEST(std::abs(there.strain - here.strain) < 1e-11 * scale);
      }
    }
  }
}

// The double layer of a rigid motion is zero in the fluid, also beside the images of the curve.
BOOST_AUTO_TEST_CASE(rigid_motion_of_a_curve) {
  const Lattice lattice({1.0, 0.0}, {0.3, 1.0});
  const Complex centre{0.2, 0.1};
  const Curve curve = place(sample(Ellipse{0.3, 0.2}, 100, Side::fluid_outside), centre, 0.4);
  const ComplexVector targets{{Complex{-0.3, 0.3}, Complex{0.72, 0.1}, Complex{0.2, 0.55}}};
  const Fmm fmm({curve}, {}, targets, {44, 1000}, images_in(lattice));
  for (const Complex velocity : {Complex{1.0, 0.0}, Complex{0.0, 1.0}}) {
    const ComplexVector density = ComplexVector::Constant(100, velocity);
    BOOST_TEST(test::largest(fmm.velocity(density)) < 1e-12);
  }
  const ComplexVector spin = imaginary * (curve.x.array() - centre);
  BOOST_TEST(test::largest(fmm.velocity(spin)) < 1e-12);
}

// Cells far from the origin, sources in several cells, and a single small body.
BOOST_AUTO_TEST_CASE(places_of_the_sources) {
  const Lattice lattice({1.0, 0.0}, {0.3, 1.0});
  const Complex far{3e3, -1e4};
  const auto away =
      errors(random_sources(lattice, far, 20, 3), points_in_cell(lattice, far, 12, 5), {44, 1000});
  BOOST_TEST(std::max(away.first, away.second) < 1e-10);  // rounding of the positions
  PeriodicSources scattered = random_sources(lattice, 0.0, 20, 3);
  scattered.curve.x[3] += 2.0;
  scattered.curve.x[7] -= Complex{1.3, 4.0};
  scattered.points[1].position += Complex{-0.3, -1.0};
  const auto several = errors(scattered, points_in_cell(lattice, {1.0, 1.0}, 12, 5), {44, 1000});
  BOOST_TEST(std::max(several.first, several.second) < 1e-12);
  PeriodicSources small = random_sources(lattice, 0.0, 20, 3);
  small.curve.x *= 1e-3;
  for (PointForce& point : small.points) point.position *= 1e-3;
  const auto near = errors(small, 1e-3 * points_in_cell(lattice, 0.0, 12, 5), {44, 1000});
  BOOST_TEST(std::max(near.first, near.second) < 1e-12);
}

// Most near images are converted to local expansions of large boxes, so that a sum in a cell has
// few operations more than the same sum without images.
BOOST_AUTO_TEST_CASE(the_cost_of_a_cell) {
  const std::vector<Curve> curves = test::ellipses(10, 64);
  const FmmSettings settings = FmmSettings::for_tolerance(1e-9);
  const Lattice lattice({25.0, 0.0}, {9.0, 25.0});
  const auto cost = [&](const Fmm& fmm) {
    double operations = 0.0;
    for (const Interactions& image : fmm.all_interactions()) {
      for (std::size_t b = 0; b < image.far.size(); ++b) {
        operations +=
            static_cast<double>(image.far[b].size()) * 0.5 * settings.order * settings.order;
        for (const Range range : image.near[b]) {
          operations +=
              static_cast<double>((range.last - range.first) * fmm.targets().boxes[b].size());
        }
      }
    }
    return operations;
  };
  const double open = cost(Fmm(curves, {}, settings)),
               closed = cost(Fmm(curves, {}, settings, images_in(lattice)));
  BOOST_TEST(closed > open);
  BOOST_TEST(closed < 2.0 * open);
}

BOOST_AUTO_TEST_CASE(the_same_bits_for_any_number_of_threads) {
  const std::vector<Curve> curves = test::ellipses(6, 64);
  const ComplexVector density = random_vector(36 * 64, 1);
  const int threads_before = omp_get_max_threads();
  const auto velocity = [&](int threads) {
    omp_set_num_threads(threads);
    return Fmm(curves, {}, {12, 20}, images_in(Lattice({16.0, 0.0}, {7.0, 15.0})))
        .velocity(density);
  };
  const Eigen::MatrixXcd alone = velocity(1);
  for (const int threads : {2, 3}) BOOST_TEST((velocity(threads) == alone));
  omp_set_num_threads(threads_before);
}

BOOST_AUTO_TEST_CASE(an_order_of_one_is_refused) {
  BOOST_CHECK_THROW(FarOperator(Lattice(1.0, imaginary), 0.7, 1), std::invalid_argument);
  BOOST_CHECK_NO_THROW(FarOperator(Lattice(1.0, imaginary), 0.7, 2));
}
