// Tests the treatment of a net flux (04.2): its detection, the solution of the system with N_0
// (04.7), and flow through inner walls.
#include <cmath>

#include "experiments.hpp"
#include "support/exact_flows.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::null_space {

using namespace study;
using Eigen::Index;

namespace {

/// @name Data with a net flux
/// @{

/// Describes an annulus with flow through both circles. Fluid enters through the inner circle and
/// leaves through the wall, where additionally the net flux q flux_scale() leaves, unevenly
/// distributed.
struct LeakingCell {
  StokesProblem tight = annulus_problem(eccentric_annulus(0.5), 1.0, 96, 96);
  double flux = 0.0;

  explicit LeakingCell(double q) {
    const double blown = 0.3;  // flux through the inner circle of radius 1
    tight.components[0].velocity -=
        blown / (2.0 * std::numbers::pi) * normals(tight.components[0].curve);
    let_out(tight, blown);
    flux = q * flux_scale(tight);
  }

  StokesProblem problem() const {
    StokesProblem leaking = tight;
    let_out(leaking, flux);
    return leaking;
  }

  /// Returns the data with g - n Q / |Gamma| on one of the circles.
  StokesProblem repaired(std::size_t component) const {
    StokesProblem result = problem();
    Component& wall = result.components[component];
    wall.velocity -= flux / perimeter(wall.curve) * normals(wall.curve);
    return result;
  }

 private:
  /// Adds a flow of the given flux through the outer circle. The cosine and sine parts of its
  /// profile carry no flux.
  static void let_out(StokesProblem& problem, double through) {
    Component& wall = problem.components[1];
    const ComplexVector normal = normals(wall.curve);
    const Eigen::VectorXd profile = 1.0 + normal.real().array() - 0.5 * normal.imag().array();
    wall.velocity += through / perimeter(wall.curve) * normal.cwiseProduct(profile);
  }
};

ComplexVector flow_of(const StokesProblem& problem, AnnulusMatrix matrix) {
  const Complex centre = eccentric_annulus(0.5).inner_centre;
  const ComplexVector points = centre + ComplexVector{{{1.4, 0.3}, {0.3, 1.7}, {1.3, 1.2}}}.array();
  return velocity_at(problem, solve_annulus(problem, matrix(problem)), points);
}

double difference(const ComplexVector& u, const ComplexVector& v) {
  return test::largest(u - v) / test::largest(v);
}

Measure over_leaks(const std::function<double(const LeakingCell&)>& error) {
  return over({1e-8, 1e-6, 1e-4, 1e-2, 1.0}, [=](double q) { return error(LeakingCell(q)); });
}

double flux_error(const LeakingCell& cell) {
  return std::abs(net_flux(cell.problem()) - cell.flux) / flux_scale(cell.problem());
}

/// A planted defect: the flux is that of the enclosing wall only.
double flux_error_without_inner(const LeakingCell& cell) {
  const StokesProblem problem = cell.problem();
  const Component& wall = problem.components[1];
  return std::abs(flux_through(wall.curve, wall.velocity) - cell.flux) / flux_scale(problem);
}

template <std::size_t repaired_component>
double repair_error(const LeakingCell& cell) {
  return difference(flow_of(cell.problem(), right_matrix),
                    flow_of(cell.repaired(repaired_component), right_matrix));
}

/// Returns the difference from the flow for the data without net flux.
double silent_error(const LeakingCell& cell) {
  return difference(flow_of(cell.problem(), right_matrix), flow_of(cell.tight, right_matrix));
}

double error_without_n0(const LeakingCell& cell) {
  return difference(flow_of(cell.problem(), matrix_without_n0), flow_of(cell.tight, right_matrix));
}

/// Compares the density's flux with -Q / c, its value for c N_0 on the wall.
template <int wall_lengths>
double density_error(const LeakingCell& cell) {
  const StokesProblem problem = cell.problem();
  const Curve& wall = problem.components[1].curve;
  const double factor = wall_lengths == 0 ? 1.0 : perimeter(wall);
  const Eigen::MatrixXd matrix =
      test::assemble_bounded(problem, ClosureForm::reduced, factor).matrix;
  const ComplexVector density = solve_annulus(problem, matrix).outer;
  return std::abs(flux_through(wall, density) + cell.flux) / flux_scale(problem);
}

/// @}
/// @name A source inside the inner circle
/// @{

constexpr double inner_radius = 1.0, outer_radius = 4.0, source_distance = 0.75;
constexpr Complex inner_centre{0.4, -0.3}, outer_centre{0.8, 0.0};
const test::ExactFlow source_flow{{{inner_centre + std::polar(source_distance, 2.1), 0.0, 1.0}}};

/// Returns the error of the flow of a source. Either the flux of every component is subtracted from
/// its data, as if every component had to be without flux, or all fluxes are kept.
template <bool each_without_flux>
double source_error(Index n) {
  StokesProblem problem{{test::held_body(Circle{inner_radius}, n, {inner_centre}, {}),
                         test::enclosing_wall(Circle{outer_radius}, n, {outer_centre})},
                        1.0,
                        {},
                        {}};
  for (Component& component : problem.components) {
    const Curve& curve = component.curve;
    component.velocity = source_flow.velocity(curve.x);
    if (!each_without_flux) continue;
    component.velocity -=
        flux_through(curve, component.velocity) / perimeter(curve) * normals(curve);
  }
  // The points are more than twice as far from both circles as the source is from the inner one.
  const ComplexVector points =
      inner_centre + ComplexVector{{{2.0, 0.0}, {-1.2, 1.4}, {0.6, -1.9}}}.array();
  const ComplexVector exact = source_flow.velocity(points);
  return difference(velocity_at(problem, solve_annulus(problem, right_matrix(problem)), points),
                    exact);
}

/// @}

}  // namespace

