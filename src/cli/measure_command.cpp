// Measures a run: means over time with their errors, pair correlation, neighbours, directions and
// profiles of its bodies, each as a table and a plot.
#include "cli/measure_command.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "analysis/run.hpp"
#include "cli/run_command.hpp"
#include "record/atomic_file.hpp"
#include "statistics/structure.hpp"
#include "text/number_text.hpp"

namespace stokesbook {

namespace {

/// Writes and prints the means of all quantities that the run defines.
void write_means(const Run& run, const BodyFrames& frames, const std::filesystem::path& out) {
  std::string text = "quantity,mean,standard_error,interval\n";
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    const auto [mean, standard_error, interval] = mean_of_all(frames.t, values);
    if (std::isnan(mean)) return;
    text += name + ',' + exact_number(mean) + ',' + exact_number(standard_error) + ',' +
            exact_number(interval) + '\n';
    std::printf("%20s  %s%s\n", name.c_str(), short_number(mean, 6).c_str(),
                std::isnan(interval) ? "" : (" +- " + short_number(interval, 2)).c_str());
  };
  const auto first = std::ranges::find(run.times(), frames.t.front()) - run.times().begin();
  for (const std::string& name : run.rheology.names) {
    const auto begin = run.rheology[name].begin() + first;
    if (name != "t") add(name, {begin, begin + std::ssize(frames.t)});
  }
  add("nematic_order", nematic_order(run.scene, frames));
  write_atomically(out / "means.csv", text, SafeFrom::kill);
}

}  // namespace

int measure_run(const MeasureOptions& options) {
  const Run run = read_run(options.run);
  const Scene& scene = run.scene;
  if (scene.bodies.empty()) throw RecordError(options.run, "has no bodies to measure");
  if (scene.cell && !options.box.empty()) {
    throw RecordError(options.run,
                      "has a periodic cell, in which all bodies and images count: remove --box");
  }
  const std::filesystem::path& out = options.out.empty() ? options.run : options.out;
  const BodyFrames frames = read_frames(run, options.from, options.to);
  make_folder(out);
  const auto write = [&](const Measurement& measurement) {
    if (measurement.at.empty()) return;
    write_atomically(out / (measurement.name + ".csv"), to_csv(measurement), SafeFrom::kill);
    for (std::size_t k = 0; k < measurement.quantities.size(); ++k) {
      const std::string name = measurement.name + '_' + measurement.quantities[k] + ".svg";
      write_atomically(out / name, draw(measurement, k), SafeFrom::kill);
    }
  };
  std::printf("means of %zu written times, with 95 %% confidence intervals\n", frames.t.size());
  write_means(run, frames, out);
  const Measurement near = neighbours(scene, frames);
  write(near);
  write(orientations(scene, frames, options.bins));
  if (options.box.empty() && !is_enclosed(scene) && !scene.cell) {
    std::printf("pair correlation and profiles of an unbounded fluid require --box\n");
    return exit_done;
  }
  RegionBox box;
  if (!options.box.empty()) std::ranges::copy(options.box, box.emplace().begin());
  // The last of the gaps that neighbours() counts is a mean radius.
  const double longest = options.longest > 0.0 ? options.longest : 8.0 * near.at.back();
  write(pair_correlation(scene, frames, box, longest, options.bins));
  if (scene.cell) {
    std::printf("profiles require walls: on the mean a periodic cell is the same everywhere\n");
    return exit_done;
  }
  const Across across = options.across == "x"   ? Across::x
                        : options.across == "y" ? Across::y
                                                : Across::radius;
  write(profile(scene, frames, box, across, options.bins));
  std::printf("tables and plots in %s\n", out.c_str());
  return exit_done;
}

}  // namespace stokesbook
