// Checks the contact loop (11.9), (11.10) on scenes without flow whose solutions are known: a point
// and a disk, points in a row, a rod on a floor, a crowd of disks.
#include "lcp/contact_loop.hpp"

#include <boost/test/unit_test.hpp>

#include "support/contact_scenes.hpp"
#include "support/dense.hpp"

namespace stokesbook::test {

namespace {

MatrixXd random_mobility(Index n, unsigned seed) {
  return definite_matrix(n, seed) + MatrixXd::Identity(n, n);
}

double energy(const VectorXd& velocity, const MatrixXd& mobility) {
  return velocity.dot(solve(mobility, velocity));
}

// A point's free motion ends within the unit disk; contact forces act along x at any place.
ContactStep pushed_along_x() {
  ContactStep step = point_and_disk(vector2(1.5, 0.0), vector2(-1.0, 0.4), 1.0);
  step.rows = [rows = step.rows](const VectorXd& velocity) {
    ContactRows result = rows(velocity);
    result.force_gradient = MatrixXd(vector2(1.0, 0.0).transpose()).sparseView();
    return result;
  };
  return step;
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_contact_nothing_is_asked_for) {
  ContactStep step = point_and_disk(vector2(3.0, 0.0), vector2(-1.0, 0.5), 1.0);
  step.respond = [](const Eigen::SparseMatrix<double>&) -> MatrixXd {
    throw std::logic_error("asked");
  };
  const ContactResult result = resolve_contact(step);
  BOOST_TEST(resolved(result));
  BOOST_TEST(result.iterations == 0);
  BOOST_TEST((result.velocity == step.free_velocity));
  BOOST_TEST(result.force == VectorXd::Zero(2));
  BOOST_TEST(result.reason.empty());
}

BOOST_AUTO_TEST_CASE(a_point_against_a_disk_ends_at_the_nearest_point) {
  // With the mobility B = 1, the point ends at the projection of its free end onto the circle.
  for (const double slip : {0.0, 0.1, 0.4, -0.7}) {
    const VectorXd start = vector2(1.5, 0.0), free = vector2(-1.0, slip);
    const ContactStep step = point_and_disk(start, free, 1.0);
    const ContactResult result = resolve_contact(step);
    const VectorXd free_end = start + free, end = free_end.normalized();
    BOOST_TEST_CONTEXT("slip " << slip << ", iterations " << result.iterations) {
      BOOST_TEST(resolved(result));
      BOOST_TEST(largest(start + result.velocity - end) < 1e-4);
      BOOST_TEST(std::abs(result.multipliers[0] - (1.0 - free_end.norm())) < 1e-4);
      BOOST_TEST(std::abs(result.power - result.multipliers[0] * end.dot(result.velocity)) < 1e-4);
      BOOST_TEST(result.iterations <= 4);
      BOOST_TEST(result.columns == result.iterations);
      BOOST_TEST(result.violations.size() == static_cast<std::size_t>(result.iterations + 1));
      BOOST_TEST(result.kkt_residual <= 1e-3);
    }
  }
}

// Forces act along x at any place of the point. The free end is (1/2, 2/5), and the loop is
// Newton's method for g(f) = |(1/2 + f, 2/5)| - 1 = 0. Each iteration changes the error from e to
// g'' e^2 / (2 g').
BOOST_AUTO_TEST_CASE(convergence_is_quadratic) {
  ContactStep step = pushed_along_x();
  step.tolerance = 1e-15;
  const double x = std::sqrt(1.0 - 0.16), factor = 0.16 / (2.0 * x);
  const auto error_after = [&](int iterations) {
    return resolve_contact(step, {.max_iterations = iterations}).multipliers[0] - (x - 0.5);
  };
  double before = error_after(1);
  BOOST_TEST(before > 0.04);
  for (const int iterations : {2, 3}) {
    const double error = error_after(iterations);
    BOOST_TEST(error == factor * before * before, boost::test_tools::tolerance(0.1));
    before = error;
  }
  BOOST_TEST(std::abs(error_after(4)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_guess_of_the_velocity_saves_iterations_and_changes_no_solution) {
  ContactStep step = pushed_along_x();
  step.tolerance = 1e-12;
  const ContactResult from_free = resolve_contact(step);
  step.guess = from_free.velocity + vector2(1e-7, -1e-7);
  const ContactResult from_near = resolve_contact(step);
  BOOST_TEST(from_free.iterations >= 3);
  BOOST_TEST(from_near.iterations == 1);
  BOOST_TEST(largest(from_near.velocity - from_free.velocity) < 1e-11);
  BOOST_TEST(from_near.violations.front() == from_free.violations.front());
  // If the free motion has no contact, the solution has no contact either, whatever the guess is.
  step.free_velocity = vector2(1.0, 0.0);
  const ContactResult open = resolve_contact(step);
  BOOST_TEST(open.iterations == 0);
  BOOST_TEST((open.velocity == step.free_velocity));
}

BOOST_AUTO_TEST_CASE(forces_along_another_direction_than_the_gradient) {
  // Forces act along x, so the point ends on the circle, displaced along x from its free end.
  ContactStep step = pushed_along_x();
  step.tolerance = 1e-13;
  const ContactResult result = resolve_contact(step, {.open_gap = 1e-9});
  BOOST_TEST(resolved(result));
  const double x = std::sqrt(1.0 - 0.16);
  BOOST_TEST(largest(result.velocity - vector2(x - 1.5, 0.4)) < 1e-12);
  BOOST_TEST(std::abs(result.multipliers[0] - (x - 0.5)) < 1e-12);
  BOOST_TEST(largest(result.force - vector2(x - 0.5, 0.0)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_resting_start_stays_for_every_time_step) {
  const VectorXd down = vector2(2.0, -3.0);
  for (const double dt : {1e-6, 1e-3, 1.0, 1e3}) {
    ContactStep step = step_of(down, dt, random_mobility(2, 1), [dt](const VectorXd& velocity) {
      RowBuilder builder(2);
      builder.add({0, 0}, dt * velocity[1], vector2(0.0, 1.0));
      return builder.rows();
    });
    step.tolerance = 1e-12;
    const ContactResult result = resolve_contact(step);
    BOOST_TEST(resolved(result), "dt = " << dt);
    BOOST_TEST(result.iterations == 1, "dt = " << dt);
    BOOST_TEST(std::abs(dt * result.velocity[1]) <= 1e-12, "dt = " << dt);
    BOOST_TEST(std::abs(result.power) < 1e-12, "dt = " << dt);
  }
}

BOOST_AUTO_TEST_CASE(more_contacts_than_unknowns_leave_the_velocity_unique) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Index n = 8;
    const MatrixXd mobility = random_mobility(n, seed);
    const ContactStep step = row_of_points(normal_matrix(n, 1, seed), 1.0, mobility);
    const ContactResult pivoted = resolve_contact(step);
    const ContactResult newton = resolve_contact(step, {.solver = fischer_newton});
    BOOST_TEST_CONTEXT("seed " << seed) {
      BOOST_TEST(resolved(pivoted));
      BOOST_TEST(resolved(newton));
      BOOST_TEST(pivoted.iterations <= 1);
      BOOST_TEST(largest(pivoted.velocity - newton.velocity) < 1e-7);
      BOOST_TEST(largest(pivoted.force - newton.force) < 1e-6);
      // The forces are equal and opposite.
      BOOST_TEST(std::abs(pivoted.force.sum()) < 1e-13 * (1.0 + largest(pivoted.force)));
    }
  }
}

BOOST_AUTO_TEST_CASE(contact_takes_energy_and_never_gives_any) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const Index n = 8;
    const MatrixXd mobility = random_mobility(n, seed);
    const VectorXd free = normal_matrix(n, 1, seed);
    const ContactResult result = resolve_contact(row_of_points(free, 1.0, mobility));
    const VectorXd reaction = result.velocity - free;
    BOOST_TEST_CONTEXT("seed " << seed) {
      BOOST_TEST(result.power <= 1e-13);
      BOOST_TEST(energy(result.velocity, mobility) <= energy(free, mobility) + 1e-12);
      BOOST_TEST(largest(reaction - mobility * result.force) < 1e-12);
      for (Index i = 0; i < result.multipliers.size(); ++i) {
        BOOST_TEST(result.multipliers[i] >= 0.0);
        BOOST_TEST(std::abs(result.response[i] * result.multipliers[i] * result.gaps[i]) < 1e-10);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_contact_of_the_free_motion_that_is_open_at_the_solution_carries_no_force) {
  // A point falls onto a floor at 0. A second contact exists only for ends below -0.5, such as the
  // end of the free motion at -1.
  ContactStep step = step_of(VectorXd::Constant(1, -2.0), 1.0, MatrixXd::Identity(1, 1),
                             [](const VectorXd& velocity) {
                               const double end = 1.0 + velocity[0];
                               RowBuilder builder(1);
                               builder.add({0, 0}, end, VectorXd::Ones(1));
                               if (end < -0.5) {
                                 builder.add({1, 0}, end + 0.5, VectorXd::Ones(1));
                               }
                               return builder.rows();
                             });
  const ContactResult result = resolve_contact(step);
  BOOST_TEST(resolved(result));
  BOOST_TEST(std::abs(result.velocity[0] + 1.0) < 1e-12);
  BOOST_REQUIRE(result.keys.size() == 2u);
  BOOST_TEST(std::abs(result.multipliers[0] - 1.0) < 1e-12);
  BOOST_TEST(result.multipliers[1] == 0.0);
  BOOST_TEST(std::isinf(result.gaps[1]));
}

BOOST_AUTO_TEST_CASE(a_force_of_an_earlier_iteration_is_taken_back) {
  // The gap is convex: the force of the first linearisation is too large.
  ContactStep step = step_of(
      VectorXd::Constant(1, -1.0), 1.0, MatrixXd::Identity(1, 1), [](const VectorXd& velocity) {
        const double u = velocity[0];
        RowBuilder builder(1);
        builder.add({0, 0}, std::exp(u) - 0.5, VectorXd::Constant(1, std::exp(u)));
        return builder.rows();
      });
  step.tolerance = 1e-12;
  const ContactResult result = resolve_contact(step, {.open_gap = 1e-6});
  BOOST_TEST(resolved(result));
  BOOST_TEST(std::abs(result.velocity[0] - std::log(0.5)) < 1e-8);
  const ContactResult first = resolve_contact(step, {.max_iterations = 1});
  BOOST_TEST(first.multipliers[0] > result.multipliers[0] + 0.05);
  BOOST_TEST(result.kkt_residual < 1e-8);
}

BOOST_AUTO_TEST_CASE(a_linear_problem_without_solution_is_clipped) {
  // The first gap requires U <= 1. The second gap, linearised at U* = 2, requires U >= 2.61. Both
  // gaps are open at U = 0.
  ContactStep step = step_of(
      VectorXd::Constant(1, 2.0), 1.0, MatrixXd::Identity(1, 1), [](const VectorXd& velocity) {
        const double u = velocity[0];
        RowBuilder builder(1);
        builder.add({0, 0}, 1.0 - u, VectorXd::Constant(1, -1.0));
        builder.add({1, 0}, 0.1 - 3.0 * u + 1.2 * u * u, VectorXd::Constant(1, 2.4 * u - 3.0));
        return builder.rows();
      });
  const ContactResult result = resolve_contact(step);
  BOOST_TEST(resolved(result));
  BOOST_TEST(result.rays == 1);
  const double root = (3.0 - std::sqrt(9.0 - 0.48)) / 2.4;
  BOOST_TEST(std::abs(result.velocity[0] - root) < 1e-3);
  BOOST_TEST(result.multipliers[0] == 0.0);
}

BOOST_AUTO_TEST_CASE(known_motions_are_not_clipped) {
  // The first two gaps are those of the case above. The third one closes by 0.5 unless its own
  // velocity is at least 0.5: the loop must not take this for an error of the linearisation.
  ContactStep step =
      step_of(vector2(2.0, 0.0), 1.0, MatrixXd::Identity(2, 2), [](const VectorXd& velocity) {
        const double u = velocity[0];
        RowBuilder builder(2);
        builder.add({0, 0}, 1.0 - u, vector2(-1.0, 0.0));
        builder.add({1, 0}, 0.1 - 3.0 * u + 1.2 * u * u, vector2(2.4 * u - 3.0, 0.0));
        builder.add({2, 0}, velocity[1] - 0.5, vector2(0.0, 1.0));
        ContactRows rows = builder.rows();
        rows.at_rest = VectorXd{{0.0, 0.0, -0.5}};
        return rows;
      });
  const ContactResult first = resolve_contact(step, {.max_iterations = 1});
  BOOST_TEST(first.rays == 1);
  BOOST_TEST(std::abs(first.velocity[1] - 0.5) < 1e-12);
  BOOST_TEST(resolved(resolve_contact(step)));
}

BOOST_AUTO_TEST_CASE(points_that_take_turns_need_earlier_rows) {
  // The rod rests on both ends: the contact forces change the free velocity U* = (-1, 0.3) to
  // U = 0, and each end carries a part of the load.
  const ContactStep step = rod(vector2(-1.0, 0.3));
  const ContactResult result = resolve_contact(step);
  BOOST_TEST(resolved(result));
  BOOST_TEST(largest(result.velocity) < 1e-12);
  BOOST_TEST(result.iterations == 5);
  BOOST_TEST(result.keys.size() == 2u);
  BOOST_TEST(largest(result.multipliers - vector2(0.65, 0.35)) < 1e-12);
  BOOST_TEST(largest(result.force - vector2(1.0, -0.3)) < 1e-12);
  const ContactResult soon = resolve_contact(step, {.restore_rows_after = 0});
  BOOST_TEST(resolved(soon));
  BOOST_TEST(soon.iterations == 2);
  BOOST_TEST(largest(soon.velocity) < 1e-12);
}

BOOST_AUTO_TEST_CASE(all_earlier_rows_come_back_not_only_the_last) {
  const ContactResult result = resolve_contact(table(vector3(-1.0, 0.1, 0.05)));
  BOOST_TEST(resolved(result));
  BOOST_TEST(largest(result.velocity) < 1e-12);
  BOOST_TEST(result.keys.size() == 3u);
  BOOST_TEST(result.multipliers.minCoeff() > 0.1);
  BOOST_TEST(result.iterations <= 6);
}

BOOST_AUTO_TEST_CASE(rows_come_back_only_where_some_are_violated) {
  // The row that U* = -1 violates requires U >= 0.6. Then another point is the deepest point, and
  // Newton's method halves U in every iteration until U is close to 0. The gap stays open for more
  // than restore_rows_after iterations.
  ContactStep step = step_of(
      VectorXd::Constant(1, -1.0), 1.0, MatrixXd::Identity(1, 1), [](const VectorXd& velocity) {
        const double u = velocity[0];
        RowBuilder builder(1);
        if (u < 0.0) {
          builder.add({0, 0}, -0.5 + 0.3125 * (u + 1.0), VectorXd::Constant(1, 0.3125));
        } else {
          builder.add({0, 1}, u * (u + 1e-3), VectorXd::Constant(1, 2.0 * u + 1e-3));
        }
        return builder.rows();
      });
  step.tolerance = 1e-3;
  const ContactResult result = resolve_contact(step);
  BOOST_TEST(resolved(result), result.reason);
  BOOST_TEST(result.iterations > ContactLoopOptions{}.restore_rows_after);
  BOOST_TEST(result.kkt_residual <= step.tolerance);
}

BOOST_AUTO_TEST_CASE(crowds_are_resolved_by_the_step_or_by_halving_it) {
  int iterations = 0, steps = 0, halvings = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    // The disks form a 4 x 4 lattice and are almost in contact. The free velocity of every disk is
    // directed to the middle of the lattice, plus a random velocity.
    const Index n = 32;
    VectorXd centres(n);
    for (Index k = 0; k < 16; ++k) {
      centres.segment(2 * k, 2) = 1.03 * vector2(double(k % 4) - 1.5, double(k / 4) - 1.5);
    }
    const VectorXd free = -0.5 * centres + normal_matrix(n, 1, seed);
    const MatrixXd mobility = random_mobility(n, seed);
    double dt = 0.5;
    ContactResult result;
    for (;; dt *= 0.5, ++halvings) {
      result = resolve_contact(disks(centres, free, dt, mobility));
      BOOST_TEST(result.iterations <= 8);
      if (resolved(result)) break;
      BOOST_TEST(!result.reason.empty());
      BOOST_REQUIRE(dt > 1e-3);
    }
    iterations += result.iterations;
    ++steps;
    const VectorXd end = centres + dt * result.velocity;
    for (Index i = 0; i < n; i += 2) {
      for (Index j = i + 2; j < n; j += 2) {
        BOOST_TEST((end.segment(j, 2) - end.segment(i, 2)).norm() >= 1.0 - 1e-5);
      }
    }
    BOOST_TEST(result.kkt_residual <= 1e-3);
    double net_x = 0.0, net_y = 0.0;
    for (Index i = 0; i < n; i += 2) {
      net_x += result.force[i];
      net_y += result.force[i + 1];
    }
    BOOST_TEST(std::hypot(net_x, net_y) <= 1e-13 * (1.0 + largest(result.force)));
  }
  BOOST_TEST_MESSAGE("crowds: " << iterations << " iterations in " << steps << " steps, "
                                << halvings << " halvings");
  BOOST_TEST(iterations <= 6 * steps);
  BOOST_TEST(halvings <= 3 * steps);
}

BOOST_AUTO_TEST_CASE(units_change_nothing) {
  // The units are powers of two, so the results must agree in every bit.
  const double length = 8.0, time = 0.25, force = 128.0;
  const Index n = 8;
  const MatrixXd mobility = random_mobility(n, 3);
  const VectorXd free = normal_matrix(n, 1, 3);
  const ContactStep here = row_of_points(free, 1.0, mobility);
  ContactStep there = here;
  there.free_velocity *= length / time;
  there.dt *= time;
  there.separation *= length;
  there.tolerance *= length;
  there.rows = [=](const VectorXd& velocity) {
    ContactRows rows = here.rows(velocity * (time / length));
    rows.gap *= length;
    return rows;
  };
  there.respond = [=](const Eigen::SparseMatrix<double>& forces) -> MatrixXd {
    return length / time / force * mobility * forces;
  };
  const ContactResult a = resolve_contact(here), b = resolve_contact(there);
  BOOST_TEST(resolved(b));
  BOOST_TEST(a.iterations == b.iterations);
  BOOST_TEST((length / time * a.velocity == b.velocity));
  BOOST_TEST((force * a.multipliers == b.multipliers));
  BOOST_TEST(length * a.kkt_residual == b.kkt_residual);
}

}  // namespace stokesbook::test
