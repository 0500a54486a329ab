// Tests that tractions integrate to loads, and that the power of the boundary equals the
// dissipation in the fluid (07.11).
#include <algorithm>

#include "experiments.hpp"
#include "stress/dissipation.hpp"
#include "stress/stress.hpp"
#include "stress/traction.hpp"
#include "support/distance.hpp"
#include "support/eccentric_annulus.hpp"

namespace stokesbook::verification::stress {

using namespace study;
using Eigen::Index;

namespace {

using Traction = ComplexVector (*)(const StokesProblem&, const std::vector<FlowDerivatives>&);

/// A planted defect: the traction lacks the pressure.
ComplexVector without_pressure(const StokesProblem& problem,
                               const std::vector<FlowDerivatives>& at_nodes) {
  std::vector<FlowDerivatives> viscous = at_nodes;
  for (FlowDerivatives& at : viscous) at.pressure = 0.0;
  return boundary_traction(problem, viscous);
}

ComplexVector traction_of(const SolvedFlow& flow, Traction traction = boundary_traction) {
  return traction(flow.problem(), flow.derivatives(flow.nodes()));
}

/// Returns an ellipse under a load and a circle under the opposite force, at a gap.
StokesProblem loaded_pair(double gap) {
  return {
      {test::free_body(Ellipse{1.0, 0.6}, 192, {{-1.0 - 0.5 * gap, 0.0}, 0.0}, {{1.0, -2.0}, 0.5}),
       test::free_body(Circle{0.8}, 192, {{0.8 + 0.5 * gap, 0.0}}, {{-1.0, 2.0}, 0.3})},
      viscosity,
      {},
      {}};
}

/// Returns the pair inside an ellipse at rest.
StokesProblem contained_pair(double gap) {
  StokesProblem problem = loaded_pair(gap);
  problem.components.push_back(test::enclosing_wall(Ellipse{4.0, 3.0}, 192, {{0.2, 0.1}, 0.3}));
  return problem;
}

const std::vector<double> gaps{0.1, 0.2, 0.4, 0.8};

/// Measures the largest difference of the integrated loads from the given loads, relative to the
/// largest load.
Measure load_errors(StokesProblem (*problem)(double), Traction traction) {
  return over(gaps, [=](double gap) {
    static Once<std::pair<StokesProblem (*)(double), double>, SolvedFlow> solved;
    const SolvedFlow& flow = solved({problem, gap}, [&] { return test::solve_flow(problem(gap)); });
    const std::vector<Load> found = integrated_loads(flow.problem(), traction_of(flow, traction));
    return test::relative_distance(found, flow.completion().loads);
  });
}

/// Returns circles of radii 1 and 2 that move and turn. If the number of nodes is a multiple of 8,
/// a node is at the closest point, so that the errors over N do not scatter with the place of the
/// nodes in the gap.
test::EccentricAnnulus annulus_of(double relative_gap) {
  return {1.0,
          2.0,
          {0.3, -0.2},
          Complex{0.3, -0.2} + std::polar(1.0 - relative_gap, 0.25 * pi),
          {{0.3, -0.4}, 1.0},
          {{0.1, 0.2}, -0.7}};
}

/// Returns the power of the motions of both circles, by the closed form of the inner circle's load.
double exact_power(const test::EccentricAnnulus& annulus) {
  const Load inner = test::inner_load(annulus, viscosity);
  const Complex arm = annulus.inner_centre - annulus.outer_centre;
  const Load outer{-inner.force, -inner.torque - cross(arm, inner.force)};
  return dot(annulus.inner.velocity, inner.force) + annulus.inner.omega * inner.torque +
         dot(annulus.outer.velocity, outer.force) + annulus.outer.omega * outer.torque;
}

const SolvedFlow& solved_annulus(double relative_gap, Index n) {
  static Once<std::pair<double, Index>, SolvedFlow> solved;
  return solved({relative_gap, n}, [&] {
    return test::solve_flow(test::annulus_problem(annulus_of(relative_gap), viscosity, n, n));
  });
}

/// The experiment over N uses the annulus with this gap; outer_coordinate() is the bipolar
/// coordinate of its outer circle.
constexpr double relative_gap = 0.05;

double outer_coordinate() {
  const double e = 1.0 - relative_gap;
  return std::acosh((3.0 + e * e) / (4.0 * e));
}

double power_error(Index n, Traction traction) {
  const SolvedFlow& flow = solved_annulus(relative_gap, n);
  const double exact = exact_power(annulus_of(relative_gap));
  return std::abs(total(boundary_power(flow, traction_of(flow, traction))) / exact - 1.0);
}

double force_error(Index n, Traction traction) {
  const SolvedFlow& flow = solved_annulus(relative_gap, n);
  const Load exact = test::inner_load(annulus_of(relative_gap), viscosity);
  return test::distance(integrated_loads(flow.problem(), traction_of(flow, traction))[0], exact) /
         std::abs(exact.torque);
}

/// Returns tractions on the outer circle between the nodes. They are relative to the first point's
/// pressure because the pressure has an arbitrary constant. The viscous part alone is a planted
/// defect.
ComplexVector traction_on_wall(Index n, bool with_pressure) {
  const SolvedFlow& flow = solved_annulus(relative_gap, n);
  const auto [inner_radius, radius, inner_centre, centre, inner, outer] = annulus_of(relative_gap);
  const ComplexVector normal = ComplexVector::NullaryExpr(
      40, [](Index k) { return std::polar(1.0, 0.13 + 0.157 * static_cast<double>(k)); });
  std::vector<FlowDerivatives> at = flow.derivatives((centre + radius * normal.array()).matrix());
  ComplexVector result(normal.size());
  const double datum = at[0].pressure;
  for (Index k = 0; k < normal.size(); ++k) {
    FlowDerivatives& here = at[static_cast<std::size_t>(k)];
    here.pressure = with_pressure ? here.pressure - datum : 0.0;
    result[k] = stokesbook::traction(here, normal[k], viscosity);
  }
  return result;
}

double traction_error(Index n, Traction traction) {
  static const ComplexVector exact = traction_on_wall(320, true);
  return test::largest(traction_on_wall(n, traction == boundary_traction) - exact) /
         test::largest(exact);
}

/// Returns the difference of the integrated traction on the inner circle from the circle's load in
/// the same solution.
double disagreement(Index n, Traction traction) {
  const SolvedFlow& flow = solved_annulus(relative_gap, n);
  const Load& load = flow.completion().loads[0];
  return test::distance(integrated_loads(flow.problem(), traction_of(flow, traction))[0], load) /
         std::abs(load.torque);
}

using ErrorOf = double (*)(Index, Traction);

Measure over_eights(ErrorOf error, Traction traction) {
  return [=](Size size) {
    std::vector<Index> counts;
    for (Index n = 32; n <= 160; n += size == Size::full ? 8 : 16) counts.push_back(n);
    return test::errors_at(
        counts, [=](Index n) { return error(n, traction); }, 4.0);
  };
}

const std::vector<double> relative_gaps{0.3, 0.45, 0.7};

/// Returns the fluid's dissipation by one method. The experiments compare the dissipation with the
/// power of motions and loads.
using Power = std::function<double(const SolvedFlow&)>;

Measure power_differences(const Power& power) {
  return over(relative_gaps, [=](double gap) {
    const SolvedFlow& flow = solved_annulus(gap, 160);
    return std::abs(power(flow) / total(power_of_loads(flow)) - 1.0);
  });
}

/// Holds a quadrature of the fluid, and the flow's derivatives at its points.
struct Sampled {
  FluidQuadrature rule;
  std::vector<FlowDerivatives> at;
};

const Sampled& sampled(const SolvedFlow& flow) {
  static Once<const SolvedFlow*, Sampled> all;
  return all(&flow, [&] {
    const FluidQuadrature rule = fluid_quadrature(curves_of(flow.problem()));
    return Sampled{rule, flow.derivatives(rule.points)};
  });
}

double by_volume(const SolvedFlow& flow) {
  const auto& [rule, at] = sampled(flow);
  return volume_dissipation(rule, at, viscosity);
}

/// A planted defect: the squares of all derivatives are summed,
/// mu grad u : grad u = mu (|q|^2 + w^2) / 2.
double by_squares_of_gradients(const SolvedFlow& flow) {
  const auto& [rule, at] = sampled(flow);
  double sum = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    sum += 0.5 * rule.weights[static_cast<Index>(i)] * viscosity *
           (std::norm(at[i].strain) + at[i].vorticity * at[i].vorticity);
  }
  return sum;
}

Power by_boundary(Traction traction) {
  return [=](const SolvedFlow& flow) {
    return total(boundary_power(flow, traction_of(flow, traction)));
  };
}

/// Returns the Couette cell of reference C6, with its centre at some place relative to the grid.
StokesProblem couette(Complex centre) {
  return {{test::held_body(Circle{1.0}, 64, {centre}, {0.0, 0.4}),
           test::enclosing_wall(Circle{2.5}, 64, {centre}, {0.0, -0.7})},
          viscosity,
          {},
          {}};
}

/// Measures the differences of the power of loads on n nodes a circle from that of the closed form.
Measure closed_form_differences(Index n) {
  return over(relative_gaps, [=](double gap) {
    const double computed = total(power_of_loads(solved_annulus(gap, n)));
    return std::abs(exact_power(annulus_of(gap)) / computed - 1.0);
  });
}

constexpr double couette_dissipation = 23.532024971889261;

using Rule = FluidQuadrature (*)(const std::vector<Curve>&, double);

/// A planted defect, which is also the naive method: all points of the grid in the fluid have equal
/// weights.
FluidQuadrature masked(const std::vector<Curve>& curves, double points) {
  const double spacing = strip_width(curves) / points;
  const Complex centre = boundary_centroid(curves[0]);
  std::vector<Complex> inside;
  const auto reach = static_cast<int>(3.0 / spacing);
  for (int j = -reach; j <= reach; ++j) {
    for (int i = -reach; i <= reach; ++i) {
      const Complex z = spacing * Complex{static_cast<double>(i), static_cast<double>(j)};
      const double r = std::abs(z - centre);
      if (r > 1.0 && r < 2.5) inside.push_back(z);
    }
  }
  const auto m = static_cast<Index>(inside.size());
  return {Eigen::Map<const ComplexVector>(inside.data(), m),
          Eigen::VectorXd::Constant(m, spacing * spacing)};
}

/// Measures the root mean square of the errors over five places of the cell, because a single place
/// may have a small error by accident.
Measure quadrature_errors(Rule rule) {
  return over({9.0, 25.0, 49.0, 81.0, 121.0, 169.0, 225.0, 289.0}, [=](double square) {
    double sum = 0.0;
    for (int k = 0; k < 5; ++k) {
      static Once<int, SolvedFlow> solved;
      const SolvedFlow& flow = solved(
          k, [&] { return test::solve_flow(couette(0.1 * std::polar(1.0 + k, 0.7 + 2.1 * k))); });
      const FluidQuadrature points = rule(curves_of(flow.problem()), std::sqrt(square));
      const double found = volume_dissipation(points, flow.derivatives(points.points), viscosity);
      sum += std::pow(found / couette_dissipation - 1.0, 2);
    }
    return std::sqrt(sum / 5.0);
  });
}

}  // namespace

