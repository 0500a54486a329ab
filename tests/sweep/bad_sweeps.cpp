// Tests every error in a sweep file, with the whole message of each.

#include <vector>

#include "scene/scene.hpp"
#include "sweep_files.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

struct BadSweep {
  std::string text;
  std::string message;
};

void check(const std::vector<BadSweep>& sweeps) {
  const Folder folder;
  for (const BadSweep& bad : sweeps) {
    BOOST_TEST_CONTEXT(bad.text) {
      const auto read = [&] { manifest(folder.sweep(bad.text)); };
      BOOST_TEST(message_of<SceneError>(folder, read) == "sweep.toml:" + bad.message);
    }
  }
}

/// Returns an axis over the time step; the given lines begin with line 4.
std::string axis(const std::string& lines) {
  return "[[axes]]\nkey = 'time.dt'\n" + lines;
}

/// Returns a quantity to collect; the given lines begin with line 4.
std::string quantity(const std::string& lines) {
  return "seeds = [1]\n[[collect]]\n" + lines;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(bad_sweeps)

BOOST_AUTO_TEST_CASE(top) {
  check({
      {"", "1:1: a sweep must vary something: write [[axes]] or seeds"},
      {"seed = [1]\n", "2:1: seed = [1]: unknown key, did you mean 'seeds'?"},
      {"seeds = []\n", "2:9: seeds = []: must be a list of one or more values"},
      {"seeds = [1, -2]\n", "2:13: seeds[1] = -2: must be an integer >= 0"},
      {"seeds = [1, 0.5]\n", "2:13: seeds[1] = 0.5: must be an integer >= 0, not a float"},
      {"seeds = [3, 3]\n", "2:13: seeds[1] = 3: is repeated in the list"},
      {"seeds = 3\n",
       "2:9: seeds = 3: must be a list of integers or { first, count }, not an integer"},
      {"seeds = { first = 1 }\n",
       "2:9: seeds.count is missing: must be an integer from 1 to 100000"},
      {"seeds = { first = 1, count = 0 }\n",
       "2:30: seeds.count = 0: must be an integer from 1 to 100000"},
      {"seeds = { first = 1, count = 2000000000 }\n",
       "2:30: seeds.count = 2000000000: must be an integer from 1 to 100000"},
      {"seeds = { first = 9223372036854775807, count = 2 }\n",
       "2:19: seeds.first = 9223372036854775807: must be an integer from 0 to "
       "9223372036854675807"},
      {"seeds = { first = 1, count = 1000 }\n" +
           axis("range = { from = 1, to = 2, count = 101 }\n"),
       "1:1: has 101000 tasks: at most 100000 may be in one sweep"},
  });
}

BOOST_AUTO_TEST_CASE(files) {
  const Folder folder;
  const auto error_of = [&](const std::string& text) {
    const auto path = folder.write("sweep.toml", text);
    return message_of<SceneError>(folder, [&] { read_sweep(path); });
  };
  BOOST_TEST(
      error_of("scene = 'none.toml'\nseeds = [1]\n") ==
      "sweep.toml:1:9: scene = \"none.toml\": the file none.toml does not exist or cannot be read");
  BOOST_TEST(error_of("seeds = [1]\n") ==
             "sweep.toml:1:1: scene is missing: must be the name of a scene file, relative to this "
             "file");
  BOOST_TEST(message_of<SceneError>(folder, [&] { read_sweep(folder.path() / "no.toml"); }) ==
             "no.toml: the file does not exist or cannot be read");
}

BOOST_AUTO_TEST_CASE(axes) {
  check({
      {"[[axes]]\nvalues = [1]\n",
       "2:1: axes[0].key is missing: must be a key of the scene, such as \"time.dt\" or "
       "\"fill.0.area_fraction\""},
      {"[[axes]]\nkey = 'time dt'\nvalues = [1]\n",
       "3:7: axes[0].key = \"time dt\": must be a key of the scene, such as \"time.dt\" or "
       "\"fill.0.area_fraction\""},
      {"[[axes]]\nkey = 'seed'\nvalues = [1]\n",
       "3:7: axes[0].key = \"seed\": seeds are not an axis; list them in the key seeds"},
      {axis(""), "2:1: axes[0]: must hold values or range, not both"},
      {axis("values = [1]\nrange = { from = 0, to = 1, count = 2 }\n"),
       "2:1: axes[0]: must hold values or range, not both"},
      {axis("values = []\n"), "4:10: axes[0].values = []: must be a list of one or more values"},
      {axis("values = 1\n"), "4:10: axes[0].values = 1: must be a list of values, not an integer"},
      {axis("values = [0.1, 0.2, 0.1]\n"),
       "4:21: axes[0].values[2] = 0.1: is repeated in the list"},
      {axis("value = [1]\n"), "4:1: axes[0].value = [1]: unknown key, did you mean 'values'?"},
      {axis("name = 'a b'\nvalues = [1]\n"),
       "4:8: axes[0].name = \"a b\": must be a name of letters, digits and _"},
      {axis("values = [0.1]\n") + axis("values = [0.2]\n"),
       "5:1: axes[1]: would give the tables two columns 'time.dt'; set another name"},
      {axis("name = 'seed'\nvalues = [0.1]\n"),
       "2:1: axes[0]: would give the tables two columns 'seed'; set another name"},
      {axis("name = 'runs'\nvalues = [0.1]\n"),
       "2:1: axes[0]: would give the tables two columns 'runs'; set another name"},
      {axis("name = 'folder'\nvalues = [0.1]\n"),
       "2:1: axes[0]: would give the tables two columns 'folder'; set another name"},
      {axis("values = [0.1]\n") + axis("name = 'dt'\nvalues = [0.2]\n"),
       "5:1: axes[1]: the axes set time.dt twice"},
  });
}

BOOST_AUTO_TEST_CASE(tied_axes) {
  const std::string tied = "[[axes]]\nkey = ['time.dt', 'flow.rate']\n";
  check({
      {"[[axes]]\nkey = ['time.dt']\nvalues = [[1]]\n",
       "3:7: axes[0].key = [\"time.dt\"]: must be one key, or a list of several"},
      {tied + "name = 'both'\nvalues = [[1, 2]]\n",
       "4:1: axes[0].name = \"both\": not allowed with a list of keys, which requires values"},
      {tied + "range = { from = 1, to = 2, count = 2 }\n",
       "4:1: axes[0].range: not allowed with a list of keys, which requires values"},
      {tied, "2:1: axes[0]: must hold values or range, not both"},
      {tied + "values = [[1, 2], [1]]\n",
       "4:19: axes[0].values[1] = [1]: must be a list of 2 values, one for each key"},
      {tied + "values = [1, 2]\n",
       "4:11: axes[0].values[0] = 1: must be a list of 2 values, one for each key, not an integer"},
      {tied + "values = [[1, 2], [1, 2]]\n",
       "4:19: axes[0].values[1] = [1, 2]: is repeated in the list"},
      {"[[axes]]\nkey = ['time.dt', 'seed']\nvalues = [[1, 2]]\n",
       "3:19: axes[0].key[1] = \"seed\": seeds are not an axis; list them in the key seeds"},
      {"[[axes]]\nkey = ['time.dt', 3]\nvalues = [[1, 2]]\n",
       "3:19: axes[0].key[1] = 3: must be a key of the scene, such as \"time.dt\" or "
       "\"fill.0.area_fraction\", not an integer"},
      {tied + "values = [[1, 2]]\n" + axis("name = 'other'\nvalues = [3]\n"),
       "5:1: axes[1]: the axes set time.dt twice"},
      {tied + "values = [[1, 2], [1, 'fast']]\n",
       "4:23: flow.rate = \"fast\": must be a number, not a string"},
  });
}

BOOST_AUTO_TEST_CASE(ranges) {
  check({
      {axis("range = { from = 0.1, to = 1.0 }\n"),
       "4:9: axes[0].range.count is missing: must be an integer from 2 to 100000"},
      {axis("range = { from = 0.1, to = 1.0, count = 1 }\n"),
       "4:41: axes[0].range.count = 1: must be an integer from 2 to 100000"},
      {axis("range = { from = 0.1, to = 1.0, count = 100001 }\n"),
       "4:41: axes[0].range.count = 100001: must be an integer from 2 to 100000"},
      {axis("range = { from = 0.1, to = 0.1, count = 3 }\n"),
       "4:28: axes[0].range.to = 0.1: must differ from where the range begins"},
      {axis("range = { from = 0, to = 1, count = 3, spacing = 'logarithmic' }\n"),
       "4:18: axes[0].range.from = 0: must be > 0 where the spacing is logarithmic"},
      {axis("range = { from = 1, to = -1, count = 3, spacing = 'logarithmic' }\n"),
       "4:26: axes[0].range.to = -1: must be > 0 where the spacing is logarithmic"},
      {axis("range = { from = 1, to = 2, count = 3, spacing = 'log' }\n"),
       "4:50: axes[0].range.spacing = \"log\": must be one of linear, logarithmic"},
  });
}

BOOST_AUTO_TEST_CASE(quantities) {
  check({
      {quantity("table = 'rheology'\n"),
       "4:9: collect[0].table = \"rheology\": must be one of rheology.csv, steps.csv, "
       "trajectory.csv, walls.csv"},
      {quantity("table = 'rheology.csv'\ncolumn = 'torque'\n"),
       "5:10: collect[0].column = \"torque\": is not a column of rheology.csv; its columns are "
       "t,dissipation,torque_ratio,order_parameter,s11,s12,uniform_x,uniform_y, and in "
       "scenes with [cell] stress_11,stress_12,stress_21,stress_22,viscosity,"
       "normal_stress_difference,particle_pressure,dissipation_by_traction,contact_stress_11,"
       "contact_stress_12,contact_stress_22"},
      {quantity("table = 'rheology.csv'\ncolumn = 's21'\ntake = 'last'\n"),
       "5:10: collect[0].column = \"s21\": is not a column of rheology.csv, did you mean 's11'?"},
      {quantity("table = 'rheology.csv'\n"),
       "3:1: collect[0].column is missing: must be a column of rheology.csv"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\n"),
       "3:1: collect[0]: must hold average = [begin, end] or take, one of last, least, largest, "
       "sum"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\naverage = [0, 1]\n"),
       "3:1: collect[0]: must hold average = [begin, end] or take, one of last, least, largest, "
       "sum"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\naverage = [1, 1]\n"),
       "6:11: collect[0].average = [1, 1]: must be two times [begin, end] with 0 <= begin < end"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\naverage = [0, 3]\n"),
       "3:1: collect s11: the average ends at t = 3, after the run does, at t = 2"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\nbody = 0\n"),
       "6:1: collect[0].body = 0: rheology.csv has no column 'body'"},
      {quantity("table = 'trajectory.csv'\ncolumn = 'x'\ntake = 'last'\n"),
       "3:1: collect[0].body is missing: must be an integer >= 0"},
      {quantity("table = 'trajectory.csv'\ncolumn = 'x'\nbody = 1\ntake = 'last'\n"),
       "3:1: collect x: the scene has 1 bodies, numbered from 0; there is no number 1"},
      {quantity("table = 'walls.csv'\ncolumn = 'fx'\nwall = 0\ntake = 'last'\n"),
       "3:1: collect fx: the scene has 0 walls, numbered from 0; there is no number 0"},
      {quantity("table = 'rheology.csv'\ncolumn = 'viscosity'\ntake = 'last'\n"),
       "3:1: collect viscosity: the scene has no [cell], hence no column 'viscosity'"},
      {quantity("table = 'trajectory.csv'\nbody = 0\ncolumn = 'wrapped_z'\ntake = 'last'\n"),
       "6:10: collect[0].column = \"wrapped_z\": is not a column of trajectory.csv, did you mean "
       "'wrapped_x'?"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n[[collect]]\n"
                "table = 'rheology.csv'\ncolumn = 's11'\ntake = 'least'\n"),
       "7:1: collect[1]: would give the tables two columns 's11'; set another name"},
      {quantity("table = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n[[collect]]\n"
                "name = 's11_interval'\ntable = 'rheology.csv'\ncolumn = 's11'\ntake = 'least'\n"),
       "7:1: collect[1]: would give the tables two columns 's11_interval'; set another name"},
      {quantity("name = 's_interval'\ntable = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n"
                "[[collect]]\nname = 's'\ntable = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n"),
       "8:1: collect[1]: would give the tables two columns 's_interval'; set another name"},
      {axis("name = 's11'\nvalues = [0.1]\n") +
           "[[collect]]\ntable = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n",
       "6:1: collect[0]: would give the tables two columns 's11'; set another name"},
  });
}

