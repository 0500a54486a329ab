// Checks the data, the geometry, the memory and the accuracy of a scene, and explains why it cannot
// be solved, and which change would help (chapter 12, section "How it fails").
#include "suspension/solver/solver_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <sys/resource.h>
#include <unistd.h>

#include "closure/bordered_system.hpp"
#include "krylov/block_diagonal.hpp"
#include "near_singular/near_field.hpp"
#include "null_space/null_space.hpp"
#include "suspension/bodies/components.hpp"
#include "suspension/nodes/node_choice.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

std::string tolerance_of(const Scene& scene) {
  return "solver.tolerance = " + short_number(scene.solver.tolerance);
}

std::string name_of(const Scene& scene, std::size_t component) {
  return component_of(scene, component).name();
}

std::string name_of(const Scene& scene, const Gap& gap) {
  return gap.shift == 0.0 ? name_pair(scene, gap.a, gap.b) : name_image_pair(scene, gap.a, gap.b);
}

// Returns " (nearest: body 3, 0.01 apart)", or an empty text if no component is near.
std::string nearest_neighbour(const Scene& scene, std::size_t component,
                              const std::vector<Gap>& gaps) {
  const auto nearest = std::ranges::find_if(
      gaps, [&](const Gap& gap) { return gap.a == component || gap.b == component; });
  if (nearest == gaps.end()) return {};
  const std::size_t other = nearest->a == component ? nearest->b : nearest->a;
  const std::string image = nearest->shift == 0.0 ? "" : "an image of ";
  return " (nearest: " + image + name_of(scene, other) + ", " + short_number(nearest->points.gap) +
         " apart)";
}

std::string gigabytes(double bytes) {
  return short_number(bytes / 1e9) + " GB";
}

std::string shape_message(const Scene& scene, std::size_t component,
                          const DiscretisedShape& discretised) {
  const double tolerance = scene.solver.tolerance;
  const int nodes = nodes_for_shape(discretised.shape, discretised.curve.side, tolerance,
                                    discretised.resolution.n_nodes);
  return name_of(scene, component) + ": " + std::to_string(discretised.curve.size()) +
         " nodes resolve its shape to " + short_number(discretised.shape_residual) + " only" +
         (nodes > 0
              ? ", " + tolerance_of(scene) + "; set n_nodes to at least " + std::to_string(nodes)
              : "; " + unresolved_shape(discretised.shape, tolerance));
}

// Explains that the trapezoid rule of a curve is too inaccurate at the nearest point of the other
// curve, which matters if there are no near corrections. The error is 200 exp(-N |Im s|) (06.5).
std::string plain_rule_message(const Scene& scene, const Gap& gap,
                               const Configuration& configuration,
                               const Discretisation& discretisation) {
  const auto error = [&](std::size_t component, Complex target) {
    const auto [position, orientation] = configuration[component];
    const Curve curve = place(discretisation[component]->curve, position, orientation);
    return std::exp(near_cut(1.0) - preimage_depth(curve, target));
  };
  const double worst =
      std::max(error(gap.a, gap.points.point_b), error(gap.b, gap.points.point_a - gap.shift));
  if (worst <= scene.solver.tolerance) return {};
  return name_of(scene, gap) + " are " + short_number(gap.points.gap) +
         " apart, too close for the plain trapezoid rule: estimated error " + short_number(worst) +
         ", " + tolerance_of(scene) + "; set solver.near_singular = \"auto\"";
}

std::string gap_message(const Scene& scene, const Gap& gap, const GapResolution& resolution) {
  const auto advice = [&](std::size_t component, double decay) {
    return "n_nodes of " + name_of(scene, component) + " to at least " +
           std::to_string(nodes_for_decay(decay, scene.solver.tolerance));
  };
  return name_of(scene, gap) + " are " + short_number(gap.points.gap) +
         " apart, too close for their nodes: estimated error " + short_number(resolution.error) +
         " of the velocities, " + tolerance_of(scene) + "; set " +
         advice(gap.a, resolution.decay.a) + ", and " + advice(gap.b, resolution.decay.b);
}

// Returns the radius of all components with prescribed velocity about the mean of their nodes; 0 if
// there is no such component.
double prescribed_extent(const StokesProblem& problem) {
  std::vector<Complex> nodes;
  for (const Component& component : problem.components) {
    if (component.kind != ComponentKind::prescribed) continue;
    nodes.insert(nodes.end(), component.curve.x.begin(), component.curve.x.end());
  }
  const Eigen::Map<const ComplexVector> x(nodes.data(), static_cast<Eigen::Index>(nodes.size()));
  return nodes.empty() ? 0.0 : (x.array() - x.mean()).abs().maxCoeff();
}

