// Compares a reader's results with exact values, and reports on every task. All checks of the
// exercises share this code, which is compiled once.

#include "chapters/check.hpp"

#include <iostream>
#include <set>
#include <sstream>
#include <utility>

namespace stokesbook::exercise {

bool agree(const Value& got, const Value& expected, double tolerance) {
  const ComplexVector &x = got.entries(), &y = expected.entries();
  if (x.size() != y.size()) return false;
  const double size = y.size() > 0 ? y.cwiseAbs().maxCoeff() : 0.0;
  // Entry by entry: a maximum may lose a NaN.
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!(std::abs(x[i] - y[i]) <= tolerance * (size > 0.0 ? size : 1.0))) return false;
  }
  return true;
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

/// Collects what the comparisons of a task have found.
struct Findings {
  std::string first_wrong;              ///< report on the first wrong result; empty without one
  std::vector<std::string> candidates;  ///< sentences of mistakes that give it
  std::set<std::string> refuted;        ///< of mistakes that do not give some wrong result

  std::string report() const {
    for (const std::string& sentence : candidates) {
      if (!refuted.contains(sentence)) return first_wrong + line("mistake", sentence);
    }
    return first_wrong + (candidates.empty() ? "" : line("perhaps", candidates.front()));
  }
};

Findings findings;  // of the task that is being checked

}  // namespace

void expect(const Comparison& comparison) {
  const auto& [what, got, expected, tolerance, mistakes] = comparison;
  if (agree(got, expected, tolerance)) return;
  const bool is_first = findings.first_wrong.empty();
  if (is_first) findings.first_wrong = line("for", what) + difference(got, expected);
  for (const Mistake& mistake : mistakes) {
    if (!agree(got, mistake.gives, tolerance)) {
      findings.refuted.insert(mistake.sentence);
    } else if (is_first) {
      findings.candidates.push_back(mistake.sentence);
    }
  }
}

namespace {

/// Runs one check; returns its outcome, and what follows it in the report.
std::pair<std::string, std::string> outcome(const Task& task) {
  const std::string help = line("formula", task.formula) + line("hint", task.hint);
  findings = {};
  std::pair<std::string, std::string> end{"passed", ""};
  try {
    task.check();
  } catch (const NotDone&) {
    return {"not done", ""};
  } catch (const Rejection& rejection) {
    end = {"wrong", rejection.text + help};
  } catch (const std::exception& error) {
    end = {"stopped by an exception", line("message", error.what()) + help};
  } catch (...) {
    end = {"stopped by an exception", help};
  }
  if (findings.first_wrong.empty()) return end;
  return {"wrong", findings.report() + help};
}

}  // namespace

int run(const std::vector<Task>& tasks) {
  int number = 0, passed = 0;
  for (const Task& task : tasks) {
    // Flushed first: where the reader's code crashes, the report names the task.
    std::cout << "  task " << ++number << ", " << task.title << ": " << std::flush;
    const auto [word, details] = outcome(task);
    std::cout << word << '\n' << details << std::flush;
    if (word == "passed") ++passed;
  }
  std::cout << "  " << passed << " of " << tasks.size() << " tasks passed\n";
  return passed == number ? 0 : 1;
}

}  // namespace stokesbook::exercise