BOOST_AUTO_TEST_CASE(values_that_the_scene_refuses_are_found_in_the_sweep_file) {
  check({
      {axis("values = [0.1, -0.1]\n"), "4:16: time.dt = -0.1: must be a number > 0"},
      {axis("range = { from = 1, to = 0, count = 3 }\n"),
       "4:9: time.dt = 0.0: must be a number > 0"},
      {"[[axes]]\nkey = 'time.dtt'\nvalues = [1]\n",
       "4:11: time.dtt = 1: unknown key, did you mean 'dt'?"},
      {"[[axes]]\nkey = 'bodies.1.n_nodes'\nvalues = [64]\n",
       "4:11: bodies has 1 elements, numbered from 0; there is no element '1'"},
      {"[[axes]]\nkey = 'bodies.0.shape'\nvalues = [{ kind = 'circle', radius = 'big' }]\n",
       "4:11: bodies[0].shape.radius = \"big\": must be a number > 0, not a string"},
      {"seeds = [1]\n[[axes]]\nkey = 'output.formats'\nvalues = [['csv'], ['vtk']]\n"
       "[[collect]]\ntable = 'rheology.csv'\ncolumn = 's11'\ntake = 'last'\n",
       "6:1: collect s11: the scene writes no rheology.csv: its formats lack \"csv\""},
  });
}