// Returns the smaller eigenvalue of 4 pi mu M, with the mobility M (U = M F) of a body that is
// alone in a fluid at rest.
double least_mobility(const Component& body, const StokesProblem& problem) {
  const StokesProblem unloaded{{body}, problem.viscosity, {}, problem.gauge_length};
  const Eigen::MatrixXd inverse = invert_block(assemble(unloaded, ClosureForm::reduced).matrix);
  const auto velocity = [&](Complex force) {
    StokesProblem alone = unloaded;
    alone.components[0].force = force;
    alone.components[0].torque = 0.0;
    const Eigen::VectorXd density = inverse * assemble(alone, ClosureForm::reduced).rhs;
    return complete_dense(alone, ClosureForm::reduced, density).motions[0].velocity;
  };
  const Complex first = velocity(1.0), second = velocity(imaginary);
  const double mean = 0.5 * (first.real() + second.imag());
  // The eigenvalues of a symmetric 2 x 2 matrix are mean +- deviation.
  const double deviation = std::hypot(0.5 * (first.real() - second.imag()), first.imag());
  return 4.0 * std::numbers::pi * problem.viscosity * (mean - deviation);
}

// Returns the velocity of a uniform flow, or of all uniform terms of a sum.
Complex uniform_part(const BackgroundFlow& flow) {
  if (const auto* uniform = std::get_if<UniformFlow>(&flow)) return uniform->velocity;
  Complex velocity{};
  if (const auto* sum = std::get_if<SumFlow>(&flow)) {
    for (const BackgroundFlow& term : sum->terms) velocity += uniform_part(term);
  }
  return velocity;
}

// Returns whether a body under a force would move against this force if the body were alone. Bodies
// smaller than the gauge length do not.
bool moves_against_its_force(const Component& body, const StokesProblem& problem) {
  if (body.kind != ComponentKind::free_body || body.force == 0.0) return false;
  constexpr double rounding = 1e-9;
  return outer_radius(body.curve, body.centre) > *problem.gauge_length &&
         least_mobility(body, problem) < -rounding;
}

}  // namespace

std::string separation_error(double separation, const Configuration& start,
                             const Discretisation& discretisation) {
  // These limits were measured on pairs of disks that are pressed together. A gap of 1e-8 radii is
  // maintained to a part in 1e8, with polygons of 70 MB; at a gap of 1e-9 radii, steps do not end.
  // Gaps of 1e-10 times the distance from the origin are maintained to 1e-5 of themselves; at 1e-11
  // steps are halved, and at 1e-12 gaps have errors of 3e-5.
  constexpr double least_in_radii = 1e-8, least_in_distances = 1e-10;
  double radius = 0.0, distance = 0.0;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    const double own = outer_radius(discretisation[k]->curve, 0.0);
    radius = std::max(radius, own);
    distance = std::max(distance, std::abs(start[k].position) + own);
  }
  const double least = std::max(least_in_radii * radius, least_in_distances * distance);
  if (separation == 0.0 || !(separation < least)) return {};
  return "contact.minimum_separation gives a separation of " + short_number(separation) +
         ", too small for the radius " + short_number(radius) + " and the distance " +
         short_number(distance) + " from the origin: set at least " + short_number(least);
}

double available_memory() {
  const double machine =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(machine, static_cast<double>(limit.rlim_cur)) : machine;
}

std::string memory_error(const Scene& scene, const Resolutions& resolutions, double available) {
  // Components with fewer nodes are not counted: their matrices are small, and the search for other
  // components of the same shape would not pay.
  constexpr int few_nodes = 128;
  std::vector<std::size_t> distinct;  // components, one per node number and shape
  double bytes = 0.0;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    const int nodes = resolutions[k].n_nodes;
    const bool is_counted = std::ranges::any_of(distinct, [&](std::size_t other) {
      return resolutions[other].n_nodes == nodes &&
             component_of(scene, other).shape == component_of(scene, k).shape;
    });
    if (nodes < few_nodes || is_counted) continue;
    distinct.push_back(k);
    bytes += memory_of_discretised_shape(nodes);
  }
  if (bytes <= available) return {};
  const auto largest = std::ranges::max_element(resolutions, {}, &Resolution::n_nodes);
  const auto component = static_cast<std::size_t>(largest - resolutions.begin());
  return name_of(scene, component) + " has " + std::to_string(largest->n_nodes) +
         " nodes, whose matrices take " + gigabytes(memory_of_discretised_shape(largest->n_nodes)) +
         ", and those of all shapes " + gigabytes(bytes) + ", but only " + gigabytes(available) +
         " are available: reduce n_nodes, or raise " + tolerance_of(scene);
}

