#pragma once

#include <vector>

#include "suspension/motion/simulation.hpp"

namespace stokesbook::test {

/// Runs a scene in memory and returns its written frames.
inline std::vector<Frame> frames_of(const Scene& scene) {
  const SuspensionSolver solver(scene);
  std::vector<Frame> frames;
  Observer observer;
  observer.frame = [&](const Frame& frame) { frames.push_back(frame); };
  Simulation(solver, observer).run();
  return frames;
}

/// Returns a body at rest, without a load.
inline Body body_at(const Shape& shape, Complex position, int n_nodes) {
  Body body;
  body.shape = shape;
  body.position = position;
  body.n_nodes = n_nodes;
  return body;
}

}  // namespace stokesbook::test
