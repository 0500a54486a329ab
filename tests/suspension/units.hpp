#pragma once

#include <stdexcept>
#include <variant>

#include "scenes.hpp"

namespace stokesbook::test {

/// Units in which a scene and its solution are rewritten, by the scaling laws of Stokes flow.
struct Units {
  double length = 1.0, viscosity = 1.0, rate = 1.0;

  double velocity() const { return length * rate; }
  double force() const { return viscosity * velocity(); }
  double torque() const { return force() * length; }
};

inline const std::vector<Units> all_units{{1, 1, 1},     {1e-3, 1, 1},     {1e3, 1, 1},
                                          {1, 1.3, 2.5}, {1e-3, 1.3, 2.5}, {1e3, 1.3, 2.5}};

/// Units of one, and a system in which all three units differ from one.
inline const std::vector<Units> two_units{{1, 1, 1}, {1e-3, 1.3, 2.5}};

inline Shape in_units(const Shape& shape, const Units& units) {
  struct Scaled {
    double length;
    Shape operator()(const Circle& s) const { return Circle{length * s.radius}; }
    Shape operator()(const Ellipse& s) const { return Ellipse{length * s.a, length * s.b}; }
    Shape operator()(const Star& s) const { return Star{length * s.radius, s.amplitude, s.arms}; }
    Shape operator()(const Superellipse& s) const {
      return Superellipse{length * s.a, length * s.b, s.power};
    }
    Shape operator()(const NodalCurve& s) const { return NodalCurve{length * s.points, s.file}; }
  };
  return std::visit(Scaled{units.length}, shape);
}

inline BackgroundFlow in_units(const BackgroundFlow& flow, const Units& units) {
  struct Scaled {
    Units units;
    BackgroundFlow operator()(const QuiescentFlow& f) const { return f; }
    BackgroundFlow operator()(const UniformFlow& f) const {
      return UniformFlow{units.velocity() * f.velocity};
    }
    BackgroundFlow operator()(const ShearFlow& f) const {
      return ShearFlow{units.rate * f.rate, units.length * f.centre};
    }
    BackgroundFlow operator()(const ExtensionalFlow& f) const {
      return ExtensionalFlow{units.rate * f.rate, units.length * f.centre};
    }
    BackgroundFlow operator()(const LinearFlow& f) const {
      return LinearFlow{units.rate * f.gradient, units.length * f.centre};
    }
    BackgroundFlow operator()(const SumFlow& f) const {
      SumFlow sum;
      for (const BackgroundFlow& term : f.terms) sum.terms.push_back(in_units(term, units));
      return sum;
    }
    BackgroundFlow operator()(const TaylorGreenFlow&) const {
      throw std::logic_error("the Taylor-Green flow has a length of its own");
    }
  };
  return std::visit(Scaled{units}, flow);
}

inline VelocityData in_units(VelocityData data, const Units& units) {
  for (auto& [variable, u, v] : data.rows) {
    u *= units.velocity();
    v *= units.velocity();
  }
  return data;
}

inline Slip in_units(const Slip& slip, const Units& units) {
  struct Scaled {
    Units units;
    Slip operator()(Squirmer squirmer) const {
      for (double& mode : squirmer.modes) mode *= units.velocity();
      return squirmer;
    }
    Slip operator()(const VelocityData& data) const { return in_units(data, units); }
  };
  return std::visit(Scaled{units}, slip);
}

inline WallMotion in_units(const WallMotion& motion, const Units& units) {
  struct Scaled {
    Units units;
    WallMotion operator()(const FixedWall& m) const { return m; }
    WallMotion operator()(const RotatingWall& m) const {
      return RotatingWall{units.rate * m.omega};
    }
    WallMotion operator()(const TranslatingWall& m) const {
      return TranslatingWall{units.velocity() * m.velocity};
    }
    WallMotion operator()(const LinearWall& m) const { return LinearWall{units.rate * m.gradient}; }
    WallMotion operator()(const RadialWall& m) const {
      return RadialWall{units.velocity() * m.speed};
    }
    WallMotion operator()(const ParabolicWall& m) const {
      return ParabolicWall{units.velocity() * m.speed};
    }
    WallMotion operator()(const VelocityData& m) const { return in_units(m, units); }
  };
  return std::visit(Scaled{units}, motion);
}

inline Scene in_units(Scene scene, const Units& units) {
  scene.viscosity *= units.viscosity;
  scene.flow = in_units(scene.flow, units);
  if (scene.gauge_length) *scene.gauge_length *= units.length;
  for (Body& body : scene.bodies) {
    body.shape = in_units(body.shape, units);
    body.position *= units.length;
    body.force *= units.force();
    body.torque *= units.torque();
    body.velocity *= units.velocity();
    body.omega *= units.rate;
    if (body.slip) body.slip = in_units(*body.slip, units);
  }
  for (Wall& wall : scene.walls) {
    wall.shape = in_units(wall.shape, units);
    wall.position *= units.length;
    wall.motion = in_units(wall.motion, units);
  }
  return scene;
}

inline RigidMotion in_units(const RigidMotion& motion, const Units& units) {
  return {units.velocity() * motion.velocity, units.rate * motion.omega};
}

inline Load in_units(const Load& load, const Units& units) {
  return {units.force() * load.force, units.torque() * load.torque};
}

}  // namespace stokesbook::test
