#include "suspension/system/error_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "double_layer/double_layer.hpp"
#include "trapezoid/fourier.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

// Where densities are hardly resolved, the finer solution errs too.
constexpr double safety = 2.0;

// How closely to look at a residual, relative to itself, when it is `relative` to the data: closely
// enough for what is quadratic in it, and for what the iteration left, which an ill-conditioned
// system hides in its softest modes.
double correction_tolerance(double relative, double iteration) {
  return std::clamp(std::min(100.0 * relative, 0.1 * iteration / relative), 1e-8, 0.03);
}

// Interpolates, component by component, from the nodes of one system to those of another.
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

// The coarse system's preconditioner for the fine one. Of modes beyond the coarse nodes the
// operator leaves little but the jump -1/2.
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
