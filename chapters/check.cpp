// Compares a reader's results with exact values, and reports on every task. All checks of the
// exercises share this code, which is compiled once.

#include "chapters/check.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <utility>

namespace stokesbook::exercise {

namespace {

/// Returns the largest difference that a Comparison permits.
double permitted(const Value& expected, double tolerance) {
  const ComplexVector& y = expected.entries();
  const double size = y.size() > 0 ? y.cwiseAbs().maxCoeff() : 0.0;
  return tolerance * (size > 0.0 ? size : 1.0);
}

/// Returns the entries that are not as expected: all, if their number is not.
std::vector<Complex> wrong_entries(const Value& got, const Value& expected, double tolerance) {
  const ComplexVector &x = got.entries(), &y = expected.entries();
  const double limit = permitted(expected, tolerance);
  std::vector<Complex> wrong;
  // Entry by entry: a maximum may lose a NaN.
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (x.size() != y.size() || !(std::abs(x[i] - y[i]) <= limit)) wrong.push_back(x[i]);
  }
  return wrong;
}

}  // namespace

bool agree(const Value& got, const Value& expected, double tolerance) {
  return got.entries().size() == expected.entries().size() &&
         wrong_entries(got, expected, tolerance).empty();
}

std::string text(Complex x) {
  std::ostringstream out;
  out.precision(12);
  out << x.real();
  if (x.imag() != 0.0) out << (std::signbit(x.imag()) ? " - " : " + ") << std::abs(x.imag()) << "i";
  return out.str();
}

std::string line(const std::string& name, const std::string& content) {
  return content.empty() ? "" : "    " + name + std::string(10 - name.size(), ' ') + content + '\n';
}

std::string difference(const Value& got, const Value& expected) {
  const ComplexVector &x = got.entries(), &y = expected.entries();
  if (x.size() != y.size()) {
    return line("got", std::to_string(x.size()) + " entries") +
           line("expected", std::to_string(y.size()) + " entries");
  }
  Eigen::Index worst = 0;
  for (Eigen::Index i = 1; i < x.size(); ++i) {
    if (!(std::abs(x[i] - y[i]) <= std::abs(x[worst] - y[worst]))) worst = i;
  }
  const std::string entry =
      x.size() > 1 ? "   (entry " + std::to_string(worst) + ", which differs most)" : "";
  return line("got", text(x[worst]) + entry) + line("expected", text(y[worst]));
}

namespace {

/// A mistake that gives the first wrong result of a task.
struct Candidate {
  std::string sentence;
  Complex number;          ///< the first wrong one
  bool confirmed = false;  ///< another wrong number, which differs, is that of the mistake too
  bool refuted = false;    ///< another wrong result is not that of the mistake
};

/// Collects what the comparisons of a task have found.
struct Findings {
  std::string first_wrong;  ///< report on the first wrong result; empty without one
  std::vector<Candidate> candidates;

  std::string report() const {
    for (const Candidate& candidate : candidates) {
      if (candidate.refuted) continue;
      return first_wrong +
             (candidate.confirmed ? line("mistake", candidate.sentence) : perhaps(candidate));
    }
    return first_wrong + (candidates.empty() ? "" : perhaps(candidates.front()));
  }

 private:
  static std::string perhaps(const Candidate& candidate) {
    return line("perhaps", candidate.sentence + " (one way to get this value)");
  }
};

Findings findings;  // of the task that is being checked

}  // namespace

void expect(const Comparison& comparison) {
  const auto& [what, got, expected, tolerance, mistakes] = comparison;
  if (agree(got, expected, tolerance)) return;
  const double limit = permitted(expected, tolerance);
  const std::vector<Complex> wrong = wrong_entries(got, expected, tolerance);
  const bool is_first = findings.first_wrong.empty();
  if (is_first) findings.first_wrong = line("for", what) + difference(got, expected);
  for (const Mistake& mistake : mistakes) {
    const bool fits = !wrong.empty() && agree(got, mistake.gives, tolerance);
    if (is_first && fits) findings.candidates.push_back({mistake.sentence, wrong.front()});
    for (Candidate& candidate : findings.candidates) {
      if (candidate.sentence != mistake.sentence) continue;
      if (!fits) candidate.refuted = true;
      for (const Complex number : wrong) {
        if (fits && std::abs(number - candidate.number) > limit) candidate.confirmed = true;
      }
    }
  }
}

namespace {

/// Returns a setting of this run; empty by default.
std::string setting(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Runs one check; returns its outcome, and what follows it in the report.
std::pair<std::string, std::string> outcome(const Task& task) {
  findings = {};
  std::pair<std::string, std::string> end{"passed", ""};
  try {
    task.check();
  } catch (const NotDone&) {
    return {"not done", ""};
  } catch (const Rejection& rejection) {
    end = {"wrong", rejection.text};
  } catch (const std::exception& error) {
    end = {"stopped by an exception", line("message", error.what())};
  } catch (...) {
    end = {"stopped by an exception", ""};
  }
  if (findings.first_wrong.empty()) return end;
  return {"wrong", findings.report()};
}

/// Adds a line on a task to the file that ./stokes check reads.
void record(int number, const std::string& word, std::string details) {
  const std::string file = setting("STOKESBOOK_REPORT");
  if (file.empty()) return;
  std::replace(details.begin(), details.end(), '\n', ';');
  std::ofstream(file, std::ios::app) << number << '\t' << word << '\t' << details << std::endl;
}

}  // namespace

int run(const std::vector<Task>& tasks) {
  const std::string only = setting("STOKESBOOK_TASK"), show = setting("STOKESBOOK_SHOW");
  std::map<int, std::string> words;
  std::size_t passed = 0;
  for (int number = 1; const Task& task : tasks) {
    const int current = number++;
    if (!only.empty() && only != std::to_string(current)) continue;
    // Flushed first: where the reader's code crashes, the report names the task.
    std::cout << "  task " << current << ", " << task.title << ": " << std::flush;
    auto [word, details] = outcome(task);
    record(current, word, details);
    words[current] = word;
    if (word == "passed") ++passed;
    for (int earlier : task.builds_on) {
      if (!words.contains(earlier) || words[earlier] == "passed") continue;
      details += line("note", "task " + std::to_string(current) + " builds on task " +
                                  std::to_string(earlier) + ", which is " + words[earlier]);
    }
    if (word != "passed") {
      if (show.find("hint") != std::string::npos) details += line("hint", task.hint);
      if (show.find("formula") != std::string::npos) details += line("formula", task.formula);
    }
    std::cout << word << '\n' << details << std::flush;
  }
  std::cout << "  " << passed << " of " << words.size() << " tasks passed\n";
  return passed == words.size() ? 0 : 1;
}

}  // namespace stokesbook::exercise
