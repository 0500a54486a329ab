// Moves the lattice of a periodic cell with the undisturbed flow, and finds the images of bodies in
// the cell (chapter 14). A traceless gradient G has the square (-det G) I, so that
// e^{Gs} = cosh(ks) I + sinh(ks)/k G with k^2 = -det G.
#include "suspension/bodies/cell.hpp"

#include <cmath>
#include <variant>

#include "suspension/bodies/background_flow.hpp"
#include "suspension/bodies/forcing.hpp"

namespace stokesbook {

namespace {

// The gradient G of a linear flow, which is the same everywhere, as a map of vectors.
struct Gradient {
  FlowDerivatives flow;

  // G w = (i omega w + s conj(w)) / 2 with vorticity omega and strain s (07.4).
  Complex operator()(Complex w) const {
    return 0.5 * (imaginary * flow.vorticity * w + flow.strain * std::conj(w));
  }

  // e^{Gs} w
  Complex carried(Complex w, double s) const {
    const Complex k =
        0.5 * std::sqrt(Complex{std::norm(flow.strain) - flow.vorticity * flow.vorticity});
    const double stretch = k == 0.0 ? s : (std::sinh(k * s) / k).real();
    return std::cosh(k * s).real() * w + stretch * (*this)(w);
  }
};

Gradient gradient_of(const Scene& scene) {
  return {background_derivatives(scene.flow, 0.0)};
}

}  // namespace

Complex cell_centre(const Scene& scene) {
  const auto centre = [](const auto& flow) -> Complex {
    if constexpr (requires { flow.centre; }) return flow.centre;
    return 0.0;
  };
  return std::visit(centre, scene.flow);
}

Lattice lattice_of(const PeriodicCell& cell) {
  return {cell.a1, cell.a2};
}

std::optional<PeriodicCell> cell_at(const Scene& scene, double t) {
  if (!scene.cell) return {};
  const Gradient gradient = gradient_of(scene);
  const double s = flow_time(scene, t);
  const Eigen::Matrix2d& a = scene.cell->vectors;
  return PeriodicCell{gradient.carried({a(0, 0), a(0, 1)}, s),
                      gradient.carried({a(1, 0), a(1, 1)}, s), scene.cell->pressure_gradient};
}

std::optional<Lattice> lattice_at(const Scene& scene, double t) {
  const std::optional<PeriodicCell> cell = cell_at(scene, t);
  return cell ? std::optional(lattice_of(*cell)) : std::nullopt;
}

Complex image_velocity(const Scene& scene, Complex vector) {
  return gradient_of(scene)(vector);
}

std::vector<PathShift> path_shifts(const Scene& scene, const PeriodicCell& cell,
                                   const Configuration& paths) {
  const Lattice lattice = lattice_of(cell);
  std::vector<PathShift> shifts;
  for (const auto& [position, orientation] : paths) {
    const Complex w = lattice.nearest(position - cell_centre(scene));
    shifts.push_back({w, image_velocity(scene, w)});
  }
  return shifts;
}

std::optional<LatticeStep> lattice_step(const std::optional<Lattice>& start,
                                        const std::optional<Lattice>& end) {
  return start ? std::optional(LatticeStep{*start, *end}) : std::nullopt;
}

}  // namespace stokesbook
