// Tests the contact mobility: columns that are reused from earlier configurations and refined give
// the same motions as separate solves for each load (chapter 12).

#include "suspension/contact/contact_mobility.hpp"

#include <Eigen/Geometry>
#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "scaled_eigenvalues.hpp"
#include "scenes.hpp"
#include "support/touching.hpp"

namespace stokesbook::test {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

using Loads = Eigen::SparseMatrix<double>;

// Returns forces that push neighbours in a chain of five disks apart, at contact points that are
// turned by an angle.
Loads pushes(const Configuration& chain, double turn) {
  Loads loads(15, 4);
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const Complex apart = chain[i].position - chain[i + 1].position;
    const Complex force = std::polar(1.0, std::arg(apart) + turn);
    for (const auto& [body, sign] : {std::pair{k, 1.0}, std::pair{k + 1, -1.0}}) {
      loads.insert(3 * body, k) = sign * force.real();
      loads.insert(3 * body + 1, k) = sign * force.imag();
      loads.insert(3 * body + 2, k) = -std::sin(turn);
    }
  }
  return loads;
}

struct Chain {
  SuspensionSolver solver{disk_chain(0.1)};
  Configuration start = solver.start().configuration;

  // Returns the configuration after each body has moved and turned by some thousandths.
  Configuration moved() const {
    Configuration moved = start;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const auto i = static_cast<double>(k);
      moved[k].position += 0.004 * std::polar(1.0, i * i);
      moved[k].orientation += 0.003 * i;
    }
    return moved;
  }

  MatrixXd exact(const Configuration& configuration, const Loads& loads) const {
    MobilityColumns none;
    none.tolerance = 0.0;
    return ContactMobility(solver, solver.solve(solver.instant(configuration)), none)(loads);
  }
};

// Two disks touch each other and their container, and one load pushes each of the three pairs
// apart. The sum of these loads hardly moves the disks, since fluid enters the space between the
// three boundaries only through the gaps.
struct TrappedFluid {
  Scene scene;
  Loads loads{9, 3};