BOOST_AUTO_TEST_CASE(no_two_tasks_have_the_same_scene) {
  check({
      {axis("values = [1, 1.0]\n"),
       "4:14: task 1: time.dt = 1.0: the scene is that of task 0: time.dt = 1"},
      // The second axis sets the key that the first one sets.
      {"[[axes]]\nkey = 'flow.rate'\nvalues = [1.0, 2.0]\n"
       "[[axes]]\nkey = 'flow'\nvalues = [{ kind = 'shear', rate = 3.0 }]\n",
       "4:16: task 1: flow.rate = 2.0, flow = { kind = \"shear\", rate = 3.0 }: the scene is that "
       "of task 0: flow.rate = 1.0, flow = { kind = \"shear\", rate = 3.0 }"},
  });
}

BOOST_AUTO_TEST_CASE(seeds_must_change_something) {
  const std::string problem =
      ": seeds: the scene has no [[fill]], so all seeds give the same run; keep one seed";
  check({
      {"seeds = [1, 2]\n", "2:13" + problem},
      {"seeds = { first = 1, count = 2 }\n", "2:9" + problem},
  });
  const Folder folder;
  const auto read = [&](const std::string& text) { return manifest(folder.sweep(text)).size(); };
  BOOST_CHECK_NO_THROW(read("seeds = [1]\n"));
  folder.add_fill();
  BOOST_CHECK_NO_THROW(read("seeds = [1, 2]\n"));
}

BOOST_AUTO_TEST_SUITE_END()
