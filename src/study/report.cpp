// Writes the results of a study: tables and figures for the pages, numbers that the chapters quote,
// and the index of all claims.
#include "study/report.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <nlohmann/json.hpp>

#include "record/atomic_file.hpp"
#include "study/figures.hpp"
#include "study/html.hpp"
#include "study/tables.hpp"
#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

using Json = nlohmann::ordered_json;

/// Calls visit(experiment, line, result) for all lines of a study, in order.
template <class Visit>
void for_each_line(const StudyResult& result, const Visit& visit) {
  for (std::size_t e = 0; e < result.experiments.size(); ++e) {
    const Experiment& experiment = result.study.experiments[e];
    for (std::size_t k = 0; k < experiment.lines.size(); ++k) {
      visit(experiment, experiment.lines[k], result.experiments[e][k]);
    }
  }
}

/// Returns a number as a part of an alias's name: 1e-06 becomes 1em06.
std::string key_of(double x) {
  std::string key;
  for (const char c : short_number(x, 6)) {
    if (c == '.') {
      key += 'p';
    } else if (c == '-') {
      key += 'm';
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      key += c;
    }
  }
  return key;
}

std::string alias(const std::string& name, double value) {
  return "ALIASES += \"" + name + '=' + html_number(value) + "\"\n";
}

void append_rows(std::string& csv, const std::string& name,
                 const std::vector<Measurement>& measurements, const auto& role) {
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const Measurement& point = measurements[i];
    csv += name;
    for (const double value :
         {point.x, point.error, point.unknowns, point.operations, point.seconds}) {
      csv += ',';
      append_number(csv, value);
    }
    csv += ',';
    csv += role(i);
    csv += '\n';
  }
}

Json json_of(const std::vector<Measurement>& measurements) {
  Json rows = Json::array();
  for (const Measurement& point : measurements) {
    rows.push_back({{"x", point.x},
                    {"error", point.error},
                    {"unknowns", point.unknowns},
                    {"operations", point.operations},
                    {"seconds", point.seconds}});
  }
  return rows;
}

Json json_of(const Verdict& verdict) {
  return {{"outcome", to_string(verdict.outcome)},
          {"measured", verdict.measured},
          {"explanation", verdict.explanation},
          {"used", verdict.used}};
}

Json json_of(const Experiment& experiment, const Line& line, const LineResult& result) {
  Json json{{"label", line.label}, {"measurements", json_of(result.measurements)}};
  if (!line.claim) return json;
  json["claim"] = {{"id", line.claim->id},
                   {"statement", line.claim->statement},
                   {"law", law_text(line.claim->law, experiment.x)},
                   {"claimed", claimed_number(line.claim->law)},
                   {"reason", line.claim->reason},
                   {"api", line.claim->api},
                   {"error", experiment.error}};
  if (!result.verdict) return json;
  json["verdict"] = json_of(*result.verdict);
  json["control"] = {{"defect", line.control->defect},
                     {"rejected", result.control->rejected()},
                     {"verdict", json_of(result.control->verdict)},
                     {"measurements", json_of(result.control->measurements)}};
  return json;
}

std::string provenance_text(const Provenance& provenance) {
  return "stokesbook " + provenance.version + ", commit " + provenance.git_hash + ", " +
         provenance.compiler + " (" + provenance.flags + "), " + provenance.machine;
}

/// A table or figure of an experiment, and the end of its file name.
struct Part {
  std::string suffix;
  std::string html;
};

std::vector<Part> parts_of(Experiment experiment, std::vector<LineResult> lines) {
  // A line that this size leaves out appears neither in tables nor in legends.
  for (std::size_t k = lines.size(); k-- > 0;) {
    if (lines[k].verdict || !lines[k].measurements.empty()) continue;
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
    experiment.lines.erase(experiment.lines.begin() + static_cast<std::ptrdiff_t>(k));
  }
  if (lines.empty()) return {{"_table.html", "<p>" + std::string(full_size_measures) + "</p>\n"}};
  std::vector<Part> parts{{"_figure.html", convergence_figure(experiment, lines)},
                          {"_table.html", convergence_table(experiment, lines)}};
  if (experiment.work_precision) {
    parts.push_back({"_work_figure.html", work_precision_figures(experiment, lines)});
    parts.push_back({"_work_table.html", work_precision_table(experiment, lines)});
  }
  return parts;
}

/// Returns the anchor of an experiment on the page of its study.
std::string anchor(const StudyResult& result, const Experiment& experiment) {
  return "study_" + result.study.name + '_' + experiment.key;
}

/// Returns the section of a study in `index.html`.
std::string section(const StudyResult& result) {
  std::string html = "<h2>" + result.study.number + ' ' + escaped(result.study.title) + "</h2>\n" +
                     claims_table(result);
  for (std::size_t e = 0; e < result.experiments.size(); ++e) {
    const Experiment& experiment = result.study.experiments[e];
    html += "<h3>" + escaped(experiment.title) + "</h3>\n";
    for (const Part& part : parts_of(experiment, result.experiments[e])) html += part.html;
  }
  return html;
}

constexpr const char* index_style =
    "<style>:root{color-scheme:light dark}body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;"
    "margin:2rem auto;padding:0 1rem}table{border-collapse:collapse;font-size:14px}"
    "th,td{padding:.2rem .6rem;border-bottom:1px solid #8886;text-align:left}"
    ".study-table{overflow-x:auto}caption{text-align:left;font-weight:600;padding:.6rem}"
    ".left-out{opacity:.5}svg{max-width:100%;height:auto}</style>\n";

}  // namespace

