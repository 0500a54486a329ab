// Computes what drives the flow at a time: the factors of the background flow and of the prescribed
// motions, and the loads on free bodies, which may depend on their places (chapter 12).
#include "suspension/bodies/forcing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "suspension/bodies/components.hpp"

namespace stokesbook {

using Eigen::Index;

namespace {

using std::numbers::pi;

// Beyond so many ranges, a repulsion is less than the rounding error of its strength.
constexpr double longest_repulsion = 40.0;

// Returns 1, or -1 after an odd number of reversals.
double reversal_sign(const Scene& scene, double t) {
  const auto passed = std::ranges::upper_bound(scene.reverse_at, t) - scene.reverse_at.begin();
  return passed % 2 == 0 ? 1.0 : -1.0;
}

// Evaluates an amplitude at a time.
struct AmplitudeAt {
  StepTime time;

  double operator()(const ConstantAmplitude&) const { return 1.0; }
  double operator()(const SteppedAmplitude& steps) const {
    const auto next = std::ranges::upper_bound(steps.times, time.begin);
    const auto passed = static_cast<std::size_t>(next - steps.times.begin());
    return steps.values[std::max<std::size_t>(passed, 1) - 1];
  }
  double operator()(const RampedAmplitude& ramp) const {
    const auto next = std::ranges::upper_bound(ramp.times, time.t);
    if (next == ramp.times.begin()) return ramp.values.front();
    if (next == ramp.times.end()) return ramp.values.back();
    const auto k = static_cast<std::size_t>(next - ramp.times.begin());
    const double begin = ramp.times[k - 1];
    return std::lerp(ramp.values[k - 1], ramp.values[k], (time.t - begin) / (*next - begin));
  }
  double operator()(const OscillatingAmplitude& oscillation) const {
    const auto& [mean, swing, period, phase] = oscillation;
    return mean + swing * std::cos(2.0 * pi * time.t / period + phase);
  }
};

double value(const Amplitude& amplitude, const StepTime& time) {
  return std::visit(AmplitudeAt{time}, amplitude);
}

// Integrates an amplitude over time, from 0 to t.
struct AmplitudeIntegral {
  double t;

  double operator()(const ConstantAmplitude&) const { return t; }
  double operator()(const SteppedAmplitude& steps) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < steps.times.size() && steps.times[k] < t; ++k) {
      const double end = k + 1 < steps.times.size() ? std::min(t, steps.times[k + 1]) : t;
      sum += steps.values[k] * (end - steps.times[k]);
    }
    return sum;
  }
  double operator()(const RampedAmplitude& ramp) const {
    // The ramp is linear between these times.
    std::vector<double> times{0.0};
    for (const double time : ramp.times) times.push_back(std::min(time, t));
    times.push_back(t);
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      const double middle = 0.5 * (times[k] + times[k + 1]);
      sum += (times[k + 1] - times[k]) * AmplitudeAt{{middle, middle}}(ramp);
    }
    return sum;
  }
  double operator()(const OscillatingAmplitude& oscillation) const {
    const auto& [mean, swing, period, phase] = oscillation;
    const double rate = 2.0 * pi / period;
    return mean * t + swing / rate * (std::sin(rate * t + phase) - std::sin(phase));
  }
};

// Collects the amplitudes of flow, motions and loads.
std::vector<const Amplitude*> amplitudes_of(const Scene& scene) {
  std::vector<const Amplitude*> amplitudes{&scene.flow_amplitude};
  for (const Wall& wall : scene.walls) amplitudes.push_back(&wall.amplitude);
  for (const Body& body : scene.bodies) amplitudes.push_back(&body.loads.amplitude);
  if (scene.gravity) amplitudes.push_back(&scene.gravity->amplitude);
  if (scene.magnetic_field) amplitudes.push_back(&scene.magnetic_field->amplitude);
  return amplitudes;
}

// Adds a force that acts at an offset from the position of a body.
void add(Load& load, Complex force, Complex offset) {
  load.force += force;
  load.torque += cross(offset, force);
}

// Adds the repulsion to both components of each pair: forces and torques of the two are equal and
// opposite. In a periodic cell, the force on an image of b acts on b.
void add_repulsion(std::vector<Load>& loads, const Scene& scene,
                   const Discretisation& discretisation, const Instant& instant) {
  for (const auto& [gap, force] : repelled_pairs(scene, discretisation, instant)) {
    const auto& [a, b, closest, shift] = gap;
    const auto act = [&](std::size_t k, Complex own, Complex point) {
      if (component_of(scene, k).kind != ComponentKind::free_body) return;
      add(loads[k], own, point - instant.configuration[k].position);
    };
    act(a, -force, closest.point_a);
    act(b, force, closest.point_b - shift);
  }
}

