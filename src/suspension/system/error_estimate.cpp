// Estimates the error of a solution by a correction on finer nodes: interpolates the density,
// solves for the correction of its residual, and compares motions and loads before and after
// (chapter 12, section "How fine").
#include "suspension/system/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Safety factor: if the densities are hardly resolved, the solution on finer nodes has an error,
// too.
constexpr double safety = 2.0;

// Returns the GMRES tolerance for the correction, relative to its right-hand side r, for
// relative = |r| / |b| and iteration = |r_0| / |b|. The tolerance is the lesser of 100 |r| / |b|,
// because the error of the motions is quadratic in r, and of 0.1 |r_0| / |r|, because an
// ill-conditioned system hides the residual r_0 of the iteration in its softest modes.
double correction_tolerance(double relative, double iteration) {
  return std::clamp(std::min(100.0 * relative, 0.1 * iteration / relative), 1e-8, 0.03);
}

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
    const ComplexVector solved = deinterleaved(coarse.precondition(interleaved(low)));
    const ComplexVector high = all - transferred(low, coarse, fine);
    const ComplexVector both = transferred(solved, coarse, fine) - 2.0 * high;
    return Eigen::VectorXd(interleaved(both));
  };
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
  return std::max(motions / scale, loads / load_scale);
}

ErrorEstimate estimate_error(const LinearSystem& coarse, const GmresResult& solution,
                             const LinearSystem& fine, double scale) {
  const Closure& closure = fine.system.closure();
  const ComplexVector density = deinterleaved(solution.solution);
  // r = b - A eta on the finer nodes, then A eta' = r for the correction eta'.
  const ComplexVector interpolated = transferred(density, coarse, fine);
  const ComplexVector rhs = fine.system.right_hand_side();
  const ComplexVector residual = rhs - fine.system(interpolated);
  const double tolerance = correction_tolerance(residual.norm() / rhs.norm(), solution.residual);
  const GmresResult correction =
      solve({fine.problem, fine.system, refined_preconditioner(coarse, fine)}, residual,
            {tolerance, static_cast<int>(2 * residual.size())});
  const ComplexVector change = deinterleaved(correction.solution);
  const double moved = relative_change(fine.problem, coarse.system.closure().complete(density),
                                       closure.complete(interpolated + change), scale)
                           .value_or(change.cwiseAbs().maxCoeff() / scale);
  return {safety * moved, correction.iterations + 2};
}

}  // namespace stokesbook