Experiment loads_of_tractions() {
  const auto line = [](const std::string& key, const std::string& id, const std::string& label,
                       StokesProblem (*problem)(double), const std::string& defect,
                       Traction defective) {
    return Line{
        .key = key,
        .label = label,
        .measure = load_errors(problem, boundary_traction),
        .claim = Claim{.id = id,
                       .statement = "Tractions integrate to the forces and torques on all "
                                    "components, given or solved for.",
                       .law = Identity{1e-12},
                       .reason = "a double layer carries neither force nor torque through any "
                                 "curve; Stokeslets and rotlets carry theirs",
                       .api = {"stokesbook::boundary_traction", "stokesbook::integrated_loads"}},
        .control = Control{defect, load_errors(problem, defective)}};
  };
  return {.key = "loads",
          .title = "Forces and torques from tractions",
          .x = "gap ε",
          .error = "largest difference, relative to the largest load",
          .axes = Axes::log_log,
          .lines = {line("unbounded", "07_14", "two bodies, unbounded", loaded_pair,
                         "the traction without its pressure", without_pressure),
                    line("contained", "07_15", "two bodies in a container", contained_pair,
                         "the pseudo-traction -p n + mu du/dn", pseudo_traction)}};
}

Experiment eccentric() {
  const double rate = outer_coordinate();
  return {
      .key = "eccentric",
      .title = "Eccentric cylinders: traction, force and dissipation",
      .x = "nodes N",
      .error = "relative error",
      .axes = Axes::semi_log,
      .lines = {
          {.key = "traction",
           .label = "traction on the outer circle",
           .measure = over_eights(traction_error, boundary_traction),
           .claim = Claim{.id = "07_16",
                          .statement = "With close evaluation between the circles the "
                                       "traction converges as its modes fall, at half "
                                       "the wall's bipolar coordinate.",
                          .law = Geometric{0.5 * rate, 0.05, 1.0},
                          .window = {.from = 60.0, .floor = 1e-13},
                          .reason = "the flow's only singularities are the foci of the "
                                    "circles; N nodes hold modes below N/2",
                          .api = {"stokesbook::boundary_traction"}},
           .control = Control{"the traction without its pressure",
                              over_eights(traction_error, without_pressure)}},
          {.key = "load",
           .label = "load of the inner circle, integrated",
           .measure = over_eights(force_error, boundary_traction),
           .claim =
               Claim{.id = "07_17",
                     .statement =
                         "Integrals over the boundary converge at twice the rate of the traction.",
                     .law = Geometric{rate, 0.05, 2.0},
                     .window = {.from = 40.0, .floor = 1e-12},
                     .reason = "aliases N - k of one factor meet modes k of the "
                               "other, N pairs e^{-a N}; a derivative has one more "
                               "N",
                     .api = {"stokesbook::integrated_loads"}},
           .control = Control{"the pseudo-traction -p n + mu du/dn",
                              over_eights(force_error, pseudo_traction)}},
          {.key = "dissipation",
           .label = "dissipation, by the boundary",
           .measure = over_eights(power_error, boundary_traction),
           .claim = Claim{.id = "07_18",
                          .statement = "The power of the boundary converges like loads.",
                          .law = Geometric{rate, 0.05, 2.0},
                          .window = {.from = 40.0, .floor = 1e-13},
                          .reason = "the motions are rigid: it is a sum of loads",
                          .api = {"stokesbook::boundary_power"}},
           .control = Control{"the pseudo-traction -p n + mu du/dn",
                              over_eights(power_error, pseudo_traction)}},
          {.key = "agreement",
           .label = "traction integrated against the load it came with",
           .measure = over_eights(disagreement, boundary_traction)}}};
}

