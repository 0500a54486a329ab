// Writes the results of a study: tables and figures for the pages, numbers that the chapters quote,
// and the index of all claims.
#include "study/report.hpp"

#include <algorithm>

#include "record/atomic_file.hpp"
#include "study/figures.hpp"
#include "study/tables.hpp"
#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

/// Returns a number as a part of an alias's name: 1e-06 becomes 1em06.
std::string key_of(double x) {
  std::string key = short_number(x, 6);
  std::erase(key, '+');
  std::ranges::replace(key, '.', 'p');
  std::ranges::replace(key, '-', 'm');
  return key;
}

std::string alias(const std::string& name, double value) {
  return "ALIASES += \"" + name + '=' + html_number(value) + "\"\n";
}

std::string csv_row(const std::string& name, const Measurement& point, const std::string& role) {
  const auto& [x, error, unknowns, operations, seconds] = point;
  std::string row = name;
  for (const double value : {x, error, unknowns, operations, seconds}) {
    row += ',' + exact_number(value);
  }
  return row + ',' + role + '\n';
}

/// A table or figure of an experiment, and the end of its file name.
struct Part {
  std::string suffix;
  std::string html;
};

std::vector<Part> parts_of(ExperimentResult result) {
  // A line that this size leaves out appears neither in tables nor in legends.
  const auto is_left_out = [](const LineResult& line) {
    return !line.verdict && line.measurements.empty();
  };
  std::erase_if(result.lines, is_left_out);
  if (result.lines.empty()) {
    return {{"_table.html", "<p>" + std::string(full_size_measures) + "</p>\n"}};
  }
  std::vector<Part> parts{{"_figure.html", convergence_figure(result)},
                          {"_table.html", convergence_table(result)}};
  if (result.experiment.work_precision) {
    parts.push_back({"_work_figure.html", work_precision_figures(result)});
  }
  return parts;
}

/// Returns the anchor of an experiment on the page of its study.
std::string anchor(const StudyResult& result, const Experiment& experiment) {
  return "study_" + result.name + '_' + experiment.key;
}

/// Returns the alias of a claim's badge: a link that shows the measured and the claimed number.
std::string badge(const LineResult& found, const std::string& axis) {
  const Claim& claim = *found.line.claim;
  const std::string law = law_text(claim.law, axis);
  std::string title = claim.statement + " Claimed: " + law + '.', text = claim.id;
  text.replace(text.find('_'), 1, ".");
  if (found.verdict) {
    const bool is_bound = law.find("<=") != std::string::npos;
    text += ": " + html_number(found.verdict->measured) + "<small> claimed " +
            (is_bound ? "&le;&nbsp;" : "") + html_number(claimed_number(claim.law)) + "</small>";
    title += " Measured: " + found.verdict->explanation + ". Planted error " +
             (found.control->is_rejected() ? "" : "not ") + "detected.";
  } else {
    text += ": full size only";
  }
  return "ALIASES += \"badge_" + claim.id +
         R"(=@htmlonly <a class=\"badge\" href=\"claims.html#claim_)" + claim.id +
         R"(\" title=\")" + escaped(title) + R"(\">)" + text + "</a>@endhtmlonly\"\n";
}

/// Returns the entry of a claim in the index of claims, as Markdown: a sentence, and folded details.
std::string claim_entry(const StudyResult& result, const Experiment& experiment,
                        const LineResult& found) {
  const Claim& claim = *found.line.claim;
  std::string about;
  for (const std::string& name : claim.api) about += ", @ref " + name;
  return "@htmlonly[block]<div class=\"claim\">@endhtmlonly\n@anchor claim_" + claim.id + '\n' +
         escaped(claim.statement) + " \\badge_" + claim.id +
         "\n@htmlonly[block]<details><summary>" + escaped(law_text(claim.law, experiment.x)) +
         "; " + escaped(found.line.label) +
         "</summary>@endhtmlonly\n\n- Reason: " + escaped(claim.reason) + "\n- " +
         evidence_html(found, "\n- ") + "\n- See @ref " + anchor(result, experiment) + about +
         "\n\n@htmlonly[block]</details></div>@endhtmlonly\n\n";
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
  for (const auto& [experiment, lines] : result.experiments) {
    for (const auto& [line, measurements, verdict, control] : lines) {
      const std::string name = experiment.key + ',' + line.key;
      for (std::size_t i = 0; i < measurements.size(); ++i) {
        const bool used = !verdict || verdict->used[i];
        csv += csv_row(name, measurements[i], used ? "used" : "left out");
      }
      if (!control) continue;
      for (const Measurement& point : control->measurements) csv += csv_row(name, point, "control");
    }
  }
  return csv;
}

