// Compares a reader's results with exact values, and reports on every task. All checks of the
// exercises share this code, which is compiled once.

#include "chapters/check.hpp"

#include <iostream>
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

void expect(const Comparison& comparison) {
  const auto& [what, got, expected, tolerance, mistakes] = comparison;
  if (agree(got, expected, tolerance)) return;
  std::string report = line("for", what) + difference(got, expected);
  for (const Mistake& mistake : mistakes) {
    if (agree(got, mistake.gives, tolerance)) {
      throw Rejection{report + line("mistake", mistake.sentence)};
    }
  }
  throw Rejection{report};
}

namespace {

/// Runs one check; returns its outcome, and what follows it in the report.
std::pair<std::string, std::string> outcome(const Task& task) {
  const std::string help = line("formula", task.formula) + line("hint", task.hint);
  try {
    task.check();
    return {"passed", ""};
  } catch (const NotDone&) {
    return {"not done", ""};
  } catch (const Rejection& rejection) {
    return {"wrong", rejection.text + help};
  } catch (const std::exception& error) {
    return {"stopped by an exception", line("message", error.what()) + help};
  } catch (...) {
    return {"stopped by an exception", help};
  }
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
