// Writes the tables of a study as HTML: convergence, work against error, and claims.
#include "study/tables.hpp"

#include <optional>
#include <set>
#include <span>

#include "study/html.hpp"

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

std::string caption(const Experiment& experiment) {
  return escaped(experiment.title) + ". Error: " + escaped(experiment.error) + '.';
}

std::string verdict_cell(const LineResult& result, const std::string& attributes) {
  if (!result.verdict) return cell("shown for comparison", attributes);
  const std::string text = result.verdict_text();
  return cell(result.holds() ? text : "<b>" + text + "</b>", attributes);
}

std::string claim_link(const Claim& claim) {
  return "<a href=\"claims.html#claim_" + claim.id + "\">" + claim.id + "</a>";
}

/// Returns three cells: the measurement of a claim, the result of its control, and the verdict.
std::string evidence(const Line& line, const LineResult& found) {
  return cell(escaped(found.verdict->explanation)) +
         cell(escaped(line.control->defect) + ": " +
              (found.control->rejected() ? "rejected" : "<b>not rejected</b>")) +
         verdict_cell(found, "");
}

/// Returns the cost that a convergence table shows beside the errors: the counted operations, else
/// the unknowns, else no value. Work-precision tables show all costs, including seconds.
std::optional<CostMeasure> shown_cost(const Experiment& experiment,
                                      const std::vector<LineResult>& lines) {
  std::vector<CostMeasure> costs = measured_costs(experiment, lines);
  std::erase_if(costs, [](const CostMeasure& cost) { return cost.value == &Measurement::seconds; });
  if (costs.empty()) return std::nullopt;
  return costs.back();
}

/// The measure of convergence between neighbouring points, by the axes: order or rate.
struct Slope {
  std::string name;
  std::vector<double> (*between)(std::span<const Measurement>);
};

std::optional<Slope> shown_slope(Axes axes) {
  switch (axes) {
    case Axes::log_log:
      return Slope{"order", local_orders};
    case Axes::semi_log:
      return Slope{"rate", local_rates};
    case Axes::nominal:
      break;
  }
  return std::nullopt;
}

/// The columns that a convergence table has for each line.
struct LineColumns {
  std::optional<Slope> slope;
  std::optional<CostMeasure> cost;
  std::size_t count() const { return 1 + (slope ? 1 : 0) + (cost ? 1 : 0); }
};

/// Returns error, slope and cost of a line at x, or an empty cell without a measurement at x.
std::string cells_at(const LineResult& line, const std::vector<double>& slopes,
                     const LineColumns& columns, double x) {
  for (std::size_t i = 0; i < line.measurements.size(); ++i) {
    if (line.measurements[i].x != x) continue;
    const bool used = !line.verdict || line.verdict->used[i];
    const std::string grey = used ? "" : " class=\"left-out\"";
    const Measurement& point = line.measurements[i];
    return cell(html_number(point.error), grey) +
           (columns.slope ? cell(html_number(slopes[i]), grey) : "") +
           (columns.cost ? cell(html_number(point.*columns.cost->value), grey) : "");
  }
  return cell("", span(columns.count()));
}

}  // namespace

std::string convergence_table(const Experiment& experiment, const std::vector<LineResult>& lines) {
  const LineColumns each{shown_slope(experiment.axes), shown_cost(experiment, lines)};
  const auto& cost = each.cost;
  std::string names = head(escaped(experiment.x), " rowspan=\"2\""), columns;
  std::string claimed = head("claimed"), measured = head("measured"), verdict = head("verdict");
  const std::string spanned = span(each.count());
  std::vector<std::vector<double>> slopes;
  std::set<double> xs;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Line& line = experiment.lines[k];
    const LineResult& result = lines[k];
    slopes.push_back(each.slope ? each.slope->between(result.measurements) : std::vector<double>{});
    names += head(escaped(line.label), spanned);
    columns +=
        head("error") + (each.slope ? head(each.slope->name) : "") + (cost ? head("cost") : "");
    for (const Measurement& point : result.measurements) xs.insert(point.x);
    claimed += cell(line.claim ? claim_link(*line.claim) + ": " +
                                     escaped(law_text(line.claim->law, experiment.x))
                               : "",
                    spanned);
    measured += cell(result.verdict ? html_number(result.verdict->measured) : "", spanned);
    verdict += verdict_cell(result, spanned);
  }
  std::string body = "<thead>" + row(names) + row(columns) + "</thead>\n<tbody>\n";
  for (const double x : xs) {
    std::string cells = head(html_number(x));
    for (std::size_t k = 0; k < lines.size(); ++k) cells += cells_at(lines[k], slopes[k], each, x);
    body += row(cells);
  }
  body += "</tbody>\n<tfoot>" + row(claimed) + row(measured) + row(verdict) + "</tfoot>";
  return table(caption(experiment) + (cost ? " Cost: " + escaped(cost->name) + '.' : ""), body);
}

std::string work_precision_table(const Experiment& experiment,
                                 const std::vector<LineResult>& lines) {
  std::vector<CostMeasure> columns = measured_costs(experiment, lines);
  columns.insert(columns.begin(),
                 {{experiment.x, &Measurement::x}, {"error", &Measurement::error}});
  std::string names = head("method"), body;
  for (const CostMeasure& column : columns) names += head(escaped(column.name));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    for (const Measurement& point : lines[k].measurements) {
      std::string cells = head(escaped(experiment.lines[k].label));
      for (const CostMeasure& column : columns) cells += cell(html_number(point.*column.value));
      body += row(cells);
    }
  }
  return table(caption(experiment),
               "<thead>" + row(names) + "</thead>\n<tbody>\n" + body + "</tbody>");
}

std::string claims_table(const StudyResult& result) {
  std::string body;
  for (std::size_t e = 0; e < result.experiments.size(); ++e) {
    const Experiment& experiment = result.study.experiments[e];
    for (std::size_t k = 0; k < experiment.lines.size(); ++k) {
      const Line& line = experiment.lines[k];
      const LineResult& found = result.experiments[e][k];
      if (!line.claim) continue;
      body += row(head("<a id=\"claim_" + line.claim->id + "\"></a>" + line.claim->id) +
                  cell(escaped(line.claim->statement) + "<br><small>" +
                       escaped(line.claim->reason) + "</small>") +
                  cell(escaped(law_text(line.claim->law, experiment.x))) +
                  (found.verdict ? evidence(line, found) : cell(full_size_measures, span(3))));
    }
  }
  return table(escaped(result.study.title),
               "<thead>" +
                   row(head("claim") + head("statement, reason") + head("law") + head("measured") +
                       head("control") + head("verdict")) +
                   "</thead>\n<tbody>\n" + body + "</tbody>");
}

}  // namespace stokesbook::study