std::string to_aliases(const StudyResult& result) {
  std::string text;
  for (const auto& [experiment, lines] : result.experiments) {
    for (const LineResult& found : lines) {
      const auto& [line, measurements, verdict, _] = found;
      const std::string name = "val_" + result.number + '_' + experiment.key + '_' + line.key;
      for (const Measurement& point : measurements) {
        text += alias(name + '_' + key_of(point.x), point.error);
      }
      if (!line.claim) continue;
      text += badge(found, experiment.x);
      text += alias("val_claim_" + line.claim->id + "_claimed", claimed_number(line.claim->law));
      if (verdict) text += alias("val_claim_" + line.claim->id, verdict->measured);
    }
  }
  return text;
}

std::string study_page(const StudyResult& result, const std::string& origin) {
  std::string page = "# Study " + result.number + ": " + result.title + " {#study_" + result.name +
                     "}\n\nAll that was measured for @ref chapter_" + result.number +
                     " in this build: " + escaped(origin) + ".\n\n";
  for (const ExperimentResult& found : result.experiments) {
    const Experiment& experiment = found.experiment;
    page += "## " + experiment.title + " {#" + anchor(result, experiment) + "}\n\n";
    for (const Part& part : parts_of(found)) {
      page += "@htmlinclude " + result.name + '_' + experiment.key + part.suffix + "\n";
    }
    page += '\n';
  }
  return page;
}

std::string claims_page(const std::vector<StudyResult>& results) {
  std::string page =
      "# Index of claims {#claims}\n\n"
      "Every claim of accuracy or cost that the book makes, as this build has measured it. A claim "
      "holds when the number measured lies in its band and the same check detects the planted "
      "error.\n\n";
  for (const StudyResult& result : results) {
    page += "## " + result.number + " " + result.title + " {#claims_" + result.name +
            "}\n\nChapter: @ref chapter_" + result.number + ". Library: @ref " + result.name +
            ". All measurements: @subpage study_" + result.name + ".\n\n";
    for (const auto& [experiment, lines] : result.experiments) {
      for (const LineResult& found : lines) {
        if (found.line.claim) page += claim_entry(result, experiment, found);
      }
    }
  }
  return page;
}

void write_report(const StudyResult& result, const std::string& origin,
                  const std::filesystem::path& directory) {
  const auto write = [&](const std::string& name, const std::string& text) {
    write_atomically(directory / (result.name + name), text, SafeFrom::kill);
  };
  write(".csv", to_csv(result));
  write(".aliases", to_aliases(result));
  write("_study.md", study_page(result, origin));
  for (const ExperimentResult& found : result.experiments) {
    for (const Part& part : parts_of(found)) {
      write('_' + found.experiment.key + part.suffix, part.html);
    }
  }
}

void write_index(const std::vector<StudyResult>& results, const std::string& origin,
                 const std::filesystem::path& directory) {
  write_atomically(directory / "claims.md", claims_page(results), SafeFrom::kill);
  std::string html =
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>Studies</title>\n" +
      std::string(index_style) + "</head><body>\n<h1>Studies</h1>\n<p>" + escaped(origin) +
      "</p>\n";
  for (const StudyResult& result : results) {
    html += "<h2>" + result.number + ' ' + escaped(result.title) + "</h2>\n" + claims_list(result);
    for (const ExperimentResult& found : result.experiments) {
      html += "<h3>" + escaped(found.experiment.title) + "</h3>\n";
      for (const Part& part : parts_of(found)) html += part.html;
    }
  }
  write_atomically(directory / "index.html", html + "</body></html>\n", SafeFrom::kill);
}

}  // namespace stokesbook::study
