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

std::string span(std::size_t columns) {
  return " colspan=\"" + std::to_string(columns) + '"';
}

/// Returns a table in a frame, in which wide tables can be scrolled on narrow screens.
std::string table(const std::string& caption, const std::string& body) {
  return "<div class=\"study-table\"><table>\n<caption>" + caption + "</caption>\n" + body +
         "</table></div>\n";
}

std::string claim_link(const Claim& claim) {
  return "<a href=\"claims.html#claim_" + claim.id + "\">" + claim.id + "</a>";
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
    if (axes != Axes::nominal) text += cell(html_number(slopes[i]), grey);
    if (cost) text += cell(html_number(point.*cost->value), grey);
    cells.emplace(point.x, text);
  }
  return cells;
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  }
  return result;
}

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
  const std::string spanned = span(heads.size());
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
    claimed +=
        cell(claim ? claim_link(*claim) + ": " + escaped(law_text(claim->law, experiment.x)) : "",
             spanned);
    measured += cell(found.verdict ? html_number(found.verdict->measured) : "", spanned);
    verdict += cell(verdict_html(found), spanned);
  }
  std::string body = "<thead>" + row(names) + row(columns) + "</thead>\n<tbody>\n";
  for (const auto& [x, text] : rows) body += row(text);
  body += "</tbody>\n<tfoot>" + row(claimed) + row(measured) + row(verdict) + "</tfoot>";
  const std::string caption =
      escaped(experiment.title) + ". Shown: " + escaped(experiment.error) + '.';
  return table(caption + (cost ? " Cost: " + escaped(cost->name) + '.' : ""), body);
}

std::string claims_table(const StudyResult& result) {
  std::string body;
  for (const auto& [experiment, lines] : result.experiments) {
    for (const LineResult& found : lines) {
      if (!found.line.claim) continue;
      const Claim& claim = *found.line.claim;
      body +=
          row(head("<a id=\"claim_" + claim.id + "\"></a>" + claim.id) +
              cell(escaped(claim.statement) + "<br><small>" + escaped(claim.reason) + "</small>") +
              cell(escaped(law_text(claim.law, experiment.x))) +
              (found.verdict ? cell(escaped(found.verdict->explanation)) +
                                   cell(control_html(found)) + cell(verdict_html(found))
                             : cell(full_size_measures, span(3))));
    }
  }
  return table(escaped(result.title),
               "<thead><tr><th>claim</th><th>statement, reason</th><th>law</th><th>measured</th>"
               "<th>planted error</th><th>verdict</th></tr>\n</thead>\n<tbody>\n" +
                   body + "</tbody>");
}

std::string verdict_html(const LineResult& result) {
  if (!result.verdict) return "shown for comparison";
  const std::string text = to_string(result.verdict->outcome);
  if (result.holds()) return text;
  const bool only_control = result.verdict->outcome == Outcome::holds;
  return "<b>" + text + (only_control ? ", but its planted error is not detected" : "") + "</b>";
}

std::string control_html(const LineResult& result) {
  return escaped(result.line.control->defect) +
         (result.control->is_rejected() ? ": detected" : ": <b>not detected</b>");
}

}  // namespace stokesbook::study
