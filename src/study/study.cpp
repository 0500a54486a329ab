// Runs a study: measures each line of each experiment, and checks the claims and their controls.
#include "study/study.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <set>
#include <stdexcept>

#include "text/word_list.hpp"

namespace stokesbook::study {

namespace {

void require(bool condition, const std::string& what) {
  if (!condition) throw std::logic_error("study: " + what);
}

/// Finds mistakes in the declaration of a study before anything is measured.
void validate(const Study& study) {
  std::set<std::string> experiments, ids;
  for (const Experiment& experiment : study.experiments) {
    require(is_name(experiment.key), "key of an experiment: '" + experiment.key + "'");
    require(experiments.insert(experiment.key).second, "two experiments " + experiment.key);
    std::set<std::string> lines;
    for (const Line& line : experiment.lines) {
      const std::string name = experiment.key + '.' + line.key;
      require(is_name(line.key), "key of a line: '" + name + "'");
      require(lines.insert(line.key).second, "two lines " + name);
      require(line.claim.has_value() == line.control.has_value(),
              name + ": a claim and its control belong together");
      if (!line.claim) continue;
      require(line.claim->id.starts_with(study.number + '_') && is_name(line.claim->id),
              name + ": the claim's id must be " + study.number + "_ and a number");
      require(ids.insert(line.claim->id).second, "two claims " + line.claim->id);
    }
  }
}

LineResult measure(const Line& line, Size size) {
  LineResult result{line};
  if (size < line.least) return result;
  result.measurements = line.measure(size);
  if (!line.claim) return result;
  result.verdict = check(*line.claim, result.measurements);
  const std::vector<Measurement> defective = line.control->measure(size);
  result.control = {defective, check(*line.claim, defective)};
  return result;
}

bool has_measured(const LineResult& line, double Measurement::*quantity) {
  return std::ranges::any_of(
      line.measurements, [=](const Measurement& point) { return std::isfinite(point.*quantity); });
}

void report(std::ostream& progress, const LineResult& result) {
  if (!result.verdict) return;
  const Line& line = result.line;
  progress << "  " << line.claim->id << "  " << to_string(result.verdict->outcome) << "  "
           << line.label << ": " << result.verdict->explanation << '\n';
  if (!result.control->is_rejected()) {
    progress << "  " << line.claim->id << "  fails  not rejected, with the defect "
             << line.control->defect << ": " << result.control->verdict.explanation << '\n';
  }
  progress.flush();
}

}  // namespace

Experiment left_to_full(Experiment experiment) {
  for (Line& line : experiment.lines) line.least = Size::full;
  return experiment;
}

std::vector<CostMeasure> measured_costs(const ExperimentResult& result) {
  std::vector<CostMeasure> costs{{"unknowns", &Measurement::unknowns},
                                 {result.experiment.operation, &Measurement::operations},
                                 {"seconds on this machine", &Measurement::seconds}};
  std::erase_if(costs, [&](const CostMeasure& cost) {
    return std::ranges::none_of(
        result.lines, [&](const LineResult& line) { return has_measured(line, cost.value); });
  });
  return costs;
}

bool LineResult::holds() const {
  return !verdict || (verdict->outcome == Outcome::holds && control->is_rejected());
}

bool StudyResult::holds() const {
  return std::ranges::all_of(experiments, [](const ExperimentResult& result) {
    return std::ranges::all_of(result.lines, &LineResult::holds);
  });
}

StudyResult run(const Study& study, Size size, std::ostream& progress) {
  validate(study);
  progress << study.number << ' ' << study.title << '\n';
  StudyResult result{study.number, study.name, study.title, {}};
  for (const Experiment& experiment : study.experiments) {
    std::vector<LineResult> lines;
    for (const Line& line : experiment.lines) {
      lines.push_back(measure(line, size));
      require(
          !experiment.operation.empty() || !has_measured(lines.back(), &Measurement::operations),
          experiment.key + '.' + line.key + " counts operations; set Experiment::operation");
      report(progress, lines.back());
    }
    result.experiments.push_back({experiment, lines});
  }
  return result;
}

}  // namespace stokesbook::study