std::string limit_error(const Scene& scene, const Resolutions& resolutions,
                        const std::vector<Gap>& gaps) {
  // An application of the operator to so many nodes takes some seconds on one core, and a solve
  // takes some 2 GB.
  constexpr int most_nodes_in_all = 1 << 20;
  long long all = 0;
  bool has_automatic_nodes = false;
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    const int nodes = resolutions[k].n_nodes;
    all += nodes;
    if (!component_of(scene, k).has_automatic_nodes()) continue;
    has_automatic_nodes = true;
    if (nodes <= most_nodes_of_a_component) continue;
    return name_of(scene, k) + nearest_neighbour(scene, k, gaps) +
           " would need n_nodes = " + std::to_string(nodes) + " for " + tolerance_of(scene) +
           "; the limit of \"auto\" is " + std::to_string(most_nodes_of_a_component) +
           " for a component: set n_nodes, or raise the tolerance";
  }
  if (has_automatic_nodes && all > most_nodes_in_all) {
    return "the components would need " + std::to_string(all) + " nodes in all for " +
           tolerance_of(scene) + "; the limit of \"auto\" is " + std::to_string(most_nodes_in_all) +
           " in all: set n_nodes, or raise the tolerance";
  }
  return memory_error(scene, resolutions, available_memory());
}

std::string overlap_error(const Scene& scene, const std::vector<Gap>& gaps,
                          const Configuration& configuration) {
  if (gaps.empty()) return {};
  const Gap& gap = gaps.front();
  const Complex point = gap.points.point_a;
  // Curves touch if their distance is at most the rounding error of their positions.
  const double size = std::abs(point) + std::abs(point - configuration[gap.a].position);
  if (!(gap.points.gap <= 1e-14 * size)) return {};
  if (gap.a == gap.b) {
    const Curve curve = sample(component_of(scene, gap.a).shape, 256, Side::fluid_outside);
    return name_of(scene, gap) + " overlap or touch: the image is moved by the lattice vector (" +
           short_number(gap.shift.real()) + ", " + short_number(gap.shift.imag()) +
           "), and the bounding circle of the body has a diameter of " +
           short_number(2.0 * bounding_radius(curve, 0.0)) +
           ": enlarge the cell, or turn or reduce the body";
  }
  return name_of(scene, gap) + " overlap, touch or lie on the wrong side of each other, by about " +
         short_number(-gap.points.gap) + " near (" + short_number(point.real()) + ", " +
         short_number(point.imag()) +
         "): move them apart, or take smaller steps if this happened during a run";
}

std::string geometry_error(const Scene& scene, const std::vector<Gap>& gaps,
                           const Configuration& configuration,
                           const Discretisation& discretisation) {
  // No solve is attempted if the error estimate of a shape or gap, made before the solve, exceeds
  // this bound. On 45 random scenes such estimates were up to 1200 times the error.
  const double largest_error = 1e4 * scene.solver.tolerance;
  for (std::size_t k = 0; k < discretisation.size(); ++k) {
    if (discretisation[k]->shape_residual > largest_error) {
      return shape_message(scene, k, *discretisation[k]);
    }
  }
  for (const Gap& gap : gaps) {
    const GapResolution resolution = gap_resolution(gap, configuration, discretisation);
    if (resolution.error > largest_error) return gap_message(scene, gap, resolution);
    if (scene.solver.near_singular == NearSingular::off) {
      const std::string message = plain_rule_message(scene, gap, configuration, discretisation);
      if (!message.empty()) return message;
    }
  }
  return {};
}