// Computes the part of the forcing that changes its sign at reversals.
Forcing reversible_forcing(const Scene& scene, const Discretisation& discretisation,
                           const StepTime& time, const Instant& instant) {
  Forcing forcing{value(scene.flow_amplitude, time), {}, {}};
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    const double factor = value(body.loads.amplitude, time);
    forcing.motions.push_back(factor);
    Load& load = forcing.loads.emplace_back(Load{factor * body.force, factor * body.torque});
    if (!scene.gravity || !body.loads.density) continue;
    // Weight minus buoyancy, (rho_k - rho) A g, acts at the centroid of the area A.
    const Curve& curve = discretisation[k]->curve;
    const Complex acceleration =
        value(scene.gravity->amplitude, time) * scene.gravity->acceleration;
    add(load, (*body.loads.density - scene.gravity->fluid_density) * area(curve) * acceleration,
        std::polar(1.0, instant.configuration[k].orientation) * area_centroid(curve));
  }
  for (const Wall& wall : scene.walls) forcing.motions.push_back(value(wall.amplitude, time));
  return forcing;
}

}  // namespace

Complex area_centroid(const Curve& curve) {
  const double h = 2.0 * pi / static_cast<double>(curve.size());
  // Green's theorem gives int f dA = 1/(2i) oint F dz for f = dF / d conj(z).
  Complex area{}, moment{};
  for (Index j = 0; j < curve.size(); ++j) {
    area += std::conj(curve.x[j]) * curve.dx[j];
    moment += curve.x[j] * std::conj(curve.x[j]) * curve.dx[j];
  }
  return (h / (2.0 * imaginary) * moment) / (h / (2.0 * imaginary) * area);
}

Forcing scaled(double factor, Forcing forcing) {
  forcing.flow *= factor;
  for (double& motion : forcing.motions) motion *= factor;
  for (auto& [force, torque] : forcing.loads) {
    force *= factor;
    torque *= factor;
  }
  return forcing;
}

std::vector<RepelledPair> repelled_pairs(const Scene& scene, const Discretisation& discretisation,
                                         const Instant& instant) {
  std::vector<RepelledPair> pairs;
  if (!scene.repulsion) return pairs;
  const auto [strength, range] = *scene.repulsion;
  for (const Gap& gap : gaps_within(instant.configuration, discretisation,
                                    longest_repulsion * range, instant.cell)) {
    const Complex apart = gap.points.point_b - gap.points.point_a;
    if (apart == 0.0) continue;  // curves that touch are refused
    const double force = strength * std::exp(-gap.points.gap / range);
    pairs.push_back({gap, force * apart / std::abs(apart)});
  }
  return pairs;
}

Forcing forcing_at(const Scene& scene, const Discretisation& discretisation, const StepTime& time,
                   const Instant& instant) {
  Forcing forcing = scaled(reversal_sign(scene, time.begin),
                           reversible_forcing(scene, discretisation, time, instant));
  Complex field{};
  if (scene.magnetic_field) {
    const auto& [at_start, frequency, amplitude] = *scene.magnetic_field;
    field = value(amplitude, time) * at_start * std::polar(1.0, 2.0 * pi * frequency * time.t);
  }
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const auto& [amplitude, density, trap, moment] = scene.bodies[k].loads;
    Load& load = forcing.loads[k];
    if (trap) {
      load.force += trap->stiffness *
                    (trap->centre.value_or(scene.bodies[k].position) - instant.path_position(k));
    }
    // The torque m x B, where the moment m turns with the body, and the field B on its own.
    const double orientation = instant.configuration[k].orientation;
    if (moment != 0.0) load.torque += cross(std::polar(1.0, orientation) * moment, field);
  }
  if (scene.repulsion) add_repulsion(forcing.loads, scene, discretisation, instant);
  return forcing;
}

double flow_time(const Scene& scene, double t) {
  // The flow changes its sign at each reversal.
  double sum = 0.0, sign = 1.0, begin = 0.0;
  const auto add_until = [&](double end) {
    const double before = std::visit(AmplitudeIntegral{begin}, scene.flow_amplitude);
    sum += sign * (std::visit(AmplitudeIntegral{end}, scene.flow_amplitude) - before);
    begin = end;
    sign = -sign;
  };
  for (const double reversal : scene.reverse_at) {
    if (reversal < t) add_until(reversal);
  }
  add_until(t);
  return sum;
}

std::vector<double> forcing_events(const Scene& scene) {
  std::vector<double> events = scene.reverse_at;
  const auto add_times = [&](const auto& amplitude) {
    if constexpr (requires { amplitude.times; }) {
      std::ranges::copy_if(amplitude.times, std::back_inserter(events),
                           [](double t) { return t > 0.0; });
    }
  };
  for (const Amplitude* amplitude : amplitudes_of(scene)) std::visit(add_times, *amplitude);
  std::ranges::sort(events);
  events.erase(std::unique(events.begin(), events.end()), events.end());
  return events;
}

double shortest_period(const Scene& scene) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Amplitude* amplitude : amplitudes_of(scene)) {
    if (const auto* oscillation = std::get_if<OscillatingAmplitude>(amplitude)) {
      shortest = std::min(shortest, oscillation->period);
    }
  }
  if (scene.magnetic_field && scene.magnetic_field->frequency != 0.0) {
    shortest = std::min(shortest, 1.0 / std::abs(scene.magnetic_field->frequency));
  }
  return shortest;
}

}  // namespace stokesbook
