// Estimates the error of a solution by a correction on finer nodes: interpolates the density,
// solves for the correction of its residual, and compares motions and loads before and after. If
// the error is too large, the tails of the densities show which components to refine (chapter 12,
// section "System").
#include "suspension/system/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "double_layer/double_layer.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Interpolates a density, component by component, from the nodes of one system to the nodes of
// another.
ComplexVector transferred(const ComplexVector& density, const LinearSystem& from,
                          const LinearSystem& to) {
  const std::vector<Index>& source = from.system.offsets();
  const std::vector<Index>& target = to.system.offsets();
  ComplexVector result(target.back());
  for (std::size_t k = 0; k + 1 < source.size(); ++k) {
    const Index n = target[k + 1] - target[k];
    result.segment(target[k], n) =
        resample(density.segment(source[k], source[k + 1] - source[k]), n);
  }
  return result;
}

// Returns a preconditioner for the fine system. Modes that the coarse nodes resolve pass through
// the preconditioner of the coarse system. Higher modes are multiplied by -2, since the operator
// acts on them nearly as its jump -1/2.
LinearMap refined_preconditioner(const LinearSystem& coarse, const LinearSystem& fine) {
  if (!coarse.precondition) return {};
  return [&](const Eigen::VectorXd& v) {
    const ComplexVector all = deinterleaved(v), low = transferred(all, fine, coarse);
    ComplexVector both = 2.0 * (transferred(low, coarse, fine) - all);
    both += transferred(deinterleaved(coarse.precondition(interleaved(low))), coarse, fine);
    return Eigen::VectorXd(interleaved(both));
  };
}

// Returns the tolerance for the correction, relative to the norm of its right-hand side r. The
// solution has a residual r_0. In an ill-conditioned system r_0 lies in the softest modes, where it
// causes the largest errors: the correction leaves a tenth of it. A tree of groups removes these
// modes as well as all others: a correction that leaves as much as r_0 shows the error of the
// nodes.
double correction_tolerance(double r_0, double r, PreconditionerKind kind) {
  const double share = kind == PreconditionerKind::hierarchical ? 1.0 : 0.1;
  return std::clamp(share * r_0 / r, 1e-8, 0.03);
}

// Solves a system, and counts all products. GMRES starts anew before its bases exceed some 130 MB
// each.
GmresResult solve_in_parts(const LinearSystem& system, const ComplexVector& rhs, double tolerance) {
  constexpr Index most_numbers = 1 << 24;
  const Index size = 2 * rhs.size();
  Index longest = std::max<Index>(8, most_numbers / size);
  GmresResult result;
  result.residual = 1.0;
  do {
    const GmresResult before = std::move(result);
    result = solve(system, rhs, {tolerance, static_cast<int>(std::min(longest, size))},
                   deinterleaved(before.solution));
    result.applications += before.applications;
    if (result.residual > 0.5 * before.residual) longest *= 2;
  } while (!result.converged && longest < 2 * size);
  return result;
}

}  // namespace

std::optional<double> relative_change(const StokesProblem& problem, const Completion& p,
                                      const Completion& q, double scale) {
  double load_scale = scale;
  double motions = 0.0, loads = 0.0;
  bool any = false;
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    const Component& component = problem.components[k];
    if (component.kind == ComponentKind::enclosing_wall) continue;
    any = true;
    // |U - U'| and a |omega - omega'|; |F - F'| / (4 pi mu) and |L - L'| / (4 pi mu a).
    const double a = RigidModes(component.curve, component.centre).gyration_radius();
    const RigidMotion &m = p.motions[k], &n = q.motions[k];
    motions =
        std::max({motions, std::abs(m.velocity - n.velocity), a * std::abs(m.omega - n.omega)});
    if (component.kind == ComponentKind::free_body) continue;
    const double unit = 4.0 * std::numbers::pi * problem.viscosity;
    const Load &f = p.loads[k], &g = q.loads[k];
    load_scale = std::max({load_scale, std::abs(f.force) / unit, std::abs(f.torque) / (unit * a)});
    loads = std::max(
        {loads, std::abs(f.force - g.force) / unit, std::abs(f.torque - g.torque) / (unit * a)});
  }
  if (!any) return {};
  // |u_c - u_c'|: the mean velocity may be the only result that is not given.
  if (problem.cell) {
    motions = std::max(motions, std::abs(p.uniform_velocity - q.uniform_velocity));
  }
  return std::max(motions / scale, loads / load_scale);
}

ErrorEstimate estimate_error(const LinearSystem& coarse, const ComplexVector& density,
                             double residual, LinearSystem fine, double scale) {
  fine.precondition = refined_preconditioner(coarse, fine);
  // r = b - A eta on the finer nodes, then A eta' = r for the correction eta'.
  const ComplexVector interpolated = transferred(density, coarse, fine);
  ComplexVector rest = fine.system.right_hand_side();
  const double r_0 = residual * rest.norm();
  rest -= fine.system(interpolated);
  const GmresResult result =
      solve_in_parts(fine, rest, correction_tolerance(r_0, rest.norm(), coarse.kind));
  const ComplexVector correction = deinterleaved(result.solution);
  const ComplexVector corrected = interpolated + correction;
  const double moved = relative_change(fine.problem(), coarse.system.closure().complete(density),
                                       fine.system.closure().complete(corrected), scale)
                           .value_or(correction.cwiseAbs().maxCoeff() / scale);
  // If the densities are hardly resolved, the solution on finer nodes has an error, too.
  constexpr double safety = 2.0;
  return {safety * moved, result.applications + 1, corrected};
}

