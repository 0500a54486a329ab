// Defines problems that the solver must refuse with a message that states the reason and the
// remedy.
#include <cmath>

#include "hard_case.hpp"
#include "scene/parse.hpp"
#include "support/recorded_run.hpp"

namespace stokesbook::verification::hard_cases {

namespace {

Finding refused(const Scene& scene) {
  return solve(scene, [](const Solution&) { return unknown; });
}

Scene in_container(const Body& body) {
  Scene cell = scene(QuiescentFlow{}, {body}, 1e-6);
  cell.walls = {{.role = WallRole::outer, .shape = Circle{5.0}, .n_nodes = 64}};
  return cell;
}

Finding read(const std::string& text) {
  try {
    parse_scene(text, "scene.toml", ".");
    return {};
  } catch (const SceneError& error) {
    return {.refusal = error.what()};
  }
}

Scene few_iterations() {
  Scene pair = circles_in_extension(1e-3, 1e-6);
  pair.solver.preconditioner = PreconditionerKind::none;
  pair.solver.gmres_max_iterations = 3;
  return pair;
}

Scene degenerate_held_disk() {
  Body disk = body(Circle{1.0}, 0.0);
  disk.held = true;
  disk.velocity = 1.0;
  Scene alone = scene(QuiescentFlow{}, {disk}, 1e-6);
  alone.gauge_length = std::exp(-0.5);
  return alone;
}

Scene pushed_without_gauge() {
  Body disk = body(Circle{1.0}, 0.0);
  disk.force = 1.0;
  return scene(QuiescentFlow{}, {disk}, 1e-6);
}

Scene leaking_walls() {
  Scene cell = in_container(body(Circle{0.5}, {3.0, 0.0}));
  cell.walls.push_back({.role = WallRole::inner, .shape = Circle{1.0}, .motion = RadialWall{0.5}});
  return cell;
}

}  // namespace

std::vector<HardCase> refusals() {
  const auto solving = [](const std::string& chapter, const std::string& asked, const Scene& scene,
                          const std::vector<std::string>& words) {
    return HardCase{chapter, asked, [=] { return refused(scene); }, Due::refusal, words};
  };
  const auto reading = [](const std::string& asked, const std::string& text,
                          const std::vector<std::string>& words) {
    return HardCase{"12", asked, [=] { return read(text); }, Due::refusal, words};
  };
  Scene plain = test::with_nodes(circles_in_extension(0.5, 1e-8), 48);
  plain.solver.near_singular = NearSingular::off;
  return {
      solving("12", "bodies that overlap at the start", circles_in_extension(-0.1, 1e-6),
              {"body 0 and body 1", "overlap"}),
      solving("12", "bodies that touch at the start", circles_in_extension(0.0, 1e-6),
              {"body 0 and body 1", "overlap"}),
      solving("12", "a body outside of its container", in_container(body(Circle{1.0}, 7.0)),
              {"body 0 and wall 0", "overlap"}),
      solving("12", "a gap of 0.01 on 64 nodes",
              test::with_nodes(circles_in_extension(0.01, 1e-8), 64),
              {"body 0 and body 1", "n_nodes"}),
      solving("12", "an ellipse 10:1 on 16 nodes",
              test::with_nodes(scene(ShearFlow{1.0}, {body(Ellipse{10.0, 1.0}, 0.0)}, 1e-8), 16),
              {"body 0", "16 nodes", "n_nodes"}),
      solving("06", "close bodies without near correction", plain, {"near_singular"}),
      solving("05", "three iterations of GMRES where more are needed", few_iterations(),
              {"GMRES", "3 iterations", "gmres_max_iterations"}),
      solving("03", "a held disk whose gauge length is degenerate", degenerate_held_disk(),
              {"gauge_length"}),
      solving("03", "a net force in an unbounded fluid without gauge length",
              pushed_without_gauge(), {"net force", "gauge_length"}),
      solving("04", "a wall that lets fluid into a closed container", leaking_walls(),
              {"net flux"}),
      reading("a viscosity that is not a number", "[fluid]\nviscosity = nan\n",
              {"scene.toml:2", "viscosity", "nan"}),
      reading("a negative radius",
              "[[bodies]]\nshape = { kind = \"circle\", radius = -1.0 }\nn_nodes = 32\n",
              {"scene.toml:2", "radius", "-1"}),
      reading("a key that does not exist", "[fluid]\nviscosty = 1.0\n",
              {"scene.toml:2", "viscosty", "viscosity"}),
  };
}

}  // namespace stokesbook::verification::hard_cases
