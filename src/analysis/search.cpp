// Searches for the cheapest settings of a scene: measures errors against a reference of its own,
// and follows for each method the law by which the error falls with the step (chapter 09).
#include "analysis/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/comparison.hpp"
#include "scene/words.hpp"
#include "study/plot.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

/// Returns the methods for a scene, the one of the reference first, those that rarely win last.
std::vector<Settings> methods_of(const Scene& scene) {
  using enum SteppingMethod;
  if (scene.contact) return {{heun, true}, {heun, false}, {euler, false}};
  return {{dormand_prince54, true},
          {bogacki_shampine32, true},
          {adams_bashforth2, false},
          {rk4, false},
          {prince_dormand87, true},
          {heun, false},
          {euler, false}};
}

std::string name_of(const Settings& settings) {
  return std::string(scene_text::name_of(settings.method, scene_text::stepping_methods)) +
         (settings.adaptive ? ", adapted steps" : ", fixed steps");
}

/// Rounds to two digits, which suffice for a tolerance and can be read in a scene.
double rounded(double x) {
  return parse_number<double>(short_number(x, 2)).value();
}

class Searcher {
 public:
  Searcher(Scene scene, const Request& request, const RunScene& run)
      : scene_(std::move(scene)), request_(request), run_(run) {}

  Search find() {
    const std::vector<Settings> methods = methods_of(scene_);
    if (!find_reference(methods.front().method)) return search_;
    for (const Settings& method : methods) tune(first_settings(method), name_of(method));
    if (!search_.best) {
      search_.failure = "no run within the budget has the accuracy";
      return search_;
    }
    vary_solver_tolerance();
    vary_nodes();
    tune(best().settings, "all together", best());
    return search_;
  }

 private:
  /// Returns the step that a method takes when it is asked for one: tolerances are rounded and at
  /// most 0.1; fixed steps end at the written times, which shortens them.
  double possible_step(const Settings& method, double step) const {
    if (method.adaptive) return std::min(0.1, rounded(step));
    const double dt_write = *scene_.output.dt_write;
    return dt_write / std::max(1.0, std::ceil(dt_write / step - 1e-9));
  }

  const Trial& best() const { return search_.trials[*search_.best]; }

  double error_of(const Comparison& comparison) const {
    return std::ranges::max(request_.quantity.empty() ? comparison.trajectory
                                                      : comparison[request_.quantity]);
  }

  Outcome run(const Settings& settings, double most_seconds) {
    Outcome outcome = run_(with_settings(scene_, settings), most_seconds);
    search_.seconds += outcome.seconds;
    return outcome;
  }

