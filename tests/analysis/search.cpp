// Tests the search for settings on models of error and cost, whose best settings are known.
#include "analysis/search.hpp"

#include <algorithm>
#include <cmath>

#include "scene/words.hpp"
#include "synthetic_run.hpp"

using namespace stokesbook;
using namespace stokesbook::test;

namespace {

/// A model of a run: its error and its cost as functions of the settings.
struct Model {
  static constexpr double products_per_second = 300.0;

  double solver_error = 0.1;    ///< error over solver.tolerance
  double step_error = 1.0;      ///< error over time.tolerance, and constant of the fixed steps
  double cost_of_nodes = 1.0;   ///< factor on the cost if nodes are automatic
  std::vector<double> asked{};  ///< limits on the CPU time of all runs so far

  double error(const Scene& scene) const {
    const TimeSettings& time = *scene.time;
    const double order = time.method == SteppingMethod::rk4     ? 4.0
                         : time.method == SteppingMethod::euler ? 1.0
                                                                : 2.0;
    const double steps = time.tolerance ? *time.tolerance : 0.1 * std::pow(*time.dt, order);
    return step_error * steps + solver_error * scene.solver.tolerance;
  }

  double seconds(const Scene& scene) const {
    const TimeSettings& time = *scene.time;
    const double order = time.method == SteppingMethod::bogacki_shampine32 ? 3.0
                         : time.method == SteppingMethod::prince_dormand87 ? 8.0
                                                                           : 5.0;
    const double stages = time.method == SteppingMethod::rk4                  ? 4.0
                          : time.method == SteppingMethod::heun               ? 2.0
                          : time.method == SteppingMethod::dormand_prince54   ? 6.0
                          : time.method == SteppingMethod::prince_dormand87   ? 12.0
                          : time.method == SteppingMethod::bogacki_shampine32 ? 3.0
                                                                              : 1.0;
    const double steps =
        time.tolerance ? 3.0 * std::pow(*time.tolerance, -1.0 / order) : 10.0 / *time.dt;
    return 1e-2 * stages * steps * -std::log10(scene.solver.tolerance) *
           (scene.bodies[0].n_nodes == automatic_nodes ? cost_of_nodes : 1.0);
  }

