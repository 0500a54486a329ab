// Writes the tables of a study as HTML, convergence and claims, and the numbers in them.
#include "study/tables.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "text/number_text.hpp"
#include "text/word_list.hpp"

namespace stokesbook::study {

namespace {

std::string cell(const std::string& content, const std::string& attributes = {}) {
  return "<td" + attributes + '>' + content + "</td>";
}

std::string head(const std::string& content, const std::string& attributes = {}) {
  return "<th" + attributes + '>' + content + "</th>";
}

std::string row(const std::string& cells) {
  return "<tr>" + cells + "</tr>\n";
}

/// Returns the cost that a convergence table shows beside the errors: the counted operations, else
/// the unknowns, else no value; no cost that is x. Work-precision figures show all, also seconds.
std::optional<CostMeasure> shown_cost(const ExperimentResult& result) {
  std::vector<CostMeasure> costs = measured_costs(result);
  std::erase_if(costs, [&](const CostMeasure& cost) {
    const auto is_x = [&](const Measurement& point) { return point.*cost.value == point.x; };
    return cost.value == &Measurement::seconds ||
           std::ranges::all_of(result.lines, [&](const LineResult& line) {
             return std::ranges::all_of(line.measurements, is_x);
           });
  });
  if (costs.empty()) return std::nullopt;
  return costs.back();
}

/// Returns the cells of a line in a convergence table by their x: error, slope and cost of each
/// measurement. The slope is the order or rate since the measurement before, on axes that have one.
std::map<double, std::string> cells_of(const LineResult& line, Axes axes,
                                       const std::optional<CostMeasure>& cost) {
  const std::vector<double> slopes =
      axes == Axes::log_log ? local_orders(line.measurements) : local_rates(line.measurements);
  std::map<double, std::string> cells;
  for (std::size_t i = 0; i < line.measurements.size(); ++i) {
    const Measurement& point = line.measurements[i];
    const bool used = !line.verdict || line.verdict->used[i];
    const std::string grey = used ? "" : " class=\"left-out\"";
    std::string text = cell(html_number(point.error), grey);
    if (axes == Axes::log_log || axes == Axes::semi_log) text += cell(html_number(slopes[i]), grey);
    if (cost) text += cell(html_number(point.*cost->value), grey);
    cells.emplace(point.x, text);
  }
  return cells;
}

}  // namespace

std::string html_number(double x) {
  if (std::isnan(x)) return "&ndash;";
  const bool is_count = x == std::floor(x) && std::abs(x) < 1e6;
  const std::string text = short_number(x, is_count ? 6 : 3);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  return text.substr(0, e) + "&middot;10<sup>" + std::to_string(std::stoi(text.substr(e + 1))) +
         "</sup>";
}

std::string convergence_table(const ExperimentResult& result) {
  const auto& [experiment, lines] = result;
  const std::optional<CostMeasure> cost = shown_cost(result);
  const bool has_errors = experiment.error.find("error") != std::string::npos;
  std::vector<std::string> heads{head(has_errors ? "error" : "value")};
  if (experiment.axes == Axes::log_log) heads.push_back(head("order"));
  if (experiment.axes == Axes::semi_log) heads.push_back(head("rate"));
  if (cost) heads.push_back(head("cost"));
  const std::string spanned = " colspan=\"" + std::to_string(heads.size()) + '"';
  std::string names = head(escaped(experiment.x), " rowspan=\"2\""), columns;
  std::string claimed = head("claimed"), measured = head("measured"), verdict = head("verdict");
  std::map<double, std::string> rows;
  for (const LineResult& found : lines) {
    for (const Measurement& point : found.measurements) rows[point.x] = head(html_number(point.x));
  }
  for (const LineResult& found : lines) {
    names += head(escaped(found.line.label), spanned);
    columns += joined(heads, "");
    const auto cells = cells_of(found, experiment.axes, cost);
    for (auto& [x, text] : rows) text += cells.contains(x) ? cells.at(x) : cell("", spanned);
    const std::optional<Claim>& claim = found.line.claim;
    claimed += cell(claim ? "<a href=\"claims.html#claim_" + claim->id + "\">" + claim->id +
                                "</a>: " + escaped(law_text(claim->law, experiment.x))
                          : "",
                    spanned);
    measured += cell(found.verdict ? html_number(found.verdict->measured) : "", spanned);
    verdict += cell(verdict_html(found), spanned);
  }
  // In its frame, a wide table can be scrolled on a narrow screen.
  std::string html = "<div class=\"study-table\"><table>\n<caption>" + escaped(experiment.title) +
                     ". Shown: " + escaped(experiment.error) + '.' +
                     (cost ? " Cost: " + escaped(cost->name) + '.' : "") + "</caption>\n<thead>" +
                     row(names) + row(columns) + "</thead>\n<tbody>\n";
  for (const auto& [x, text] : rows) html += row(text);
  return html + "</tbody>\n<tfoot>" + row(claimed) + row(measured) + row(verdict) +
         "</tfoot></table></div>\n";
}

std::string claims_list(const StudyResult& result) {
  std::string list;
  for (const auto& [experiment, lines] : result.experiments) {
    for (const LineResult& found : lines) {
      if (!found.line.claim) continue;
      const Claim& claim = *found.line.claim;
      list += "<p id=\"claim_" + claim.id + "\"><b>" + claim.id + "</b> " +
              escaped(claim.statement) +
              "<br>\n<small>Claimed: " + escaped(law_text(claim.law, experiment.x)) +
              "<br>\nReason: " + escaped(claim.reason) + "<br>\n" + evidence_html(found, "<br>\n") +
              "</small></p>\n";
    }
  }
  return list;
}

std::string verdict_html(const LineResult& result) {
  if (!result.verdict) return "shown for comparison";
  const std::string text = to_string(result.verdict->outcome);
  if (result.holds()) return text;
  const bool only_control = result.verdict->outcome == Outcome::holds;
  return "<b>" + text + (only_control ? ", but its planted error is not detected" : "") + "</b>";
}

std::string evidence_html(const LineResult& result, const std::string& separator) {
  if (!result.verdict) return full_size_measures;
  return "Measured: " + escaped(result.verdict->explanation) + ": " + verdict_html(result) +
         separator + "Planted error: " + escaped(result.line.control->defect) +
         (result.control->is_rejected() ? ": detected" : ": <b>not detected</b>");
}

}  // namespace stokesbook::study
