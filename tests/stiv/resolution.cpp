// Checks that rows suffice for a solver: Newton's method in total multipliers, with an invented
// mobility for bodies without hydrodynamic interaction, makes violated steps admissible within few
// iterations. The forces balance, and the gaps with forces are closed.
#include <cmath>
#include <map>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(resolution)

namespace {

// Solves the complementarity problem of b + N z >= 0 and z >= 0 by projected Gauss-Seidel.
Eigen::VectorXd solve(const Eigen::MatrixXd& n, const Eigen::VectorXd& b) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(b.size());
  for (int sweep = 0; sweep < 3000; ++sweep) {
    double change = 0.0;
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      const double next = std::max(0.0, z[i] - (b[i] + n.row(i).dot(z)) / n(i, i));
      change = std::max(change, std::abs(next - z[i]));
      z[i] = next;
    }
    if (change < 1e-13) break;
  }
  return z;
}

// A unit force moves a body by 1, and a unit torque turns it by 2; enclosing walls are held.
Eigen::VectorXd mobility(const Step& step) {
  Eigen::VectorXd diagonal(3 * static_cast<Eigen::Index>(step.shapes.size()));
  for (std::size_t k = 0; k < step.shapes.size(); ++k) {
    const bool is_held = step.shapes[k]->polygon.side() == Side::fluid_inside;
    diagonal.segment<3>(3 * static_cast<Eigen::Index>(k)) =
        is_held ? Eigen::Vector3d::Zero().eval() : Eigen::Vector3d{1.0, 1.0, 2.0};
  }
  return diagonal;
}

Eigen::VectorXd motion(const Step& step) {
  Eigen::VectorXd u(3 * static_cast<Eigen::Index>(step.paths.size()));
  for (std::size_t k = 0; k < step.paths.size(); ++k) {
    const RigidPath& path = step.paths[k];
    u.segment<3>(3 * static_cast<Eigen::Index>(k)) << path.displacement.real(),
        path.displacement.imag(), path.rotation;
  }
  return u;
}

Step with_motion(Step step, const Eigen::VectorXd& u) {
  for (std::size_t k = 0; k < step.paths.size(); ++k) {
    const auto own = u.segment<3>(3 * static_cast<Eigen::Index>(k));
    step.paths[k].displacement = {own[0], own[1]};
    step.paths[k].rotation = own[2];
  }
  return step;
}

void put(Eigen::RowVectorXd& row, std::size_t component, const Wrench& wrench) {
  row.segment<3>(3 * static_cast<Eigen::Index>(component)) << wrench.force.real(),
      wrench.force.imag(), wrench.torque;
}

// Holds a row as a constraint on the motion: 0 <= bound + derivative u.
struct Constraint {
  Eigen::RowVectorXd derivative, force;
  double gap, bound;
  int iteration;
};

Constraint constraint(const Contact& contact, const ContactRow& row, const Eigen::VectorXd& u,
                      int iteration) {
  const Eigen::RowVectorXd zero = Eigen::RowVectorXd::Zero(u.size());
  Constraint result{zero, zero, row.gap, 0.0, iteration};
  put(result.derivative, contact.a, row.derivative.on_a);
  put(result.derivative, contact.b, row.derivative.on_b);
  put(result.force, contact.a, row.force.on_a);
  put(result.force, contact.b, row.force.on_b);
  result.bound = row.gap - result.derivative.dot(u);
  return result;
}

struct Resolved {
  int iterations = 0;
  bool is_admitted = false;
};

// Violated rows stay for two more iterations, because the deepest vertex of a flat contact changes.
Resolved resolve(const Step& start, const ContactRules& rules) {
  const Eigen::VectorXd free = motion(start), b_diagonal = mobility(start);
  Eigen::VectorXd u = free;
  std::map<RowKey, Constraint> constraints;
  std::map<RowKey, double> loads;
  Resolved result;
  for (;; ++result.iterations) {
    const Interferences found = interferences(with_motion(start, u), rules);
    double widest_loaded = 0.0;
    std::erase_if(constraints, [&](const auto& entry) {
      return entry.second.gap >= 0.0 || entry.second.iteration + 2 < result.iterations;
    });
    for (const Contact& contact : found.contacts) {
      for (const ContactRow& row : contact.rows) {
        if (loads[row.key] > 1e-9) widest_loaded = std::max(widest_loaded, row.gap);
        constraints[row.key] = constraint(contact, row, u, result.iterations);
      }
    }
    result.is_admitted = found.admits_step() && widest_loaded < 0.1 * rules.separation.everywhere;
    if (result.is_admitted || result.iterations == 12) return result;
    const auto m = static_cast<Eigen::Index>(constraints.size());
    Eigen::MatrixXd derivative(m, u.size()), force(m, u.size());
    Eigen::VectorXd bound(m);
    Eigen::Index i = 0;
    for (const auto& [key, row] : constraints) {
      derivative.row(i) = row.derivative;
      force.row(i) = row.force;
      bound[i++] = row.bound;
    }
    const Eigen::VectorXd load =
        solve(derivative * b_diagonal.asDiagonal() * force.transpose(), bound + derivative * free);
    loads.clear();
    i = 0;
    for (const auto& [key, row] : constraints) loads[key] = load[i++];
    u = free + b_diagonal.asDiagonal() * (force.transpose() * load);
  }
}

constexpr double separation = 0.05, tolerance = 1e-3 * separation;

}  // namespace

// The steps are up to ten separations and half a radian long.
BOOST_AUTO_TEST_CASE(crowds_come_apart) {
  int steps = 0, iterations = 0, most = 0, failed = 0;
  for (double travel : {0.1, 0.2, 0.5}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      for (bool enclosed : {false, true}) {
        const Resolved resolved =
            resolve(random_step(12, seed, travel, enclosed), {{separation}, tolerance});
        ++steps;
        iterations += resolved.iterations;
        most = std::max(most, resolved.iterations);
        if (!resolved.is_admitted) ++failed;
      }
    }
  }
  BOOST_TEST_MESSAGE("steps " << steps << ", iterations " << iterations << ", most " << most
                              << ", failed " << failed);
  BOOST_TEST(failed == 0);
  BOOST_TEST(most <= 6);
  BOOST_TEST(iterations < 2 * steps);
  BOOST_TEST(iterations > steps / 2);
}

BOOST_AUTO_TEST_SUITE_END()
