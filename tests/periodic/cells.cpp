// Solves the completed double-layer equation of rigid bodies in a periodic cell.
#include "cells.hpp"

#include <numbers>

#include <boost/test/unit_test.hpp>

#include "double_layer/double_layer.hpp"
#include "krylov/gmres.hpp"
#include "periodic/far_operator.hpp"
#include "stress/stresslet.hpp"

namespace stokesbook::test {

using Eigen::Index;
using std::numbers::pi;

namespace {

class CellSystem {
 public:
  CellSystem(const Cell& cell, const FmmSettings& settings)
      : cell_(cell), centres_(std::ssize(cell.bodies)), held_(0.0) {
    for (std::size_t k = 0; k < cell.bodies.size(); ++k) {
      const CellBody& body = cell.bodies[k];
      curves_.push_back(body.curve);
      modes_.emplace_back(body.curve, body.centre);
      first_.push_back(n_);
      n_ += body.curve.size();
      centres_[static_cast<Index>(k)] = body.centre;
      if (body.held) ++held_;
    }
    fmm_.emplace(curves_, centres_, settings, images_in(cell.lattice));
  }

  const std::vector<Curve>& curves() const { return curves_; }
  const ComplexVector& centres() const { return centres_; }
  Index size() const { return n_; }

  ComplexVector part(const ComplexVector& density, std::size_t k) const {
    return density.segment(first_[k], curves_[k].size());
  }
  RigidMotion project(const ComplexVector& density, std::size_t k) const {
    return modes_[k].project(part(density, k));
  }
  ComplexVector without_rigid_part(ComplexVector density) const {
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      density.segment(first_[k], curves_[k].size()) -= modes_[k].at_nodes(project(density, k));
    }
    return density;
  }

  // Returns the mean U of the rigid parts of held bodies if the pressure gradient is given.
  Complex mean_held(const ComplexVector& density) const {
    Complex sum;
    if (!cell_.pressure_gradient) return sum;
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      if (cell_.bodies[k].held) sum += project(density, k).velocity / held_;
    }
    return sum;
  }

  // Returns forces and torques of a density, and, if wanted, those that are given, over mu.
  std::pair<ComplexVector, Eigen::VectorXd> loads(const ComplexVector& density, bool given) const {
    ComplexVector force = ComplexVector::Zero(centres_.size());
    Eigen::VectorXd torque = Eigen::VectorXd::Zero(centres_.size());
    Complex share;
    if (cell_.pressure_gradient) {
      share = cell_.lattice.area() * *cell_.pressure_gradient;
      for (const CellBody& body : cell_.bodies) share -= body.held ? 0.0 : body.force;
      share /= held_;
    }
    const Complex mean = mean_held(density);
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      const auto i = static_cast<Index>(k);
      const CellBody& body = cell_.bodies[k];
      if (body.held) {
        const RigidMotion rigid = project(density, k);
        const double radius = modes_[k].gyration_radius();
        force[i] = -4.0 * pi * (rigid.velocity - mean);
        torque[i] = -4.0 * pi * radius * radius * rigid.omega;
        if (given) force[i] += share / cell_.viscosity;
      } else if (given) {
        force[i] = body.force / cell_.viscosity;
        torque[i] = body.torque / cell_.viscosity;
      }
    }
    return {force, torque};
  }

  ComplexVector operator()(const ComplexVector& density) const {
    const ComplexVector rest = without_rigid_part(density);
    const auto [force, torque] = loads(density, false);
    ComplexVector velocity =
        fmm_->velocity({rest, force, torque}).col(0).array() - mean_held(density);
    velocity -= 0.5 * rest;
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      auto own = velocity.segment(first_[k], curves_[k].size());
      own += diagonal_velocity(curves_[k], part(rest, k));
      if (!cell_.bodies[k].held) own -= modes_[k].at_nodes(project(density, k));
    }
    return velocity;
  }

  ComplexVector right_hand_side() const {
    const ComplexVector zero = ComplexVector::Zero(n_);
    const auto [force, torque] = loads(zero, true);
    ComplexVector velocity = -fmm_->velocity({zero, force, torque}).col(0);
    if (!cell_.pressure_gradient) velocity.array() -= cell_.mean_velocity;
    for (std::size_t k = 0; k < curves_.size(); ++k) {
      auto own = velocity.segment(first_[k], curves_[k].size());
      for (Index i = 0; i < own.size(); ++i) own[i] -= cell_.linear_velocity(curves_[k].x[i]);
      if (cell_.bodies[k].held) own += modes_[k].at_nodes(*cell_.bodies[k].held);
    }
    return velocity;
  }

 private:
  const Cell& cell_;
  std::vector<Curve> curves_;
  std::vector<RigidModes> modes_;
  std::vector<Index> first_;
  ComplexVector centres_;
  Index n_ = 0;
  double held_;
  std::optional<Fmm> fmm_;
};

}  // namespace

CellSolution solve(const Cell& cell, const FmmSettings& settings, const ComplexVector& targets) {
  const CellSystem system(cell, settings);
  const LinearMap apply = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const ComplexVector velocity = system(deinterleaved(v));
    return interleaved(velocity);
  };
  const ComplexVector rhs = system.right_hand_side();
  const GmresResult result = gmres(apply, {}, interleaved(rhs), {1e-14, 200});
  BOOST_TEST(result.residual < 1e-12);
  const ComplexVector density = deinterleaved(result.solution);
  const auto [force, torque] = system.loads(density, true);
  CellSolution solution;
  solution.iterations = result.iterations;
  solution.mean_velocity = cell.pressure_gradient ? -system.mean_held(density) : cell.mean_velocity;
  const ComplexVector rest = system.without_rigid_part(density);
  for (std::size_t k = 0; k < cell.bodies.size(); ++k) {
    const CellBody& body = cell.bodies[k];
    const RigidMotion motion = body.held ? *body.held : system.project(density, k);
    const auto i = static_cast<Index>(k);
    solution.bodies.push_back({motion.velocity, motion.omega, cell.viscosity * force[i],
                               cell.viscosity * torque[i],
                               body_stresslet(body.curve, system.part(rest, k), cell.viscosity)});
  }
  if (targets.size() > 0) {
    solution.velocity =
        Fmm(system.curves(), system.centres(), targets, settings, images_in(cell.lattice))
            .velocity({rest, force, torque});
    for (Index i = 0; i < targets.size(); ++i) {
      solution.velocity[i] += solution.mean_velocity + cell.linear_velocity(targets[i]);
    }
  }
  return solution;
}

}  // namespace stokesbook::test