Experiment dissipation_of_gaps() {
  return left_to_full(
      {.key = "dissipation",
       .title = "The dissipation between eccentric cylinders, three ways and in closed form",
       .x = "relative gap ε",
       .error = "difference from motions times loads, relative",
       .axes = Axes::log_log,
       .lines = {
           {.key = "boundary",
            .label = "velocity times traction on the boundary",
            .measure = power_differences(by_boundary(boundary_traction)),
            .claim = Claim{.id = "07_19",
                           .statement = "The power of velocities and tractions is that of motions "
                                        "and loads.",
                           .law = Identity{1e-12},
                           .reason = "the motions are rigid, and tractions integrate to loads",
                           .api = {"stokesbook::boundary_power", "stokesbook::power_of_loads"}},
            .control = Control{"the pseudo-traction -p n + mu du/dn",
                               power_differences(by_boundary(pseudo_traction))}},
           {.key = "volume",
            .label = "2μ e:e over the fluid",
            .measure = power_differences(by_volume),
            .claim =
                Claim{.id = "07_20",
                      .statement = "The dissipation in the fluid is the power of its boundary.",
                      .law = Identity{1e-9},
                      .reason = "div (sigma u) = 2 mu e:e; the quadrature over the fluid errs "
                                "by 1e-11",
                      .api = {"stokesbook::volume_dissipation", "stokesbook::fluid_quadrature"}},
            .control = Control{"mu grad u : grad u in the place of 2 mu e:e",
                               power_differences(by_squares_of_gradients)}},
           {.key = "closed",
            .label = "the closed form of the loads",
            .measure = closed_form_differences(160),
            .claim =
                Claim{.id = "07_21",
                      .statement = "The power of motions and loads is that of the closed form.",
                      .law = Identity{1e-11},
                      .reason = "160 nodes a circle resolve these gaps to rounding",
                      .api = {"stokesbook::power_of_loads"}},
            .control = Control{"12 nodes a circle", closed_form_differences(12)}}}});
}