  Outcome run(const Scene& scene, double most_seconds) {
    asked.push_back(most_seconds);
    const double needed = seconds(scene);
    if (needed > most_seconds) {
      return {.seconds = most_seconds, .failure = "took too long"};
    }
    const double e = error(scene);
    Run run = run_of(scene, {0, 5, 10}, [&](double t) { return 0.2 * t * e; });
    run.steps.columns[3].assign(3, products_per_second * needed / 3.0);
    return {.run = std::move(run),
            .seconds = needed,
            .nodes = std::vector<int>(scene.bodies.size() + 1, 32)};
  }
};

Search search_in(Model& model, const Request& request, const Scene& scene = disks(2)) {
  return search(scene, request, [&](const Scene& changed, double most_seconds) {
    return model.run(changed, most_seconds);
  });
}

/// Returns the cost of the cheapest settings of the model with an accuracy, on a fine grid. Smaller
/// steps cost more.
double least_cost(const Model& model, double accuracy) {
  double least = 1e99;
  for (const auto& [_, method] : scene_text::stepping_methods) {
    const bool adaptive = is_embedded(method);
    for (int k = 1; k < 300; ++k) {
      // Fixed steps end at the written times, which are t_final / 50 apart.
      const double step = adaptive ? 0.1 * std::pow(1.1, -k) : 0.2 / k;
      double least_of_step = 1e99;
      for (double solver = 1e-12; solver <= 0.1; solver *= 10.0) {
        if (adaptive && solver > most_solver_over_step * step) continue;
        for (const std::vector<int>& nodes : {std::vector<int>{}, std::vector<int>{32, 32, 32}}) {
          const Scene scene = with_settings(disks(2), {method, adaptive, step, solver, nodes});
          const double seconds = model.seconds(scene);
          least_of_step = std::min(least_of_step, seconds);
          if (model.error(scene) <= accuracy) least = std::min(least, seconds);
        }
      }
      if (least_of_step > least) break;
    }
  }
  return least;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(searches)

BOOST_AUTO_TEST_CASE(the_search_finds_settings_near_the_best) {
  for (const double accuracy : {1e-2, 1e-3, 1e-5}) {
    for (const Model& given : {Model{}, Model{.solver_error = 3.0}, Model{.step_error = 20.0},
                               Model{.step_error = 0.05}, Model{.cost_of_nodes = 5.0}}) {
      Model model = given;
      const Search found = search_in(model, {.accuracy = accuracy, .budget = 1e5});
      BOOST_REQUIRE_MESSAGE(found.best, found.failure);
      const Trial& best = found.trials[*found.best];
      const Scene scene = with_settings(disks(2), best.settings);
      BOOST_TEST(model.error(scene) <= 1.06 * accuracy);
      BOOST_TEST(model.error(scene) >= accuracy / 3.5);
      BOOST_TEST(best.seconds <= 2.0 * least_cost(model, accuracy));
      BOOST_TEST(found.trials.size() < 40u);
    }
  }
}

BOOST_AUTO_TEST_CASE(products_decide_between_short_runs) {
  for (const double accuracy : {1e-2, 1e-3, 1e-5}) {
    Model model;
    int runs = 0;
    const auto run = [&](const Scene& scene, double) {
      Outcome outcome = model.run(scene, 1e9);
      // On a busy machine, the times of runs below .2 s are random.
      outcome.seconds = 0.05 + 0.03 * (runs++ * 7 % 5);
      return outcome;
    };
    const Search found = search(disks(2), {.accuracy = accuracy, .budget = 1e5}, run);
    BOOST_REQUIRE_MESSAGE(found.best, found.failure);
    const Trial& best = found.trials[*found.best];
    BOOST_TEST(best.error <= accuracy);
    BOOST_TEST(best.error >= accuracy / 3.0);
    BOOST_TEST(best.products <= 2.0 * Model::products_per_second * least_cost(model, accuracy));
  }
}

BOOST_AUTO_TEST_CASE(the_budget_bounds_all_runs) {
  for (const double budget : {10.0, 50.0, 500.0}) {
    Model model;
    const Search found = search_in(model, {.accuracy = 1e-4, .budget = budget});
    BOOST_TEST(found.seconds <= budget);
    BOOST_TEST(std::ranges::max(model.asked) <= budget);
    BOOST_TEST(found.best.has_value() == (budget == 500.0));
    if (!found.best) BOOST_TEST(found.failure.find("budget") != std::string::npos);
  }
}

BOOST_AUTO_TEST_CASE(runs_that_never_agree_give_no_reference) {
  Model model;
  double sign = 1.0;
  const Search found =
      search(disks(2), {.budget = 1e5}, [&](const Scene& scene, double most_seconds) {
        Outcome outcome = model.run(scene, most_seconds);
        sign = -sign;
        for (double& x : outcome.run->bodies.columns[2]) x += sign;
        return outcome;
      });
  BOOST_TEST(!found.best.has_value());
  BOOST_TEST(found.failure.find("differ by 1;") != std::string::npos);
  BOOST_TEST(found.trials.empty());
}

BOOST_AUTO_TEST_CASE(a_quantity_may_count_instead_of_the_trajectory) {
  Model model;
  const Search found = search_in(model, {.accuracy = 1e-2, .quantity = "stresslet", .budget = 1e5});
  // The model has no error of the stresslet: the first run of a method suffices.
  BOOST_REQUIRE(found.best.has_value());
  BOOST_TEST(found.trials[*found.best].error == 0.0);
  BOOST_CHECK_THROW(search_in(model, {.quantity = "torque_ratio"}), SceneError);
}

BOOST_AUTO_TEST_CASE(diagrams_and_the_table_have_all_trials) {
  Model model;
  const Request request{.accuracy = 1e-2, .quantity = "stresslet"};
  const Search found = search_in(model, request);
  const auto pictures = draw(found, request);
  BOOST_TEST(pictures.size() == 6u);
  BOOST_TEST(pictures.at("trajectory_over_seconds.svg").find("rk4") != std::string::npos);
  const std::string table = to_text(found);
  const auto lines = static_cast<std::size_t>(std::ranges::count(table, '\n'));
  BOOST_TEST(lines == found.trials.size() + 1);
  for (const Trial& trial : found.trials) {
    BOOST_TEST(table.find("  " + to_text(trial.settings) + "\n") != std::string::npos);
  }
}

BOOST_AUTO_TEST_SUITE_END()
