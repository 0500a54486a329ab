// Applies the reduced closure (03.10): motions and loads are functionals of the density, and their
// rigid velocities, Stokeslets and rotlets complete the double layer. If a uniform velocity is
// free, the forces balance by construction (03.14).
#include "closure/closure.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "double_layer/kernels.hpp"
#include "trapezoid/require.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

bool is_prescribed(const Component& component) {
  return component.kind == ComponentKind::prescribed;
}

}  // namespace

Completion with_balance(const StokesProblem& problem, Completion completion) {
  std::vector<Load>& loads = completion.loads;
  for (std::size_t wall = 0; wall < loads.size(); ++wall) {
    if (is_inner(problem.components[wall])) continue;
    loads[wall] = {};
    for (std::size_t k = 0; k < loads.size(); ++k) {
      if (k == wall) continue;
      // F_0 = -sum_k F_k and L_0 = -sum_k [L_k + (c_k - c_0) cross F_k] (chapter 04).
      const Complex arm = problem.components[k].centre - problem.components[wall].centre;
      loads[wall].force -= loads[k].force;
      loads[wall].torque -= loads[k].torque + cross(arm, loads[k].force);
    }
  }
  return completion;
}

std::vector<double> stokeslet_gauges(const StokesProblem& problem) {
  const std::vector<Component>& components = problem.components;
  if (problem.cell) return std::vector<double>(components.size(), 1.0);
  if (!is_bounded(problem) && problem.gauge_length) {
    return std::vector<double>(components.size(), *problem.gauge_length);
  }
  std::vector<double> gauges;
  std::optional<double> shared;  // gauge of all free bodies
  for (const Component& component : components) {
    const RigidModes modes(component.curve, component.centre);
    const double own = std::sqrt(std::numbers::e) * modes.gyration_radius();
    const bool free = component.kind == ComponentKind::free_body;
    if (free && !shared) shared = own;
    gauges.push_back(free ? *shared : own);
  }
  return gauges;
}

Closure::Closure(const StokesProblem& problem)
    : problem_(problem),
      offsets_(node_offsets(problem)),
      gauges_(stokeslet_gauges(problem)),
      nodes_(all_nodes(curves_of(problem))),
      prescribed_count_(std::ranges::count_if(problem.components, is_prescribed)),
      free_uniform_velocity_(has_free_uniform_velocity(problem)) {
  for (const Component& component : problem.components) {
    modes_.emplace_back();
    if (is_inner(component)) modes_.back().emplace(component.curve, component.centre);
  }
  require(!problem.cell || (!is_bounded(problem) && !problem.gauge_length),
          "a periodic cell has neither an enclosing wall nor a gauge length");
  require(
      !problem.cell || !problem.cell->pressure_gradient || prescribed_count_ > 0,
      "the mean gradient of the pressure in a periodic cell is the total force over the area; it "
      "can be given only if a component has a prescribed velocity");
  const Complex force = total_given_force(problem);
  require(problem.cell || is_bounded(problem) || problem.gauge_length || prescribed_count_ > 0 ||
              !has_net_force(problem),
          "the forces in an unbounded fluid add up to (", force.real(), ", ", force.imag(),
          "), not zero: give a gauge length or balance the forces");
}

std::vector<RigidMotion> Closure::rigid_parts(const ComplexVector& density) const {
  std::vector<RigidMotion> rigid(modes_.size());
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    if (modes_[k]) {
      rigid[k] = modes_[k]->project(density.segment(offsets_[k], offsets_[k + 1] - offsets_[k]));
    }
  }
  return rigid;
}

ComplexVector Closure::without_rigid_part(const ComplexVector& density) const {
  const std::vector<RigidMotion> rigid = rigid_parts(density);
  ComplexVector complement = density;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    if (modes_[k]) {
      complement.segment(offsets_[k], offsets_[k + 1] - offsets_[k]) -=
          modes_[k]->at_nodes(rigid[k]);
    }
  }
  return complement;
}

// Returns the mean of U_w over the prescribed components w.
Complex Closure::mean_prescribed(const std::vector<RigidMotion>& rigid) const {
  Complex mean{};
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    if (is_prescribed(problem_.components[k])) mean += rigid[k].velocity;
  }
  return mean / static_cast<double>(prescribed_count_);
}