Experiment leak() {
  return {
      .key = "leak",
      .title = "Data with a net flux",
      .x = "relative flux q",
      .error = "flow, flux: relative differences",
      .axes = Axes::log_log,
      .lines = {
          {.key = "found",
           .label = "flux found by net_flux()",
           .measure = over_leaks(flux_error),
           .claim = Claim{.id = "04_15",
                          .statement = "The net flux of the data is found to rounding, whatever "
                                       "flows through the inner circle.",
                          .law = Identity{1e-14},
                          .reason = "the trapezoid rule is exact for the modes of these data",
                          .api = {"stokesbook::net_flux", "stokesbook::flux_scale"}},
           .control = Control{"the inner circle left out", over_leaks(flux_error_without_inner)}},
          {.key = "repaired",
           .label = "flow, against that of g - n Q / |Gamma_0|",
           .measure = over_leaks(repair_error<1>),
           .claim =
               Claim{.id = "04_16",
                     .statement = "With a net flux Q the system gives the flow of the data g - n Q "
                                  "/ |Gamma_0|, without a warning.",
                     .law = Identity{1e-13},
                     .reason = "n from the left: integral of n . eta = -Q, and N_0 eta = n Q / "
                               "|Gamma_0| goes to the right-hand side",
                     .api = {"stokesbook::net_flux", "stokesbook::null_space_matrix"}},
           .control = Control{"repaired on the inner circle", over_leaks(repair_error<0>)}},
          {.key = "density",
           .label = "flux of the wall's density, against -Q",
           .measure = over_leaks(density_error<0>),
           .claim = Claim{.id = "04_17",
                          .statement =
                              "Only the density shows a net flux: its flux through the wall is -Q.",
                          .law = Identity{1e-13},
                          .reason = "n from the left, as before",
                          .api = {"stokesbook::null_space_velocity"}},
           .control =
               Control{"N_0 not divided by the wall's length", over_leaks(density_error<1>)}},
          {.key = "silent",
           .label = "flow, against that of the data without net flux",
           .measure = over_leaks(silent_error)},
          {.key = "without",
           .label = "the same without N_0",
           .measure = over_leaks(error_without_n0)}}};
}

Experiment source() {
  const double rate = std::log(inner_radius / source_distance);
  return {
      .key = "source",
      .title = "A source inside the inner circle",
      .x = "nodes N",
      .error = "largest error of the velocity, relative to the largest velocity",
      .axes = Axes::semi_log,
      .lines = {{.key = "total",
                 .label = "total flux zero",
                 .measure = over_nodes(rate, 5.0, 34.0, source_error<false>),
                 .claim = Claim{.id = "04_18",
                                .statement = "Flux through an inner wall is allowed: a source in "
                                             "it is found at the rate of its distance.",
                                .law = Geometric{rate, 0.04},
                                .window = {.from = 9.0 / rate, .floor = 1e-15},
                                .reason = "modes (d / R_1)^|k| of the density alias by N",
                                .api = {"stokesbook::assemble", "stokesbook::net_flux"}},
                 .control = Control{"every component's own flux taken off its data",
                                    over_nodes(rate, 5.0, 34.0, source_error<true>)}},
                {.key = "each",
                 .label = "flux through each wall zero",
                 .measure = over_nodes(rate, 5.0, 34.0, source_error<true>)}}};
}

}  // namespace stokesbook::verification::null_space
