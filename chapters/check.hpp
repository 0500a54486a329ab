#pragma once

#include <cmath>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "chapters/exercise.hpp"
#include "trapezoid/plane.hpp"

/// What the checks of the exercises share: comparisons, and the report on every task.
namespace stokesbook::exercise {

/// A number or a vector, real or complex.
class Value {
 public:
  Value(double x) : entries_(ComplexVector::Constant(1, x)) {}
  Value(Complex x) : entries_(ComplexVector::Constant(1, x)) {}
  template <class Vector>
  Value(const Eigen::MatrixBase<Vector>& x) : entries_(x.template cast<Complex>()) {}

  const ComplexVector& entries() const { return entries_; }

 private:
  ComplexVector entries_;
};

/// What a known mistake makes of a result, and its name: a sentence for the reader.
struct Mistake {
  Value gives;
  std::string sentence;
};

/// A result of the reader beside its exact value.
struct Comparison {
  std::string what;  ///< which result: the arguments
  Value got;         ///< by the reader's function
  Value expected;    ///< by an identity or an exact solution, never a stored number
  double tolerance;  ///< relative to the largest entry expected; absolute where that is 0
  std::vector<Mistake> mistakes = {};  ///< the first that fits is named
};

/// What one function of the reader has to do.
struct Task {
  std::string title;
  std::string formula;          ///< shown where a result is wrong
  std::string hint;             ///< likewise
  std::function<void()> check;  ///< calls expect()
};

/// Thrown by expect(): what the reader is told about a wrong result.
struct Rejection {
  std::string text;
};

/// Whether two values have one size and differ by no more than the tolerance of a Comparison.
inline bool agree(const Value& got, const Value& expected, double tolerance) {
  const ComplexVector &x = got.entries(), &y = expected.entries();
  if (x.size() != y.size()) return false;
  const double size = y.size() > 0 ? y.cwiseAbs().maxCoeff() : 0.0;
  // Entry by entry: a maximum may lose a NaN.
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!(std::abs(x[i] - y[i]) <= tolerance * (size > 0.0 ? size : 1.0))) return false;
  }
  return true;
}

/// Returns a number as text, enough digits to see a difference.
inline std::string text(Complex x) {
  std::ostringstream out;
  out.precision(12);
  out << x.real();
  if (x.imag() != 0.0) out << (std::signbit(x.imag()) ? " - " : " + ") << std::abs(x.imag()) << "i";
  return out.str();
}

/// Returns a line of a report on a wrong result.
inline std::string line(const std::string& name, const std::string& content) {
  return content.empty() ? "" : "    " + name + std::string(10 - name.size(), ' ') + content + '\n';
}

/// Returns the two lines "got" and "expected"; of vectors, the entries that differ most.
inline std::string difference(const Value& got, const Value& expected) {
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

/// Throws a Rejection unless the result is within the tolerance of its exact value.
inline void expect(const Comparison& comparison) {
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

/// Runs one check; returns its outcome, and what follows it in the report.
inline std::pair<std::string, std::string> outcome(const Task& task) {
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

/// Checks all tasks, whose numbers are those of the exercise's README, and reports on each.
/// @return exit code: 0 when all of them pass, else 1
inline int run(const std::vector<Task>& tasks) {
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