  TrappedFluid(double gap, double tolerance) {
    const double radius = 0.25, from_centre = 1.0 - radius - gap, aside = radius + 0.5 * gap;
    const double below = -std::sqrt(from_centre * from_centre - aside * aside);
    scene.bodies = {body(Circle{radius}, automatic_nodes, {-aside, below}),
                    body(Circle{radius}, automatic_nodes, {aside, below}, 0.0, {{0.0, -1.0}, 0.0})};
    scene.walls = {outer_wall(Circle{1.0}, automatic_nodes)};
    scene.solver.tolerance = tolerance;
    scene.solver.preconditioner = PreconditionerKind::block_diagonal;
    for (const int disk : {0, 1}) {
      const Complex position = scene.bodies[static_cast<std::size_t>(disk)].position;
      const Complex inwards = -position / std::abs(position);
      loads.insert(3 * disk, disk) = inwards.real();
      loads.insert(3 * disk + 1, disk) = inwards.imag();
      loads.insert(3 * disk, 2) = disk == 0 ? -1.0 : 1.0;
    }
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(lasting_loads_take_no_solves_of_their_own) {
  const Chain chain;
  ContactMobility before(chain.solver, chain.solver.solve(chain.solver.instant(chain.start)));
  before(pushes(chain.start, 0.0));
  BOOST_TEST(before.solves() == 4);
  BOOST_TEST(before.cost().gmres_iterations >= 4);
  BOOST_TEST(before.cost().matvecs >= before.cost().gmres_iterations);
  const Configuration moved = chain.moved();
  const Loads loads = pushes(moved, 0.0);
  ContactMobility now(chain.solver, chain.solver.solve(chain.solver.instant(moved)),
                      before.columns());
  now(loads);
  BOOST_TEST(now.solves() == 0);
  const VectorXd weights{{3e3, 1e3, 2e3, 5e2}};  // the resulting flow is stronger than the shear
  const VectorXd expected = chain.exact(moved, loads) * weights;
  const auto error = [&] {
    return (now(loads) * weights - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  };
  BOOST_TEST(error() > 1e-5);
  while (now.refine(weights)) now(loads);
  BOOST_TEST(error() < 1e-6);  // 1e-6 is a hundred times the residual of the solver
  BOOST_TEST(now.solves() <= 2);
}

// While bodies move smoothly, the density of lasting loads changes as it did before, in proportion
// to time.
BOOST_AUTO_TEST_CASE(changes_of_lasting_loads_are_foreseen) {
  const Chain chain;
  const VectorXd weights{{3.0, 1.0, 2.0, 0.5}};
  Configuration moving = chain.start;
  MobilityColumns earlier;
  int step = 0;
  double t = 1.0;
  for (const double dt : {0.0, 0.02, 0.02, 0.01}) {
    for (std::size_t k = 0; k < moving.size(); ++k) {
      const auto i = static_cast<double>(k);
      moving[k].position += dt * 0.2 * std::polar(1.0, i * i);
      moving[k].orientation += dt * 0.15 * i;
    }
    t += dt;
    LoadColumns now(chain.solver, chain.solver.solve(chain.solver.instant(moving)), earlier, 1e-9,
                    t);
    const std::vector<std::size_t> columns = now.find(pushes(moving, 0.0)).columns;
    Eigen::SparseVector<double> load(15);
    ComplexVector density = ComplexVector::Zero(now[0].density.size());
    for (const std::size_t i : columns) {
      const double weight = weights[static_cast<Index>(i)];
      load += weight * now[i].load;
      density += weight * now[i].density;
    }
    const ComplexVector expected = now.expected_change(load),
                        change =
                            deinterleaved(now.solve(now.rhs_under(load), 1e-10, density).solution) -
                            density;
    BOOST_TEST_CONTEXT("step " << step) {
      BOOST_TEST((expected.size() > 0) == (step > 1));
      if (step > 1) BOOST_TEST((expected - change).norm() < 0.1 * change.norm());
    }
    now.remember_change(load, change);
    BOOST_TEST(now.expected_change(load).size() == 0);
    for (const std::size_t i : columns) {
      const double part = weights[static_cast<Index>(i)] / weights.squaredNorm();
      now.correct(i, part * change, 0.0);
    }
    earlier = now.for_next_configuration();
    ++step;
  }
}

// Combinations that were made accurate stay so while others are. Columns that are solved for again
// change them: they are made accurate once more.
BOOST_AUTO_TEST_CASE(combinations_remain_accurate) {
  const Chain chain;
  const Loads loads = pushes(chain.start, 0.0);
  ContactMobility now(chain.solver, chain.solver.solve(chain.solver.instant(chain.start)));
  const VectorXd first{{3e3, 1e3, 2e3, 5e2}}, second{{3e3, 1.2e3, 2e3, 5e2}};
  const MatrixXd exact = chain.exact(chain.start, loads);
  const auto error = [&](const VectorXd& weights) {
    const VectorXd expected = exact * weights;
    return (now(loads) * weights - expected).cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff();
  };
  now(loads);
  while (now.refine(first)) now(loads);
  BOOST_TEST(error(second) > 1e-5);
  while (now.refine(second)) now(loads);
  BOOST_TEST(error(first) < 1e-6);
  for (int times = 0; times < 2; ++times) BOOST_TEST(now.tighten());
  BOOST_TEST(error(second) > 1e-6);
  while (now.refine(second)) now(loads);
  BOOST_TEST(error(second) < 1e-6);
}

// If the whole configuration turns rigidly, the loads and the velocities turn with it.
BOOST_AUTO_TEST_CASE(loads_turn_with_the_components) {
  const Chain chain;
  ContactMobility before(chain.solver, chain.solver.solve(chain.solver.instant(chain.start)));
  MatrixXd expected = before(pushes(chain.start, 0.0));
  const double turn = 0.5;
  Configuration turned = chain.start;
  for (Pose& pose : turned) {
    pose.position *= std::polar(1.0, turn);
    pose.orientation += turn;
  }
  ContactMobility now(chain.solver, chain.solver.solve(chain.solver.instant(turned)),
                      before.columns());
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
  for (Index k = 0; k < 5; ++k) {
    expected.middleRows<2>(3 * k) = (rotation * expected.middleRows<2>(3 * k)).eval();
  }
  BOOST_TEST((now(pushes(turned, 0.0)) - expected).norm() < 1e-10 * expected.norm());
  BOOST_TEST(now.solves() == 0);
}

BOOST_AUTO_TEST_CASE(loads_that_have_turned_are_solved_for) {
  const Chain chain;
  const Solution solution = chain.solver.solve(chain.solver.instant(chain.start));
  ContactMobility before(chain.solver, solution);
  before(pushes(chain.start, 0.0));
  ContactMobility now(chain.solver, solution, before.columns());
  now(pushes(chain.start, 0.2));
  BOOST_TEST(now.solves() == 4);
}

// Residuals of columns are relative to the norms of their right-hand sides. These norms are not
// computed again for loads that have grown and turned a little with the bodies.
BOOST_AUTO_TEST_CASE(reused_columns_know_the_norms_of_their_flows) {
  const Chain chain;
  const auto columns_at = [&](const Configuration& configuration, MobilityColumns earlier) {
    return LoadColumns(chain.solver, chain.solver.solve(chain.solver.instant(configuration)),
                       std::move(earlier), 1e-8);
  };
  LoadColumns before = columns_at(chain.start, {});
  before.find(pushes(chain.start, 0.0));
  LoadColumns now = columns_at(chain.moved(), before.for_next_configuration());
  now.find(2e3 * pushes(chain.moved(), 0.0));
  BOOST_TEST(now.solves() == 0);
  BOOST_REQUIRE(now.size() == 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    BOOST_TEST(now[k].rhs_norm == now.rhs_under(now[k].load).norm(),
               boost::test_tools::tolerance(0.1));
  }
}

BOOST_AUTO_TEST_CASE(a_stage_without_loads_keeps_the_columns_of_the_stage_before) {
  const Chain chain;
  const Solution solution = chain.solver.solve(chain.solver.instant(chain.start));
  const Loads all = pushes(chain.start, 0.0);
  ContactMobility first(chain.solver, solution);
  first(all);
  const MobilityColumns kept = ContactMobility(chain.solver, solution, first.columns()).columns();
  ContactMobility again(chain.solver, solution, kept);
  again(all);
  BOOST_TEST(again.solves() == 0);
  ContactMobility fewer(chain.solver, solution, kept);
  fewer(all.rightCols(1));
  BOOST_TEST(fewer.columns().loads.cols() == 1);
}

// At two points of a flat gap the loads are nearly parallel. The difference of their columns must
// have the same relative accuracy as each column.
BOOST_AUTO_TEST_CASE(loads_that_are_nearly_parallel_are_told_apart) {
  const Chain chain;
  for (const double turn : {1e-1, 1e-2, 1e-3}) {
    Loads loads(15, 2);
    loads.col(0) = pushes(chain.start, 0.0).col(1);
    loads.col(1) = pushes(chain.start, turn).col(1);
    const VectorXd difference{{-1.0, 1.0}};
    const VectorXd expected = chain.exact(chain.start, loads) * difference;
    ContactMobility respond(chain.solver, chain.solver.solve(chain.solver.instant(chain.start)));
    const VectorXd found = respond(loads) * difference;
    BOOST_TEST((found - expected).norm() < 0.1 * expected.norm());
  }
}

// The errors of columns from a configuration with wider gaps exceed the smallest eigenvalue, until
// the columns are corrected or computed anew.
BOOST_AUTO_TEST_CASE(responses_around_trapped_fluid_are_definite) {
  const double gap = 2e-3;
  const auto respond_at = [](const SuspensionSolver& solver, const MobilityColumns& earlier) {
    return ContactMobility(solver, solver.solve(solver.start()), earlier);
  };
  const auto softest = [](const TrappedFluid& trapped, const MatrixXd& velocities) {
    return scaled_eigenvalues(trapped.loads.transpose() * velocities)[0];
  };
  MobilityColumns none;
  none.tolerance = 0.0;
  const TrappedFluid resolved(gap, 1e-6);
  const SuspensionSolver exactly(resolved.scene);
  const double expected = softest(resolved, respond_at(exactly, none)(resolved.loads));
  BOOST_TEST(expected > 0.0);
  BOOST_TEST(expected < 1e-2);

  const TrappedFluid wider(2.0 * gap, 1e-2), now(gap, 1e-2);
  const SuspensionSolver before(wider.scene), solver(now.scene);
  ContactMobility earlier = respond_at(before, {});
  earlier(wider.loads);
  ContactMobility response = respond_at(solver, earlier.columns());
  double most_corrected = 0.0;
  for (const double weight : {1.0, 3e3}) {
    const VectorXd weights = VectorXd::Constant(3, weight);
    do {
      BOOST_TEST(softest(now, response(now.loads)) > 0.0);
      const double corrected = response.relative_correction(weights);
      most_corrected = std::max(most_corrected, corrected);
      // The correction of a large load is measured relative to the velocities that the load causes,
      // so it does not depend on how large the load is.
      if (weight > 1.0) {
        BOOST_TEST(response.relative_correction(10.0 * weights) == corrected,
                   boost::test_tools::tolerance(1e-3));
      }
    } while (response.refine(weights));
    BOOST_TEST(response.relative_correction(weights) <= 0.1 * now.scene.solver.tolerance);
  }
  BOOST_TEST(most_corrected > now.scene.solver.tolerance);
}

}  // namespace stokesbook::test
