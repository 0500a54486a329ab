// Computes the mean stress over a periodic cell from stresslets and loads, and integrates the
// tractions on the bodies to the mean pressure of the fluid and to the dissipation (chapter 14).
#include "suspension/solver/cell_rheology.hpp"

#include "closure/rigid_modes.hpp"
#include "stress/traction.hpp"
#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/cell.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::Matrix2d;

namespace {

// Returns the tensor with the components a_i b_j.
Matrix2d dyad(Complex a, Complex b) {
  return Matrix2d{{a.real() * b.real(), a.real() * b.imag()},
                  {a.imag() * b.real(), a.imag() * b.imag()}};
}

// Returns the symmetric tensor without trace that has the components 11 and 12 of s.
Matrix2d traceless(Complex s) {
  return Matrix2d{{s.real(), s.imag()}, {s.imag(), -s.real()}};
}

// The strain E_11 - E_22 + 2i E_12 of the undisturbed flow at an instant.
Complex strain_of(const Scene& scene, const Instant& instant) {
  return instant.forcing.flow * background_derivatives(scene.flow, 0.0).strain;
}

// A force F on the image of a body in the cell, and the force -F on some image of another body.
struct PairForce {
  Complex force;  // F
  Complex apart;  // c_a - c_b - w
  Complex shift;  // w, from the image of the other body in the cell to the one that bears -F
};

std::vector<PairForce> pair_forces(const SuspensionSolver& solver, const Instant& instant,
                                   const std::vector<ContactForce>& contacts) {
  std::vector<PairForce> pairs;
  const Configuration& images = instant.configuration;
  for (const auto& [gap, force] :
       repelled_pairs(solver.scene(), solver.discretisation(), instant)) {
    const auto& [a, b, points, shift] = gap;
    pairs.push_back({-force, images[a].position - images[b].position - shift, shift});
  }
  for (const ContactForce& contact : contacts) {
    const std::size_t a = contact.a.number, b = contact.b.number;
    pairs.push_back(
        {contact.force * contact.normal,
         instant.path_position(a) - instant.path_position(b) - contact.shift,
         contact.shift - instant.path_shifts[a].vector + instant.path_shifts[b].vector});
  }
  return pairs;
}

Matrix2d mean_stress(const Scene& scene, const Solution& solution, Complex stresslet,
                     const std::vector<PairForce>& pairs) {
  const Instant& instant = solution.instant;
  const double cell_area = instant.cell->area();
  Matrix2d sum = traceless(scene.viscosity * cell_area * strain_of(scene, instant) + stresslet);
  for (std::size_t k = 0; k < solution.loads.size(); ++k) {
    const Complex arm = instant.configuration[k].position - cell_centre(scene);
    const double turn = 0.5 * solution.loads[k].torque;
    sum += Matrix2d{{0.0, turn}, {-turn, 0.0}} - dyad(solution.loads[k].force, arm);
  }
  // The force -F of a pair acts at c_b + w, which adds F (x) w.
  for (const auto& [force, apart, shift] : pairs) sum += dyad(force, shift);
  return sum / cell_area;
}

// Returns the symmetric part of -1/V sum F (x) (c_a - c_b - w). In mean_stress(), the torques of
// the pairs balance the other part.
Matrix2d pair_stress(const std::vector<PairForce>& pairs, double cell_area) {
  Matrix2d sum = Matrix2d::Zero();
  for (const auto& [force, apart, shift] : pairs) sum -= dyad(force, apart);
  return 0.5 / cell_area * (sum + sum.transpose());
}

// Returns the velocity of a component at its nodes, that of its image in the cell.
ComplexVector surface_velocity(const Component& component, const RigidMotion& motion) {
  if (component.kind != ComponentKind::free_body) return component.velocity;
  const ComplexVector rigid = RigidModes(component.curve, component.centre).at_nodes(motion);
  return has_slip(component) ? ComplexVector(rigid + component.velocity) : rigid;
}

}  // namespace

CellRheology cell_rheology(const SuspensionSolver& solver, const Solution& solution,
                           Complex stresslet, const std::vector<ContactForce>& contacts) {
  const Scene& scene = solver.scene();
  const Instant& instant = solution.instant;
  const Complex strain = strain_of(scene, instant);
  const SolvedFlow disturbance = solver.disturbance(solution);
  const StokesProblem& problem = disturbance.problem();
  const ComplexVector nodes = disturbance.nodes();
  const ComplexVector undisturbed =
      (instant.forcing.flow * background_velocity(undisturbed_flow(scene), nodes)).array() +
      solution.uniform_velocity;
  Complex force{};
  for (const Load& load : solution.loads) force += load.force;
  const double mu = scene.viscosity;
  // From the pressure that is linear about the origin to that about the centre of the cell.
  const double datum = dot(force, cell_centre(scene)) / (instant.cell->area() * mu);
  std::vector<FlowDerivatives> at_nodes = disturbance.derivatives(nodes);
  for (FlowDerivatives& at : at_nodes) at += {-datum, 0.0, strain};
  const ComplexVector traction = boundary_traction(problem, at_nodes);
  double power = 0.0, moment = 0.0, fluid_area = instant.cell->area();
  Index first = 0;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    const Curve& curve = component.curve;
    const ComplexVector velocity = surface_velocity(component, solution.motions[k]);
    const ComplexVector normal = normals(curve);
    const Eigen::VectorXd weight = weights(curve);
    for (Index j = 0; j < curve.size(); ++j, ++first) {
      const Complex t = traction[first];
      // (u - u_inf) . t + 2 mu E : (u n)
      power += weight[j] * (dot(velocity[j] - undisturbed[first], t) +
                            mu * dot(strain, velocity[j] * normal[j]));
      moment += weight[j] * dot(curve.x[j] - component.centre, t);
    }
    fluid_area -= area(curve);
  }
  const std::vector<PairForce> pairs = pair_forces(solver, instant, contacts);
  CellRheology result{mean_stress(scene, solution, stresslet, pairs),
                      pair_stress(pairs, instant.cell->area()), Rheology::undefined,
                      Rheology::undefined, power};
  const Matrix2d& stress = result.stress;
  const Complex deviator{0.5 * (stress(0, 0) - stress(1, 1)), 0.5 * (stress(0, 1) + stress(1, 0))};
  if (strain != 0.0) result.viscosity = dot(deviator, strain) / std::norm(strain);
  result.particle_pressure = 0.5 * (moment / fluid_area - stress.trace());
  return result;
}

}  // namespace stokesbook
