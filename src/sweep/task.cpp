// Enumerates the tasks of a sweep: the place of a task, in mixed radix, gives the value of each
// axis and the seed.
#include "sweep/task.hpp"

#include <algorithm>
#include <utility>

#include "scene/parse.hpp"
#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook {

namespace {

/// Replaces `--set key` at the start of a message by the place of the value in the sweep file.
std::string with_place(const std::string& message, const Task& task) {
  for (const auto& [key, chosen] : task.settings) {
    const std::string start = "--set " + key + ": ";
    if (message.starts_with(start)) return chosen.where + ": " + message.substr(start.size());
  }
  return message;
}

[[noreturn]] void fail(const Quantity& quantity, const std::string& problem) {
  throw SceneError(quantity.where + ": collect " + quantity.name + ": " + problem);
}

void require_quantity(const Quantity& quantity, const SceneFile& file) {
  const auto& [scene, fills] = file;
  if (quantity.table != "steps.csv" &&
      std::ranges::count(scene.output.formats, OutputFormat::csv) == 0) {
    fail(quantity, "the scene writes no " + quantity.table + ": its formats lack \"csv\"");
  }
  if (quantity.table == "steps.csv" && !scene.time) {
    fail(quantity, "the scene has no [time], hence no steps");
  }
  if (quantity.needs_cell && !scene.cell) {
    fail(quantity, "the scene has no [cell], hence no column '" + quantity.column + "'");
  }
  const double t_final = scene.time ? scene.time->t_final : 0.0;
  if (quantity.reduction == Reduction::average && quantity.to > t_final) {
    fail(quantity, "the average ends at t = " + short_number(quantity.to, 17) +
                       ", after the run does, at t = " + short_number(t_final, 17));
  }
  const auto require_item = [&](const std::string& items, std::size_t count) {
    if (std::cmp_less(*quantity.item, count)) return;
    fail(quantity, "the scene has " + std::to_string(count) + " " + items +
                       ", numbered from 0; there is no number " + std::to_string(*quantity.item));
  };
  if (quantity.table == "walls.csv") require_item("walls", scene.walls.size());
  // The number of bodies in a fill is unknown until they are placed.
  if (quantity.table == "trajectory.csv" && fills.empty()) {
    require_item("bodies", scene.bodies.size());
  }
}

void require_use_of_seeds(const std::vector<std::vector<AxisValue>>& seeds, bool has_fills) {
  if (seeds.size() < 2 || has_fills) return;
  throw SceneError(seeds[1][0].where +
                   ": seeds: the scene has no [[fill]], so all seeds give the same run; keep one "
                   "seed");
}

}  // namespace

std::vector<std::string> Task::overrides() const {
  std::vector<std::string> texts;
  for (const auto& [key, chosen] : settings) texts.push_back(key + "=" + chosen.value);
  return texts;
}

std::string Task::description() const {
  const auto text_of = [](const Setting& s) { return s.key + " = " + s.chosen.value; };
  return "task " + std::to_string(number) + ": " + joined(settings, ", ", text_of);
}

std::size_t task_count(const Sweep& sweep) {
  std::size_t count = runs_per_combination(sweep);
  for (const Axis& axis : sweep.axes) count *= axis.values.size();
  return count;
}

Task task_of(const Sweep& sweep, std::size_t place) {
  // The place in mixed radix, the last digit first: seed, last axis, ..., first axis.
  std::size_t rest = place;
  std::vector<Setting> settings;
  const auto choose = [&](const Axis& axis) {
    const std::vector<AxisValue>& value = axis.values[rest % axis.values.size()];
    for (std::size_t k = value.size(); k-- > 0;) settings.push_back({axis.keys[k], value[k]});
    rest /= axis.values.size();
  };
  if (!sweep.seeds.values.empty()) choose(sweep.seeds);
  std::for_each(sweep.axes.rbegin(), sweep.axes.rend(), choose);
  std::ranges::reverse(settings);
  return {place, settings};
}

SceneFile scene_of(const Sweep& sweep, const Task& task) {
  try {
    SceneFile file = read_scene(sweep.scene, task.overrides());
    for (const Quantity& quantity : sweep.quantities) require_quantity(quantity, file);
    require_use_of_seeds(sweep.seeds.values, !file.fills.empty());
    return file;
  } catch (const SceneError& error) {
    throw SceneError(with_place(error.what(), task));
  }
}

}  // namespace stokesbook
