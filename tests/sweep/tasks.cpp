// Tests the tasks of a sweep.

#include <cmath>
#include <set>

#include "sweep/task.hpp"
#include "sweep_files.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

constexpr const char* two_axes =
    "seeds = { first = 5, count = 2 }\n"
    "[[axes]]\nkey = 'time.dt'\nname = 'dt'\nvalues = [0.5, 0.25]\n"
    "[[axes]]\nkey = 'bodies.0.shape'\n"
    "values = [{ kind = 'circle', radius = 1 }, { kind = 'ellipse', semi_axes = [2, 1] }]\n";

std::vector<double> numbers(const Axis& axis) {
  std::vector<double> result;
  for (const auto& value : axis.values) result.push_back(std::stod(value.at(0).value));
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(tasks)

BOOST_AUTO_TEST_CASE(all_combinations_once_seeds_fastest) {
  const Folder folder;
  const Sweep sweep = folder.sweep(two_axes);
  BOOST_TEST(task_count(sweep) == 8U);
  BOOST_TEST(runs_per_combination(sweep) == 2U);
  std::set<std::vector<std::string>> different;
  for (std::size_t k = 0; k < 8; ++k) different.insert(task_of(sweep, k).overrides());
  BOOST_TEST(different.size() == 8U);
  const std::vector<std::string> expected{
      "time.dt=0.25", "bodies.0.shape={ kind = \"circle\", radius = 1 }", "seed=6"};
  BOOST_TEST(task_of(sweep, 5).overrides() == expected, boost::test_tools::per_element());
  BOOST_TEST(
      task_of(sweep, 5).description() ==
      "task 5: time.dt = 0.25, bodies.0.shape = { kind = \"circle\", radius = 1 }, seed = 6");
}

BOOST_AUTO_TEST_CASE(scenes_have_the_values) {
  const Folder folder;
  folder.add_fill();
  const Sweep sweep = folder.sweep(two_axes);
  const Scene scene = scene_of(sweep, task_of(sweep, 7)).scene;
  BOOST_TEST(*scene.time->dt == 0.25);
  BOOST_TEST(scene.seed == 6U);
  BOOST_TEST(std::get<Ellipse>(scene.bodies[0].shape).a == 2.0);
  const Sweep no_seeds = folder.sweep("[[axes]]\nkey = 'time.dt'\nvalues = [0.5]\n");
  BOOST_TEST(scene_of(no_seeds, task_of(no_seeds, 0)).scene.seed == 7U);
}

BOOST_AUTO_TEST_CASE(keys_of_one_axis_change_together) {
  const Folder folder;
  const Sweep sweep = folder.sweep(
      "[[axes]]\nkey = ['time.dt', 'flow.rate']\n"
      "values = [[0.5, 1.0], [0.25, 2.0]]\n"
      "[[axes]]\nkey = 'solver.tolerance'\nvalues = [1e-3, 1e-4]\n");
  BOOST_TEST(task_count(sweep) == 4U);
  const std::vector<std::string> expected{"time.dt=0.25", "flow.rate=2.0",
                                          "solver.tolerance=0.001"};
  BOOST_TEST(task_of(sweep, 2).overrides() == expected, boost::test_tools::per_element());
  const Scene scene = scene_of(sweep, task_of(sweep, 3)).scene;
  BOOST_TEST(*scene.time->dt == 0.25);
  BOOST_TEST(std::get<ShearFlow>(scene.flow).rate == 2.0);
  const std::string text = manifest(sweep);
  BOOST_TEST(text.starts_with("task,folder,time.dt,flow.rate,solver.tolerance,scene\n"));
  BOOST_TEST(text.find("\n2,runs/0002,0.25,2.0,0.001,") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(ranges_hold_both_ends) {
  const Folder folder;
  const auto axis = [&](const std::string& range) {
    return folder.sweep("[[axes]]\nkey = 'time.dt'\nrange = " + range + "\n").axes.at(0);
  };
  const std::vector<double> down{1.0, 0.75, 0.5};
  BOOST_TEST(numbers(axis("{ from = 1, to = 0.5, count = 3 }")) == down,
             boost::test_tools::per_element());
  const std::vector<double> values =
      numbers(axis("{ from = 0.3, to = 0.7, count = 4, spacing = 'logarithmic' }"));
  BOOST_TEST(values.size() == 4U);
  BOOST_TEST(values.front() == 0.3);
  BOOST_TEST(values.back() == 0.7);
  for (std::size_t k = 1; k < 4; ++k) {
    BOOST_TEST(values[k] / values[k - 1] == std::cbrt(0.7 / 0.3),
               boost::test_tools::tolerance(1e-14));
  }
}

BOOST_AUTO_TEST_CASE(long_values_are_whole) {
  const Folder folder;
  const std::string points =
      "[[2.0, 0.0], [1.5, 1.5], [0.0, 2.0], [-1.5, 1.5], [-2.0, 0.0], [-1.5, -1.5], [0.0, -2.0], "
      "[1.5, -1.5]]";
  const Sweep sweep = folder.sweep(
      "[[axes]]\nkey = 'bodies.0.shape'\nvalues = [{ kind = 'nodes', "
      "points = " +
      points + " }]\n");
  BOOST_TEST(sweep.axes[0].values[0][0].value == "{ kind = \"nodes\", points = " + points + " }");
  BOOST_TEST(std::get<NodalCurve>(scene_of(sweep, task_of(sweep, 0)).scene.bodies[0].shape)
                 .points.size() == 8);
}

BOOST_AUTO_TEST_CASE(manifests_list_tasks_and_tell_scenes_apart) {
  const Folder folder;
  folder.add_fill();
  const std::string text = manifest(folder.sweep(two_axes));
  BOOST_TEST(text.starts_with("task,folder,dt,bodies.0.shape,seed,scene\n"));
  BOOST_TEST(
      text.find("\n6,runs/0006,0.25,\"{ kind = \"\"ellipse\"\", semi_axes = [2, 1] }\",5,") !=
      std::string::npos);
  const std::string same = manifest(folder.sweep(two_axes));
  BOOST_TEST(text == same);
  folder.write("scene.toml", folder.text_of("scene.toml") + "method = 'heun'\n");
  const std::string changed = manifest(folder.sweep(two_axes));
  BOOST_TEST(text != changed);
}

BOOST_AUTO_TEST_SUITE_END()