Experiment quadrature() {
  constexpr double beta = 5.25;
  return {
      .key = "quadrature",
      .title = "The dissipation of a Couette cell by quadrature over the fluid",
      .x = "squared grid points across a strip P²",
      .error = "relative error, root mean square over five places of the cell",
      .axes = Axes::semi_log,
      .lines = {{.key = "blended",
                 .label = "strips and grid, smoothly cut off",
                 .measure = quadrature_errors(fluid_quadrature),
                 .claim = Claim{.id = "07_22",
                                .statement = "With P grid points across a strip the sum errs as "
                                             "e^{-(pi P / (2 beta))^2}.",
                                .law = Geometric{std::pow(pi / (2.0 * beta), 2), 0.1},
                                .window = {.from = 20.0, .floor = 1e-13},
                                .reason = "the Fourier transform of the cut-off's slope, a Gauss "
                                          "function of width delta / (2 beta), at the grid's "
                                          "frequency 2 pi P / delta",
                                .api = {"stokesbook::fluid_quadrature"}},
                 .control = Control{"the points of a grid that lie in the fluid",
                                    quadrature_errors(masked)}},
                {.key = "masked",
                 .label = "grid points that lie in the fluid",
                 .measure = quadrature_errors(masked)}}};
}

}  // namespace stokesbook::verification::stress