  /// Measures a run against the reference, and adds it to the trials.
  Trial add(const std::string& line, const Settings& settings, const Outcome& outcome) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Trial trial{line, settings, outcome.seconds, outcome.nodes, 0, none, none, none, none};
    if (outcome.run) {
      const std::vector<double>& products = outcome.run->steps["matvecs"];
      const Comparison comparison = compare(*outcome.run, *reference_);
      trial.steps = products.size();
      trial.products = std::accumulate(products.begin(), products.end(), 0.0);
      trial.trajectory = std::ranges::max(comparison.trajectory);
      trial.rheology = comparison.rheology();
      trial.error = error_of(comparison);
    }
    search_.trials.push_back(trial);
    if (trial.error <= request_.accuracy && is_better(trial)) {
      search_.best = search_.trials.size() - 1;
    }
    return trial;
  }

  /// Returns whether a trial is better than the best one: it takes less CPU time, or fewer
  /// products if the times hardly differ; or, if the products hardly differ either, the error of
  /// the best one is below a third of the accuracy, and that of the trial is not.
  bool is_better(const Trial& trial) const {
    if (!search_.best) return true;
    const double later = trial.seconds - best().seconds;
    if (std::abs(later) > noise + 0.1 * best().seconds) return later < 0.0;
    const double more = trial.products - best().products;
    if (std::abs(more) > 0.1 * best().products) return more < 0.0;
    return best().error < request_.accuracy / 3.0 && trial.error >= request_.accuracy / 3.0;
  }

  /// Returns the CPU time of the best trial; infinite if there is none.
  double least_seconds() const {
    return search_.best ? best().seconds : std::numeric_limits<double>::infinity();
  }

  /// Runs a trial; none if the budget is used up. A run that takes three times as long as the best
  /// one is stopped.
  std::optional<Trial> try_run(const std::string& line, const Settings& settings) {
    const double left = request_.budget - search_.seconds;
    if (left <= 0.0) return std::nullopt;
    return add(line, settings, run(settings, std::min(left, 1.0 + 3.0 * least_seconds())));
  }

  bool find_reference(SteppingMethod method) {
    constexpr double least_tolerance = 1e-12;
    Settings settings{method, true, 0.1 * request_.accuracy, 0.01 * request_.accuracy};
    std::vector<std::pair<Settings, Outcome>> references;
    while (settings.solver >= least_tolerance && search_.failure.empty()) {
      const double left = 0.5 * request_.budget - search_.seconds;
      Outcome finer = left > 0.0 ? run(settings, left) : Outcome{.failure = "no time is left"};
      search_.failure = finer.failure;
      if (finer.run && !references.empty()) {
        search_.reference_error = error_of(compare(*references.back().second.run, *finer.run));
        if (search_.reference_error <= 0.05 * request_.accuracy) {
          reference_ = std::move(finer.run);
          for (const auto& [used, outcome] : references) add(name_of(used), used, outcome);
          return true;
        }
      }
      references.emplace_back(settings, std::move(finer));
      settings.step = rounded(0.1 * settings.step);
      settings.solver = rounded(0.1 * settings.solver);
    }
    if (search_.failure.empty()) search_.failure = "if the flow is chaotic, shorten time.t_final";
    search_.failure =
        "no reference within half of the budget: two runs with time.tolerance down to " +
        short_number(10.0 * settings.step) + " differ by " + short_number(search_.reference_error) +
        "; " + search_.failure;
    return false;
  }

  /// Returns settings for the first run of a method: the accuracy as tolerance, or as many steps as
  /// the best run has taken so far.
  Settings first_settings(const Settings& method) const {
    const Trial& known = search_.best ? best() : search_.trials.front();
    const double dt = scene_.time->t_final / static_cast<double>(known.steps);
    return {method.method, method.adaptive,
            possible_step(method, method.adaptive ? request_.accuracy : dt),
            0.01 * request_.accuracy};
  }

  /// Varies the step until the error e is between a third of the accuracy a and a. With
  /// \f$ e(s) \sim s^q \f$, q by the last two runs or the method, the step after s is
  /// \f$ s\,(0.6\,a/e)^{1/q} \f$.
  /// @param  known  trial with the settings, if there is one
  void tune(Settings settings, const std::string& line, std::optional<Trial> known = {}) {
    constexpr int most_runs = 5;
    const double accuracy = request_.accuracy;
    const double order = order_of(settings.method), law = settings.adaptive ? 1.0 : order;
    std::optional<Trial> before;
    for (int k = 0; k < most_runs; ++k) {
      const std::optional<Trial> now = k == 0 && known ? known : try_run(line, settings);
      if (!now || (now->error <= accuracy && now->error >= accuracy / 3.0)) return;
      double q = law;
      if (before && before->error != now->error) {
        q = std::log(before->error / now->error) / std::log(before->settings.step / settings.step);
        q = std::clamp(q, 0.5 * law, 2.0 * law);
      }
      // After a run that failed, nan as error, the step is a quarter.
      const double error = std::max(now->error, 1e-3 * accuracy);
      const double factor =
          std::isnan(now->error) ? 0.25 : std::pow(0.6 * accuracy / error, 1.0 / q);
      const double next = possible_step(settings, settings.step * factor);
      const double steps = std::pow(settings.step / next, law / order);
      if (next == settings.step || now->seconds * steps > noise + 2.0 * least_seconds()) return;
      settings.step = next;
      if (!std::isnan(now->error)) before = now;
    }
  }

  void vary_solver_tolerance() {
    constexpr double most_tolerance = 0.1;
    Settings all = best().settings;
    Settings finer = all;
    const double law = all.adaptive ? 1.0 : order_of(all.method);
    finer.step = possible_step(all, all.step * std::pow(0.1, 1.0 / law));
    const double most = all.adaptive ? std::min(most_tolerance, most_solver_over_step * finer.step)
                                     : most_tolerance;
    for (finer.solver = rounded(10.0 * all.solver); finer.solver <= most;
         finer.solver = rounded(10.0 * finer.solver)) {
      const auto trial = try_run("solver.tolerance, smaller steps", finer);
      if (!trial || !(trial->error <= request_.accuracy / 3.0)) break;
      all.solver = finer.solver;
    }
    if (all.solver != best().settings.solver) try_run("all together", all);
  }

  void vary_nodes() {
    const Trial automatic = best();
    std::vector<int> own;
    for (const Body& body : scene_.bodies) own.push_back(body.n_nodes);
    for (const Wall& wall : scene_.walls) own.push_back(wall.n_nodes);
    std::vector<std::vector<int>> choices{automatic.nodes};
    if (std::ranges::count(own, automatic_nodes) == 0) choices.push_back(own);
    Settings settings = automatic.settings;
    for (const std::vector<int>& nodes : choices) {
      settings.nodes = nodes;
      try_run("n_nodes", settings);
    }
  }

  // CPU time by which equal runs may differ, seconds: other programs change it.
  static constexpr double noise = 0.2;

  Scene scene_;
  const Request& request_;
  const RunScene& run_;
  Search search_;
  std::optional<Run> reference_;
};

}  // namespace

