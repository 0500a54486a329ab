// Prints the results of hard cases, and writes them as an HTML table.
#include "report.hpp"

#include <cstdio>
#include <ostream>

#include "study/tables.hpp"

namespace stokesbook::verification::hard_cases {

namespace {

std::string verdict(const Row& row) {
  if (!is_met(row.hard, row.finding)) return "FAILED";
  return row.finding.refusal.empty() ? "answered" : "refused";
}

}  // namespace

void print(std::ostream& out, const Row& row) {
  const auto& [hard, finding, seconds] = row;
  char numbers[160];
  std::snprintf(numbers, sizeof numbers,
                "%-9s%6.1f s   tolerance %-8.0e error %-8.1e estimate %-8.1e", verdict(row).c_str(),
                seconds, finding.tolerance, finding.error, finding.estimate);
  out << hard.chapter << "  " << hard.asked << "\n    " << numbers << ", " << finding.iterations
      << " iterations\n";
  if (!finding.refusal.empty()) out << "    " << finding.refusal << '\n';
  out << std::flush;
}

void write_table(std::ostream& out, const std::vector<Row>& rows) {
  out << "<div class=\"study-table\"><table>\n"
         "<tr><th></th><th class=\"sentence\">problem</th><th>tolerance</th><th>error</th>"
         "<th>estimate</th><th>iterations</th><th></th></tr>\n";
  for (const Row& row : rows) {
    const auto& [hard, finding, seconds] = row;
    out << "<tr><td>" << hard.chapter << "</td><td>" << study::escaped(hard.asked) << "</td>";
    if (finding.refusal.empty()) {
      for (const double number : {finding.tolerance, finding.error, finding.estimate}) {
        out << "<td>" << study::html_number(number) << "</td>";
      }
      out << "<td>" << (finding.iterations > 0 ? std::to_string(finding.iterations) : "")
          << "</td>";
    } else {
      out << "<td colspan=\"4\">" << study::escaped(finding.refusal) << "</td>";
    }
    out << "<td>" << verdict(row) << "</td></tr>\n";
  }
  out << "</table></div>\n";
}

}  // namespace stokesbook::verification::hard_cases