std::string to_csv(const StudyResult& result) {
  std::string csv = "experiment,line,x,error,unknowns,operations,seconds,role\n";
  for_each_line(
      result, [&](const Experiment& experiment, const Line& line, const LineResult& found) {
        const std::string name = experiment.key + ',' + line.key;
        append_rows(csv, name, found.measurements, [&](std::size_t i) {
          return !found.verdict || found.verdict->used[i] ? "used" : "left out";
        });
        if (!found.control) return;
        append_rows(csv, name, found.control->measurements, [](std::size_t) { return "control"; });
      });
  return csv;
}

std::string to_json(const StudyResult& result, const Provenance& provenance) {
  Json lines;
  for_each_line(result,
                [&](const Experiment& experiment, const Line& line, const LineResult& found) {
                  lines[experiment.key][line.key] = json_of(experiment, line, found);
                });
  const Json json{{"study", result.study.name},
                  {"size", result.size == Size::full ? "full" : "quick"},
                  {"holds", result.holds()},
                  {"version", provenance.version},
                  {"git_hash", provenance.git_hash},
                  {"compiler", provenance.compiler},
                  {"flags", provenance.flags},
                  {"machine", provenance.machine},
                  {"experiments", lines}};
  return json.dump(1) + '\n';
}

std::string to_aliases(const StudyResult& result) {
  std::string text;
  for_each_line(result, [&](const Experiment& experiment, const Line& line,
                            const LineResult& found) {
    const std::string name = "val_" + result.study.number + '_' + experiment.key + '_' + line.key;
    for (const Measurement& point : found.measurements) {
      text += alias(name + '_' + key_of(point.x), point.error);
    }
    if (!line.claim) return;
    text += alias("val_claim_" + line.claim->id + "_claimed", claimed_number(line.claim->law));
    if (found.verdict) text += alias("val_claim_" + line.claim->id, found.verdict->measured);
  });
  return text;
}

std::string study_page(const StudyResult& result, const Provenance& provenance) {
  std::string page = "# Study " + result.study.number + ": " + result.study.title + " {#study_" +
                     result.study.name + "}\n\nAll that was measured for @ref chapter_" +
                     result.study.number +
                     " in this build: " + escaped(provenance_text(provenance)) + ".\n\n";
  for (std::size_t e = 0; e < result.experiments.size(); ++e) {
    const Experiment& experiment = result.study.experiments[e];
    page += "## " + experiment.title + " {#" + anchor(result, experiment) + "}\n\n";
    for (const Part& part : parts_of(experiment, result.experiments[e])) {
      page += "@htmlinclude " + result.study.name + '_' + experiment.key + part.suffix + "\n";
    }
    page += '\n';
  }
  return page;
}

std::string claims_page(const std::vector<StudyResult>& results) {
  std::string page =
      "# Index of claims {#claims}\n\n"
      "Every claim of accuracy or cost that the book makes, as this build has measured it. A claim "
      "holds when the number measured lies in its band and the same check rejects the planted "
      "defect.\n\n";
  for (const StudyResult& result : results) {
    page += "## " + result.study.number + " " + result.study.title + " {#claims_" +
            result.study.name + "}\n\nChapter: @ref chapter_" + result.study.number +
            ". Library: @ref " + result.study.name + ". All measurements: @subpage study_" +
            result.study.name + ".\n\n";
    for_each_line(
        result, [&](const Experiment& experiment, const Line& line, const LineResult& found) {
          if (!line.claim) return;
          page += "@anchor claim_" + line.claim->id + "\n**" + line.claim->id + "**, " +
                  escaped(line.label) + ": " + escaped(line.claim->statement) + " \n<small>" +
                  escaped(line.claim->reason) + "</small>\n\n";
          if (!found.verdict) {
            page += full_size_measures + (" See @ref " + anchor(result, experiment)) + ".\n\n";
            return;
          }
          page +=
              "| claimed | measured | control | verdict | study | about "
              "|\n|---|---|---|---|---|---|\n| " +
              escaped(law_text(line.claim->law, experiment.x)) + " | " +
              escaped(found.verdict->explanation) + " | " + escaped(line.control->defect) + ": " +
              (found.control->rejected() ? "rejected" : "**not rejected**") + " | " +
              (found.holds() ? found.verdict_text() : "**" + found.verdict_text() + "**") +
              " | @ref " + anchor(result, experiment) + " |";
          for (const std::string& name : line.claim->api) page += " @ref " + name;
          page += " |\n\n";
        });
  }
  return page;
}

void write_report(const StudyResult& result, const Provenance& provenance,
                  const std::filesystem::path& directory) {
  const auto write = [&](const std::string& name, const std::string& text) {
    write_atomically(directory / (result.study.name + name), text, SafeFrom::kill);
  };
  write(".csv", to_csv(result));
  write(".json", to_json(result, provenance));
  write(".aliases", to_aliases(result));
  write("_study.md", study_page(result, provenance));
  for (std::size_t e = 0; e < result.experiments.size(); ++e) {
    for (const Part& part : parts_of(result.study.experiments[e], result.experiments[e])) {
      write('_' + result.study.experiments[e].key + part.suffix, part.html);
    }
  }
}

void write_index(const std::vector<StudyResult>& results, const Provenance& provenance,
                 const std::filesystem::path& directory) {
  write_atomically(directory / "claims.md", claims_page(results), SafeFrom::kill);
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>Studies</title>\n" +
      std::string(index_style) + "</head><body>\n<h1>Studies</h1>\n<p>" +
      escaped(provenance_text(provenance)) + "</p>\n";
  for (const StudyResult& result : results) html += section(result);
  write_atomically(directory / "index.html", html + "</body></html>\n", SafeFrom::kill);
}

}  // namespace stokesbook::study