Search search(Scene scene, const Request& request, const RunScene& run) {
  scene = with_tables_only(std::move(scene));
  if (!scene.output.dt_write) scene.output.dt_write = scene.time->t_final / 50.0;
  return Searcher(std::move(scene), request, run).find();
}

std::string to_text(const Search& search) {
  std::vector<Trial> trials = search.trials;
  std::ranges::sort(trials, {}, &Trial::seconds);
  std::vector<std::vector<std::string>> rows{
      {"CPU seconds", "products", "trajectory", "rheology", "error", "settings"}};
  for (const Trial& trial : trials) {
    std::vector<std::string>& row = rows.emplace_back();
    for (const double number :
         {trial.seconds, trial.products, trial.trajectory, trial.rheology, trial.error}) {
      row.push_back(std::isnan(number) ? "failed" : short_number(number));
    }
    row.push_back(to_text(trial.settings));
  }
  return aligned_rows(rows);
}

std::map<std::string, std::string> draw(const Search& search, const Request& request) {
  struct Measure {
    std::string name, label;
    double Trial::*value;
  };
  std::vector<Measure> errors{
      {"trajectory", "largest error of positions in radii, and of angles", &Trial::trajectory},
      {"rheology", "largest relative error of the rheology", &Trial::rheology}};
  if (!request.quantity.empty()) {
    errors.push_back({request.quantity, "largest error of " + request.quantity, &Trial::error});
  }
  const std::vector<Measure> costs{{"seconds", "CPU seconds", &Trial::seconds},
                                   {"products", "products with the operator", &Trial::products}};
  std::map<std::string, std::string> pictures;
  for (const auto& [name, label, error] : errors) {
    for (const auto& [cost_name, cost_label, cost] : costs) {
      study::Plot plot{.title = "Work and precision", .x_label = cost_label, .y_label = label};
      std::map<std::string, std::vector<study::PlotPoint>> lines;
      for (const Trial& trial : search.trials) {
        lines[trial.line].push_back({trial.*cost, trial.*error});
      }
      for (auto& [line, points] : lines) {
        std::ranges::sort(points, {}, &study::PlotPoint::x);
        plot.lines.push_back({line, std::move(points)});
      }
      pictures[name + "_over_" + cost_name + ".svg"] = study::draw_plot(plot);
    }
  }
  return pictures;
}

}  // namespace stokesbook
