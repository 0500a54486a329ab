#pragma once

#include <utility>

#include "lcp/contact_loop.hpp"
#include "support/lcp_solvers.hpp"

namespace stokesbook::test {

/// Collects constraint rows one by one.
class RowBuilder {
 public:
  explicit RowBuilder(Index unknowns) : unknowns_{unknowns} {}

  void add(ContactKey key, double gap, const VectorXd& gradient) {
    keys_.push_back(key);
    gaps_.push_back(gap);
    gradients_.push_back(gradient);
  }

  ContactRows rows() const {
    const auto m = static_cast<Index>(keys_.size());
    MatrixXd gradient(m, unknowns_);
    for (Index i = 0; i < m; ++i) gradient.row(i) = gradients_[static_cast<std::size_t>(i)];
    return {VectorXd::Map(gaps_.data(), m), gradient.sparseView(), {}, keys_};
  }

 private:
  Index unknowns_;
  std::vector<ContactKey> keys_;
  std::vector<double> gaps_;
  std::vector<VectorXd> gradients_;
};

/// Returns a step with the mobility B and the separation 0.01. The tolerance of the step is a
/// thousandth of the separation.
inline ContactStep step_of(const VectorXd& free_velocity, double dt, const MatrixXd& mobility,
                           std::function<ContactRows(const VectorXd&)> rows) {
  ContactStep step{free_velocity, dt, 0.01, 1e-5, std::move(rows), {}};
  step.respond = [mobility](const Eigen::SparseMatrix<double>& forces) -> MatrixXd {
    return mobility * forces;
  };
  return step;
}

/// Returns the step of a point that starts at `start` and must end at a distance of at least 1 from
/// the origin. The mobility B is the identity.
inline ContactStep point_and_disk(const VectorXd& start, const VectorXd& free_velocity, double dt) {
  return step_of(free_velocity, dt, MatrixXd::Identity(2, 2), [=](const VectorXd& velocity) {
    const VectorXd end = start + dt * velocity;
    RowBuilder builder(2);
    builder.add({1, 1}, end.norm() - 1.0, end.normalized());
    return builder.rows();
  });
}

/// Returns the step of points on a line, at 0, 1, 2, ..., which must keep a distance of 0.9. Every
/// pair of points has a constraint row, so there are far more rows than unknowns.
inline ContactStep row_of_points(const VectorXd& free_velocity, double dt,
                                 const MatrixXd& mobility) {
  return step_of(free_velocity, dt, mobility, [=](const VectorXd& velocity) {
    const Index n = velocity.size();
    RowBuilder builder(n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = i + 1; j < n; ++j) {
        const double gap = 0.1 * static_cast<double>(j - i) + dt * (velocity[j] - velocity[i]);
        builder.add({i * n + j, 0}, gap, VectorXd::Unit(n, j) - VectorXd::Unit(n, i));
      }
    }
    return builder.rows();
  });
}

/// Returns the step of a rod above a floor. The unknowns are the upward velocity and the angular
/// velocity of the rod. Both ends are at height 0, and only the deeper end has a constraint row.
inline ContactStep rod(const VectorXd& free_velocity) {
  return step_of(free_velocity, 1.0, MatrixXd::Identity(2, 2), [](const VectorXd& velocity) {
    const VectorXd left = vector2(1.0, -1.0), right = vector2(1.0, 1.0);
    const bool is_left = left.dot(velocity) < right.dot(velocity);
    const VectorXd& deeper = is_left ? left : right;
    RowBuilder builder(2);
    builder.add({0, is_left ? 0 : 1}, deeper.dot(velocity), deeper);
    return builder.rows();
  });
}

/// Returns the step of a table above a floor. The unknowns are the upward velocity and the two
/// angular velocities of the table. Only the deepest of the three feet has a constraint row.
inline ContactStep table(const VectorXd& free_velocity) {
  return step_of(free_velocity, 1.0, MatrixXd::Identity(3, 3), [](const VectorXd& velocity) {
    MatrixXd feet(3, 3);
    feet << 1.0, 1.0, 0.0, 1.0, -0.5, 0.75, 1.0, -0.5, -0.75;
    Index deepest = 0;
    const double gap = (feet * velocity).minCoeff(&deepest);
    RowBuilder builder(3);
    builder.add({0, deepest}, gap, feet.row(deepest));
    return builder.rows();
  });
}

/// Returns the step of disks of radius 1/2 in the plane, with their centres at `centres` (x_0, y_0,
/// x_1, ...). Each pair whose gap at the end of the step is at most 1/4 has a constraint row.
inline ContactStep disks(const VectorXd& centres, const VectorXd& free_velocity, double dt,
                         const MatrixXd& mobility) {
  return step_of(free_velocity, dt, mobility, [=](const VectorXd& velocity) {
    const VectorXd end = centres + dt * velocity;
    const Index n = end.size();
    RowBuilder builder(n);
    for (Index i = 0; i < n; i += 2) {
      for (Index j = i + 2; j < n; j += 2) {
        const VectorXd apart = end.segment(j, 2) - end.segment(i, 2);
        if (apart.norm() > 1.25) continue;
        VectorXd gradient = VectorXd::Zero(n);
        gradient.segment(j, 2) = apart.normalized();
        gradient.segment(i, 2) = -apart.normalized();
        builder.add({i * n + j, 0}, apart.norm() - 1.0, gradient);
      }
    }
    return builder.rows();
  });
}

inline bool resolved(const ContactResult& result) {
  return result.status == ContactStatus::resolved;
}

}  // namespace stokesbook::test