std::string data_error(const Scene& scene, const StokesProblem& problem) {
  // Interpolated data conserve volume up to the error of the interpolation only.
  constexpr double flux_of_data = 1e-3;
  const double allowed = has_velocity_data(scene) ? std::max(flux_of_data, scene.solver.tolerance)
                                                  : scene.solver.tolerance;
  const auto forbidden_flux = [&](const StokesProblem& part) {
    const double flux = net_flux(part);
    return std::abs(flux) <= allowed * flux_scale(part) ? 0.0 : flux;
  };
  for (std::size_t k = 0; k < problem.components.size(); ++k) {
    if (!has_slip(problem.components[k])) continue;
    const double flux = forbidden_flux({{problem.components[k]}, problem.viscosity, {}, {}});
    if (flux == 0.0) continue;
    return "the slip on " + name_of(scene, k) + " has a net flux of " + short_number(flux) +
           " into the body, whose area is constant: change the data so that the net flux is zero";
  }
  if (is_bounded(problem)) {
    const double flux = forbidden_flux(problem);
    if (flux == 0.0) return {};
    return "the walls' velocities drive a net flux of " + short_number(flux) +
           " out of the enclosed fluid, which is incompressible: change the velocities so that the "
           "net flux is zero";
  }
  if (problem.cell) return {};
  if (uniform_part(scene.flow) != 0.0 && has_free_uniform_velocity(problem)) {
    return "flow.kind = \"uniform\" has no effect beside a held body or inner wall without "
           "flow.gauge_length: the velocity at infinity follows from zero net force and cancels "
           "the uniform flow; set flow.gauge_length";
  }
  const double extent = prescribed_extent(problem);
  if (scene.gauge_length && extent > 0.5 * *scene.gauge_length) {
    return "flow.gauge_length = " + short_number(*scene.gauge_length) +
           " is not large against the held components, which reach " + short_number(extent) +
           " from their centre: near that size the problem is singular (Stokes' paradox); set at "
           "least " +
           short_number(2.0 * extent) + ", or leave it out for zero net force";
  }
  for (std::size_t k = 0; scene.gauge_length && k < problem.components.size(); ++k) {
    if (!moves_against_its_force(problem.components[k], problem)) continue;
    return name_of(scene, k) + " would move against its force with flow.gauge_length = " +
           short_number(*scene.gauge_length) +
           ", which must be large compared with the bodies (Stokes' paradox); set at least " +
           short_number(2.0 *
                        outer_radius(problem.components[k].curve, problem.components[k].centre));
  }
  if (extent == 0.0 && !scene.gauge_length && has_net_force(problem)) {
    const Complex force = total_given_force(problem);
    return "the loads have a net force of (" + short_number(force.real()) + ", " +
           short_number(force.imag()) +
           ") in an unbounded plane, where velocities grow like the logarithm of the distance "
           "(Stokes' paradox): balance the forces, enclose the fluid, or give flow.gauge_length";
  }
  return {};
}

std::string accuracy_error(const Scene& scene, const Resolutions& resolutions,
                           const Resolutions& least, const std::vector<TailEstimate>& tails,
                           double error, const std::vector<Gap>& gaps) {
  const double tolerance = scene.solver.tolerance;
  if (!std::isfinite(error)) {
    return "the error of the velocities cannot be estimated, because the effect of more nodes is "
           "below rounding: move the closest bodies apart, or raise " +
           tolerance_of(scene);
  }
  const std::string estimate =
      "estimated error " + short_number(error) + " of the velocities, " + tolerance_of(scene);
  for (std::size_t k = 0; k < resolutions.size(); ++k) {
    if (resolutions[k].n_nodes >= least[k].n_nodes) continue;
    return name_of(scene, k) + " is slender or lobed, and " +
           std::to_string(resolutions[k].n_nodes) +
           " nodes do not resolve its densities: " + estimate + "; set n_nodes to at least " +
           std::to_string(least[k].n_nodes);
  }
  const auto worst = std::ranges::max_element(tails, {}, &TailEstimate::error);
  if (worst->error < tolerance) {
    return estimate +
           ": the nodes resolve the densities, and the error is due to rounding or GMRES; lower "
           "solver.gmres_tol if it is given, or raise solver.tolerance";
  }
  const auto component = static_cast<std::size_t>(worst - tails.begin());
  const int nodes = resolutions[component].n_nodes;
  const int advice = rounded_nodes(extrapolated_nodes(nodes, worst->decay, error / tolerance));
  return "the density on " + name_of(scene, component) + " is not resolved" +
         nearest_neighbour(scene, component, gaps) + ": " + estimate + " with its " +
         std::to_string(nodes) + " nodes; set n_nodes = " + std::to_string(advice);
}

}  // namespace stokesbook
