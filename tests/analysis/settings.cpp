// Tests what changes in a scene with other or tighter settings, and what does not.
#include "analysis/settings.hpp"

#include "synthetic_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

BOOST_AUTO_TEST_SUITE(settings)

BOOST_AUTO_TEST_CASE(tightened_scenes_have_smaller_errors_of_each_kind) {
  Scene scene = disks(2);
  scene.bodies[0].n_nodes = 32;
  scene.solver.gmres_tol = 1e-3;
  scene.solver.tolerance = 1e-4;
  scene.time->dt_min = 1e-5;
  Scene tight = tightened(scene);
  BOOST_TEST(*tight.time->tolerance == 1e-7, within_rounding);
  BOOST_TEST(*tight.time->dt_min == 1e-6, within_rounding);
  BOOST_TEST(tight.solver.tolerance == 1e-6, within_rounding);
  BOOST_TEST(!tight.solver.gmres_tol.has_value());
  BOOST_TEST(tight.bodies[0].n_nodes == automatic_nodes);
  tight.bodies = scene.bodies;
  tight.solver = scene.solver;
  tight.time = scene.time;
  BOOST_TEST((tight == scene));

  scene.time = TimeSettings{.t_final = 1.0, .dt = 0.1, .method = SteppingMethod::euler};
  BOOST_TEST(*tightened(scene).time->dt == 0.05, within_rounding);
  scene.solver.tolerance = 1e-11;
  BOOST_TEST(tightened(scene).solver.tolerance == 1e-12, within_rounding);
  scene.time->effort = EffortBounds{1, 2};
  BOOST_CHECK_THROW(tightened(scene), SceneError);
  scene.time->effort.reset();
  scene.output.formats = {OutputFormat::vtk};
  BOOST_CHECK_THROW(tightened(scene), SceneError);
  scene.output.formats = {OutputFormat::csv};
  scene.contact = ContactSettings{.minimum_separation = 0.1, .in_spacings = true};
  BOOST_CHECK_THROW(tightened(scene), SceneError);
}

BOOST_AUTO_TEST_CASE(settings_are_those_of_the_scene) {
  Scene scene = disks(2);
  scene.time->dt_max = 0.3;
  const Scene fixed = with_settings(scene, {.method = SteppingMethod::rk4,
                                            .adaptive = false,
                                            .step = 0.2,
                                            .solver = 1e-3,
                                            .nodes = {16, 24, 64}});
  BOOST_TEST(
      (fixed.time == TimeSettings{.t_final = 10.0, .dt = 0.2, .method = SteppingMethod::rk4}));
  BOOST_TEST(fixed.solver.tolerance == 1e-3);
  BOOST_TEST(fixed.bodies[1].n_nodes == 24);
  BOOST_TEST(fixed.walls[0].n_nodes == 64);
  const Scene adapted = with_settings(fixed, {.step = 1e-4, .solver = 1e-3});
  BOOST_TEST((adapted.time == TimeSettings{.t_final = 10.0, .tolerance = 1e-4}));
  BOOST_TEST(adapted.bodies[1].n_nodes == automatic_nodes);
  BOOST_TEST(to_text(Settings{.step = 1e-4, .solver = 1e-3, .nodes = {16, 24, 64}}) ==
             "dormand_prince54, time.tolerance 0.0001, solver.tolerance 0.001, n_nodes 16 to 64");
}

BOOST_AUTO_TEST_SUITE_END()
