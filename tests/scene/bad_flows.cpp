// Tests every error in [flow], with the whole message of each.

#include <string>

#include "bad_scene.hpp"

using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(bad_flows)

BOOST_AUTO_TEST_CASE(flow) {
  check({
      {"[flow]\nkind = 'sheer'\n",
       "s.toml:2:8: flow.kind = \"sheer\": must be one of quiescent, uniform, shear, extensional, "
       "taylor_green, linear, sum"},
      {"[flow]\nkind = 1\n",
       "s.toml:2:8: flow.kind = 1: must be one of quiescent, uniform, shear, extensional, "
       "taylor_green, linear, sum, not an integer"},
      {"[flow]\nkind = 'shear'\n", "s.toml:1:1: flow.rate is missing: must be a number"},
      {"[flow]\nkind = 'extensional'\n", "s.toml:1:1: flow.rate is missing: must be a number"},
      {"[flow]\nkind = 'taylor_green'\nrate = 'fast'\n",
       "s.toml:3:8: flow.rate = \"fast\": must be a number, not a string"},
      {"[flow]\nkind = 'uniform'\nrate = 1\n",
       "s.toml:3:1: flow.rate = 1: unknown key; valid keys: kind, velocity, amplitude, "
       "gauge_length, reverse_at"},
      {"[flow]\nkind = 'uniform'\n",
       "s.toml:1:1: flow.velocity is missing: must be two numbers [x, y]"},
      {"[flow]\nkind = 'uniform'\nvelocity = 1\n",
       "s.toml:3:12: flow.velocity = 1: must be two numbers [x, y], not an integer"},
      {"[flow]\nkind = 'uniform'\nvelocity = [1]\n",
       "s.toml:3:12: flow.velocity = [1]: must be two numbers [x, y], not an array of 1"},
      {"[flow]\nkind = 'uniform'\nvelocity = [1, true]\n",
       "s.toml:3:16: flow.velocity[1] = true: must be a number, not a boolean"},
      {"[flow]\nkind = 'uniform'\nvelocity = [1, inf]\n",
       "s.toml:3:16: flow.velocity[1] = inf: must be a number, and finite"},
      {"[flow]\nkind = 'shear'\nrate = 1e-200\n" + disk(),
       "s.toml:3:8: flow.rate = 1e-200: must be 0 or have a magnitude from 1e-100 to 1e100; change "
       "the units"},
      {"[flow]\nrate = 1\n",
       "s.toml:2:1: flow.rate = 1: unknown key; valid keys: kind, amplitude, gauge_length, "
       "reverse_at"},
      {"[flow]\nkind = 'shear'\nrate = 1\nvelocity = [1, 0]\n",
       "s.toml:4:1: flow.velocity = [1, 0]: unknown key; valid keys: kind, rate, centre, "
       "amplitude, gauge_length, reverse_at"},
      {"[flow]\nkind = 'shear'\nrate = 1\ncentre = 2\n",
       "s.toml:4:10: flow.centre = 2: must be two numbers [x, y], not an integer"},
      {"[flow]\nkind = 'uniform'\nvelocity = [1, 0]\ncentre = [1, 0]\n",
       "s.toml:4:1: flow.centre = [1, 0]: unknown key; valid keys: kind, velocity, amplitude, "
       "gauge_length, reverse_at"},
      {"[flow]\nkind = 'sum'\n",
       "s.toml:1:1: flow.terms is missing: must be a list of flows [{ kind = \"uniform\", ... }, "
       "...]"},
      {"[flow]\nkind = 'sum'\nterms = []\n",
       "s.toml:3:9: flow.terms = []: must be a list of flows [{ kind = \"uniform\", ... }, ...]"},
      {"[flow]\nkind = 'sum'\nterms = [1]\n",
       "s.toml:3:10: flow.terms[0] = 1: must be a table, not an integer"},
      {"[flow]\nkind = 'sum'\nterms = [{ rate = 1 }]\n",
       "s.toml:3:10: flow.terms[0].kind is missing: must be one of quiescent, uniform, shear, "
       "extensional, taylor_green, linear, sum"},
      {"[flow]\nkind = 'sum'\nterms = [{ kind = 'shear', rate = 1, reverse_at = [1] }]\n",
       "s.toml:3:38: flow.terms[0].reverse_at = [1]: unknown key; valid keys: kind, rate, centre"},
      {"[flow]\nkind = 'sum'\nterms = [{ kind = 'linear', gradient = [[1, 0], [0, 1]] }]\n",
       "s.toml:3:40: flow.terms[0].gradient = [[1, 0], [0, 1]]: must have trace 0, as the fluid is "
       "incompressible; its trace is 2"},
      {"[flow]\nkind = 'linear'\n",
       "s.toml:1:1: flow.gradient is missing: must be two rows of two numbers [[a, b], [c, d]]"},
      {"[flow]\nkind = 'linear'\ngradient = [[1, 0], [0, 1]]\n",
       "s.toml:3:12: flow.gradient = [[1, 0], [0, 1]]: must have trace 0, as the fluid is "
       "incompressible; its trace is 2"},
      {"[flow]\nkind = 'linear'\ngradient = [[1, 0], [0, -1.00000000001]]\n",
       "s.toml:3:12: flow.gradient = [[1, 0], [0, -1.00000000001]]: must have trace 0, as the "
       "fluid is incompressible; its trace is -1e-11"},
      {"[flow]\nkind = 'linear'\ngradient = [1, 0]\n",
       "s.toml:3:13: flow.gradient[0] = 1: must be a row of two numbers, not an integer"},
      {"[flow]\nkind = 'linear'\ngradient = [[1, 0, 0], [0, -1, 0]]\n",
       "s.toml:3:13: flow.gradient[0] = [1, 0, 0]: must be a row of two numbers, not an array of "
       "3"},
      {"[flow]\ngauge_length = 0\n", "s.toml:2:16: flow.gauge_length = 0: must be a number > 0"},
      {"[flow]\nreverse_at = 20\n",
       "s.toml:2:14: flow.reverse_at = 20: must be a list of ascending times > 0, not an integer"},
      {"[flow]\nreverse_at = [1, 1]\n",
       "s.toml:2:14: flow.reverse_at = [1, 1]: must be a list of ascending times > 0"},
      {"[flow]\nreverse_at = [2, 1]\n",
       "s.toml:2:14: flow.reverse_at = [2, 1]: must be a list of ascending times > 0"},
      {"[flow]\nreverse_at = [0, 1]\n",
       "s.toml:2:14: flow.reverse_at = [0, 1]: must be a list of ascending times > 0"},
      {"[flow]\nreverse_at = [1, 'later']\n",
       "s.toml:2:18: flow.reverse_at[1] = \"later\": must be a number, not a string"},
      {tank() + "[flow]\nkind = 'shear'\nrate = 1\n",
       "s.toml:6:1: flow.kind = \"shear\": not allowed with an outer wall, which drives the flow; "
       "only reverse_at is"},
      {tank() + "[flow]\nkind = 'quiescent'\n",
       "s.toml:6:1: flow.kind = \"quiescent\": not allowed with an outer wall, which drives the "
       "flow; only reverse_at is"},
      {tank() + "[flow]\nrate = 1\n",
       "s.toml:6:1: flow.rate = 1: not allowed with an outer wall, which drives the flow; only "
       "reverse_at is"},
      {tank() + "[flow]\nvelocity = [1, 0]\n",
       "s.toml:6:1: flow.velocity = [1, 0]: not allowed with an outer wall, which drives the flow; "
       "only reverse_at is"},
      {tank() + "[flow]\ngradient = [[0, 1], [0, 0]]\n",
       "s.toml:6:1: flow.gradient = [[0, 1], [0, 0]]: not allowed with an outer wall, which drives "
       "the flow; only reverse_at is"},
      {tank() + "[flow]\ncentre = [0, 1]\n",
       "s.toml:6:1: flow.centre = [0, 1]: not allowed with an outer wall, which drives the flow; "
       "only reverse_at is"},
      {tank() + "[flow]\ngauge_length = 1\n",
       "s.toml:6:1: flow.gauge_length = 1: not allowed with an outer wall, which drives the flow; "
       "only reverse_at is"},
      {tank() + "[flow]\nreverse_at = [-1]\n",
       "s.toml:6:14: flow.reverse_at = [-1]: must be a list of ascending times > 0"},
      {tank() + "[flow]\nreverse = [1]\n",
       "s.toml:6:1: flow.reverse = [1]: unknown key, did you mean 'reverse_at'?"},
  });
}

BOOST_AUTO_TEST_SUITE_END()