TailEstimate tail_estimate(const ComplexVector& density, double scale) {
  const double largest = density.cwiseAbs().maxCoeff();
  if (largest == 0.0) return {0.0, std::numeric_limits<double>::infinity()};
  const Index n = density.size();
  const ComplexVector c = fourier_coefficients(density);
  const Index window = std::max<Index>(3, n / 16);
  const auto largest_mode = [&](Index from) {
    double most = 0.0;
    for (Index k = from; k < from + window; ++k) {
      most = std::max({most, std::abs(c[k]), std::abs(c[n - k])});
    }
    return most;
  };
  // The largest modes near k = 3n/16, near k = 3n/8, and at the end of the spectrum, k = n/2.
  const double early = largest_mode(std::max<Index>(1, 3 * n / 16 - window / 2));
  const double late = largest_mode(3 * n / 8 - window / 2);
  const double last = largest_mode(n / 2 - window);
  const double decay = std::max(0.0, std::log(early / late) / (0.1875 * static_cast<double>(n)));
  // A spectrum that does not decay is treated like one that decays over its whole length, at the
  // rate 2/n.
  const double rate = std::max(decay, 2.0 / static_cast<double>(n));
  // Sum of the modes k > n/2, as a geometric series that continues the modes near 3n/8.
  const double beyond =
      late * std::exp(-0.125 * rate * static_cast<double>(n)) / -std::expm1(-rate);
  const double sum = std::max(beyond, 3.0 * last);
  // min(60 sum^2 / largest, 10 sum), relative to the scale.
  return {sum / scale * std::min(60.0 * sum / largest, 10.0), decay};
}

std::vector<TailEstimate> tail_estimates(const LinearSystem& discrete,
                                         const Discretisation& discretisation,
                                         const ComplexVector& density, double scale) {
  const ComplexVector complement = discrete.system.closure().without_rigid_part(density);
  const std::vector<Index>& offsets = discrete.system.offsets();
  std::vector<TailEstimate> tails;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    tails.push_back(
        tail_estimate(complement.segment(offsets[k], offsets[k + 1] - offsets[k]), scale));
    tails[k].error = std::max(tails[k].error, discretisation[k]->shape_residual);
  }
  return tails;
}

Resolutions refine(Resolutions resolutions) {
  // A quarter more nodes, rounded to an even number.
  for (auto& [n_nodes, grading] : resolutions) n_nodes += std::max(16, 2 * ((n_nodes + 7) / 8));
  return resolutions;
}

Resolutions coarsen(Resolutions resolutions) {
  for (auto& [n_nodes, grading] : resolutions) n_nodes = rounded_nodes(0.5 * n_nodes);
  return resolutions;
}

Resolutions refine_automatic(const Scene& scene, Resolutions before) {
  const Resolutions finer = refine(before);
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (component_of(scene, k).has_automatic_nodes()) before[k] = finer[k];
  }
  return before;
}

Resolutions refine_pairs(const Scene& scene, Resolutions before,
                         const std::vector<ComponentPair>& pairs) {
  std::set<std::size_t> components;
  for (const auto& [a, b] : pairs) components.insert({a, b});
  for (const std::size_t k : components) {
    int& nodes = before[k].n_nodes;
    if (!component_of(scene, k).has_automatic_nodes()) continue;
    nodes = std::min(rounded_nodes(1.5 * nodes), std::max(nodes, most_nodes_of_a_component));
  }
  return before;
}

double extrapolated_nodes(int n_nodes, double decay, double excess) {
  // n + ln(excess) / decay, at most 3n/2.
  const double nodes = n_nodes, orders = std::log(excess);
  return nodes + std::min(orders / std::max(decay, 1e-300), 0.5 * nodes);
}

Resolutions refine_by_tails(const Scene& scene, Resolutions before,
                            const std::vector<TailEstimate>& tails, double error) {
  // The error that one component may cause, and the error at which more nodes aim if a component
  // causes a larger one.
  const double allowed = 0.1 * scene.solver.tolerance, aimed_at = 0.05 * scene.solver.tolerance;
  const double most = std::ranges::max(tails, {}, &TailEstimate::error).error;
  if (most < allowed) return before;
  // The component with the largest tail is held responsible for the whole error, and the others in
  // proportion to their tails.
  for (std::size_t k = 0; k < before.size(); ++k) {
    const double share = error * tails[k].error / most;
    if (!component_of(scene, k).has_automatic_nodes() || !(share > allowed)) continue;
    constexpr double least_factor = 1.125;
    int& nodes = before[k].n_nodes;
    const double required = extrapolated_nodes(nodes, tails[k].decay, share / aimed_at);
    nodes = rounded_nodes(std::max(required, least_factor * nodes));
  }
  return before;
}

}  // namespace stokesbook
