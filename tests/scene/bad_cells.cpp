// Tests every error in [cell], with the whole message of each.

#include <string>

#include "bad_scene.hpp"

using namespace stokesbook::test;

namespace {

// Returns a scene with a cell in its first two lines.
std::string cell(const std::string& more = {}) {
  return "[cell]\nvectors = [[2, 0], [1, 3]]\n" + more;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bad_cells)

BOOST_AUTO_TEST_CASE(keys) {
  check({
      {"[cell]\n" + disk(),
       "s.toml:1:1: cell.vectors is missing: must be two vectors [[a, b], [c, d]] that are neither "
       "zero nor parallel"},
      {"[cell]\nvectors = [[1, 2], [-2, -4]]\n" + disk(),
       "s.toml:2:11: cell.vectors = [[1, 2], [-2, -4]]: must be two vectors [[a, b], [c, d]] that "
       "are neither zero nor parallel"},
      {"[cell]\nvectors = [[1, 2], [0, 0]]\n" + disk(),
       "s.toml:2:11: cell.vectors = [[1, 2], [0, 0]]: must be two vectors [[a, b], [c, d]] that "
       "are neither zero nor parallel"},
      {cell("origin = [0, 0]\n") + disk(),
       "s.toml:3:1: cell.origin = [0, 0]: unknown key; valid keys: vectors, mean_velocity, "
       "pressure_gradient"},
      {cell("mean_velocity = 1\n") + disk(),
       "s.toml:3:17: cell.mean_velocity = 1: must be two numbers [x, y], not an integer"},
      {cell("mean_velocity = [0, 0]\npressure_gradient = [1, 0]\n") + disk(),
       "s.toml:3:1: cell.mean_velocity = [0, 0]: give mean_velocity or pressure_gradient, not "
       "both"},
      {cell("pressure_gradient = [1, 0]\n") + disk(),
       "s.toml:3:1: cell.pressure_gradient = [1, 0]: requires a body with held = true: without "
       "one, the forces on free bodies determine the gradient"},
  });
}

BOOST_AUTO_TEST_CASE(excluded_sections) {
  check({
      {cell() + disk() + "[[walls]]\nrole = 'inner'\nshape = { kind = 'circle', radius = 1 }\n" +
           "n_nodes = 32\n",
       "s.toml:6:3: walls = [{...}]: not allowed with [cell]: walls do not move with the lattice; "
       "a body with held = true is an obstacle that repeats"},
      {cell() + "[[fill]]\nshape = { kind = 'circle', radius = 0.1 }\ncount = 3\n" +
           "n_nodes = 32\nregion = 'fluid'\n",
       "s.toml:7:1: fill[0].region = \"fluid\": not allowed with [cell]: a fill takes the whole "
       "cell"},
  });
}

BOOST_AUTO_TEST_CASE(flows_and_solvers) {
  check({
      {cell() + disk() + "[flow]\ngauge_length = 9\n",
       "s.toml:7:1: flow.gauge_length = 9: not allowed with [cell], whose Stokeslets have the mean "
       "zero and no gauge"},
      {cell() + disk() + "[flow]\nkind = 'extensional'\nrate = 1\n",
       "s.toml:7:1: flow.kind = \"extensional\": must be one of quiescent, shear, linear with "
       "[cell]: other flows do not repeat; cell.mean_velocity is a uniform flow"},
      {cell() + disk() + "[flow]\namplitude = { kind = 'constant' }\n",
       "s.toml:7:1: flow.amplitude: has no effect: give kind, or remove it"},
      {cell() + disk() + "[flow]\nkind = 'linear'\ngradient = [[1, 0], [0, -1]]\n" +
           "[time]\nt_final = 1\n",
       "s.toml:8:1: flow.gradient = [[1, 0], [0, -1]]: draws the lattice of [cell] out until "
       "bodies meet their images: remove [time], or give a determinant >= 0"},
      {cell() + disk() + "[solver]\nsummation = 'direct'\n",
       "s.toml:7:1: solver.summation = \"direct\": not allowed with [cell], whose images the "
       "direct "
       "sum lacks"},
      {cell() + disk() + "[solver]\npreconditioner = 'clusters'\n",
       "s.toml:7:1: solver.preconditioner = \"clusters\": not supported in a periodic cell yet"},
      {cell() + disk() + "[solver]\npreconditioner = 'hierarchical'\n",
       "s.toml:7:1: solver.preconditioner = \"hierarchical\": not supported in a periodic cell "
       "yet"},
      {cell() + disk() + "[solver]\ncoupling = 'local'\n",
       "s.toml:7:1: solver.coupling = \"local\": not supported in a periodic cell yet"},
  });
  // Rotations and shears keep the lattice from being drawn out; so does a single solve.
  for (const std::string gradient : {"[[0, 1], [-1, 0]]", "[[1, 1], [-1, -1]]"}) {
    BOOST_TEST(error_of(cell() + disk() + "[flow]\nkind = 'linear'\ngradient = " + gradient +
                        "\n[time]\nt_final = 1\n") == "no error");
  }
  BOOST_TEST(error_of(cell() + disk() +
                      "[flow]\nkind = 'linear'\ngradient = [[1, 0], [0, -1]]\n") == "no error");
}

BOOST_AUTO_TEST_SUITE_END()