// F_w = -4 pi mu U_w and L_w = -4 pi mu a_w^2 omega_w on prescribed components; where a uniform
// velocity is free, F_w = -4 pi mu (U_w - mean) - sum_p F_p / n_w (03.14), plus V P / n_w in a
// periodic cell. The given loads of free bodies p are left out if `with_data` is false.
std::vector<Load> Closure::inner_loads(const std::vector<RigidMotion>& rigid,
                                       bool with_data) const {
  const double scale = -4.0 * std::numbers::pi * problem_.viscosity;
  Complex mean{}, share{};
  if (free_uniform_velocity_) {
    mean = mean_prescribed(rigid);
    Complex force = total_given_force(problem_);
    if (problem_.cell) force -= problem_.cell->area() * *problem_.cell->pressure_gradient;
    share = force / static_cast<double>(prescribed_count_);
  }
  std::vector<Load> loads(rigid.size());
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    const Component& component = problem_.components[k];
    if (component.kind == ComponentKind::free_body && with_data) {
      loads[k] = {component.force, component.torque};
    }
    if (!is_prescribed(component)) continue;
    const double radius = modes_[k]->gyration_radius();
    loads[k] = {scale * (rigid[k].velocity - mean), scale * radius * radius * rigid[k].omega};
    if (with_data) loads[k].force -= share;
  }
  return loads;
}

// sum_k F_k log(ell_k) / (4 pi mu).
Complex Closure::gauge_velocity(const std::vector<Load>& loads) const {
  Complex velocity{};
  if (!free_uniform_velocity_) return velocity;
  for (std::size_t k = 0; k < loads.size(); ++k) {
    velocity += std::log(gauges_[k]) * loads[k].force;
  }
  return velocity / (4.0 * std::numbers::pi * problem_.viscosity);
}

// sum_k (S_k F_k + R_k L_k) (03.4).
ComplexVector Closure::singular_velocity(const std::vector<Load>& loads,
                                         const ComplexVector& targets) const {
  require(!problem_.cell, "a direct sum has no images of a periodic cell");
  ComplexVector velocity = ComplexVector::Zero(targets.size());
  for (std::size_t k = 0; k < loads.size(); ++k) {
    const Load& load = loads[k];
    if (!modes_[k] || (load.force == Complex{} && load.torque == 0.0)) continue;
    const Complex centre = problem_.components[k].centre;
    for (Index i = 0; i < targets.size(); ++i) {
      const Complex r = targets[i] - centre;
      velocity[i] += stokeslet(r, load.force, problem_.viscosity, gauges_[k]) +
                     rotlet(r, load.torque, problem_.viscosity);
    }
  }
  return velocity;
}

std::vector<Load> Closure::density_loads(const ComplexVector& density) const {
  return inner_loads(rigid_parts(density), false);
}

// -P eta on free bodies, and u_c = -mean of U_w at all nodes.
ComplexVector Closure::smooth_velocity(const ComplexVector& density) const {
  const std::vector<RigidMotion> rigid = rigid_parts(density);
  ComplexVector velocity = ComplexVector::Zero(density.size());
  if (free_uniform_velocity_) velocity.array() -= mean_prescribed(rigid);
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    if (problem_.components[k].kind == ComponentKind::free_body) {
      velocity.segment(offsets_[k], offsets_[k + 1] - offsets_[k]) -= modes_[k]->at_nodes(rigid[k]);
    }
  }
  return velocity;
}

ComplexVector Closure::velocity(const ComplexVector& density) const {
  return smooth_velocity(density) + singular_velocity(density_loads(density), nodes_);
}

std::vector<Load> Closure::given_loads() const {
  return inner_loads(std::vector<RigidMotion>(modes_.size()), true);
}

ComplexVector Closure::boundary_data() const {
  ComplexVector data = ComplexVector::Zero(nodes_.size());
  if (problem_.background.size() > 0) data -= problem_.background;
  for (std::size_t k = 0; k < modes_.size(); ++k) {
    const Component& component = problem_.components[k];
    if (component.velocity.size() > 0) {
      data.segment(offsets_[k], component.curve.size()) += component.velocity;
    }
  }
  return data;
}

ComplexVector Closure::right_hand_side() const {
  return boundary_data() - singular_velocity(given_loads(), nodes_);
}

Completion Closure::complete(const ComplexVector& density) const {
  const std::vector<RigidMotion> rigid = rigid_parts(density);
  Completion result;
  result.loads = inner_loads(rigid, true);
  result.motions.resize(rigid.size());
  for (std::size_t k = 0; k < rigid.size(); ++k) {
    if (problem_.components[k].kind == ComponentKind::free_body) result.motions[k] = rigid[k];
  }
  if (free_uniform_velocity_) {
    result.uniform_velocity = gauge_velocity(result.loads) - mean_prescribed(rigid);
  }
  return with_balance(problem_, std::move(result));
}

Complex Closure::uniform_velocity(const Completion& completion) const {
  return completion.uniform_velocity - gauge_velocity(completion.loads);
}

ComplexVector Closure::singular_velocity(const Completion& completion,
                                         const ComplexVector& targets) const {
  return singular_velocity(completion.loads, targets).array() + uniform_velocity(completion);
}

}  // namespace stokesbook
