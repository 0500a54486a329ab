// Rows are what a solver needs: Newton's method in total multipliers, with a made-up mobility for
// bodies that do not feel each other, makes violated steps admissible within few iterations, with
// forces that balance and gaps closed where forces act.
#include <cmath>
#include <map>

#include <boost/test/unit_test.hpp>

#include "random_steps.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

// Solves 0 <= b + N z, z >= 0, complementary, by projected Gauss-Seidel.
Eigen::VectorXd solve(const Eigen::MatrixXd& n, const Eigen::VectorXd& b) {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(b.size());
  for (int sweep = 0; sweep < 20000; ++sweep) {
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

// A unit of force moves by 1, a unit of torque turns by 2; what encloses is held.
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

struct Resolved {
  int iterations = 0;
  bool is_admitted = false;
  double widest_loaded_gap = 0.0;
  Step step;
};

Resolved resolve(const Step& start, const ContactRules& rules) {
  const Eigen::VectorXd free = motion(start), b_diagonal = mobility(start);
  Eigen::VectorXd u = free;
  Resolved result;
  std::map<RowKey, double> loads;
  for (;; ++result.iterations) {
    const Step step = with_motion(start, u);
    const Interferences found = interferences(step, rules);
    result.is_admitted = found.admits_step();
    result.step = step;
    std::vector<ContactRow> rows;
    std::vector<ComponentPair> pairs;
    for (const Contact& contact : found.contacts) {
      for (const ContactRow& row : contact.rows) {
        rows.push_back(row);
        pairs.emplace_back(contact.a, contact.b);
        if (loads.contains(row.key)) {
          result.widest_loaded_gap = std::max(result.widest_loaded_gap, row.gap);
        }
      }
    }
    if (result.is_admitted || result.iterations == 12) return result;
    result.widest_loaded_gap = 0.0;
    loads.clear();
    const auto m = static_cast<Eigen::Index>(rows.size());
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(m, u.size());
    Eigen::VectorXd g(m);
    for (Eigen::Index i = 0; i < m; ++i) {
      const ContactRow& row = rows[static_cast<std::size_t>(i)];
      const auto [a, b] = pairs[static_cast<std::size_t>(i)];
      g[i] = row.gap;
      for (const auto& [k, wrench] : {std::pair{a, row.force.on_a}, {b, row.force.on_b}}) {
        j.row(i).segment<3>(3 * static_cast<Eigen::Index>(k)) << wrench.force.real(),
            wrench.force.imag(), wrench.torque;
      }
    }
    const Eigen::VectorXd load =
        solve(j * b_diagonal.asDiagonal() * j.transpose(), g + j * (free - u));
    for (Eigen::Index i = 0; i < m; ++i) {
      if (load[i] > 1e-9) loads[rows[static_cast<std::size_t>(i)].key] = load[i];
    }
    u = free + b_diagonal.asDiagonal() * (j.transpose() * load);
  }
}

constexpr double separation = 0.05, tolerance = 1e-3 * separation;

}  // namespace

BOOST_AUTO_TEST_CASE(crowds_come_apart) {
  int steps = 0, iterations = 0, most = 0, failed = 0;
  double widest = 0.0;
  for (double travel : {0.05, 0.1, 0.2}) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
      for (bool enclosed : {false, true}) {
        const Resolved resolved =
            resolve(random_step(12, seed, travel, enclosed), {{separation}, tolerance});
        ++steps;
        iterations += resolved.iterations;
        most = std::max(most, resolved.iterations);
        widest = std::max(widest, resolved.widest_loaded_gap);
        if (!resolved.is_admitted) ++failed;
      }
    }
  }
  BOOST_TEST_MESSAGE("steps " << steps << ", iterations " << iterations << ", most " << most
                              << ", failed " << failed << ", widest loaded gap " << widest);
  BOOST_TEST(failed == 0);
  BOOST_TEST(most <= 9);
  BOOST_TEST(iterations < 3 * steps);
  BOOST_TEST(widest < 0.1 * separation);
}
