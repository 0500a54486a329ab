#pragma once

#include <cmath>
#include <functional>
#include <string>
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
  std::vector<Mistake> mistakes = {};  ///< in the order in which a report prefers them
};

/// What one function of the reader has to do.
struct Task {
  std::string title;
  std::vector<int> builds_on = {};  ///< numbers of earlier tasks; the report names the wrong ones
  std::string formula = {};         ///< shown on request if the task has not passed
  std::string hint = {};            ///< likewise
  std::function<void()> check;      ///< calls expect()
};

/// Thrown where a check cannot go on: what the reader is told about a wrong result.
struct Rejection {
  std::string text;
};

/// Whether two values have one size and differ by no more than the tolerance of a Comparison.
bool agree(const Value& got, const Value& expected, double tolerance);

/// Returns a number as text, enough digits to see a difference.
std::string text(Complex x);

/// Returns a line of a report on a wrong result.
std::string line(const std::string& name, const std::string& content);

/// Returns the two lines "got" and "expected"; of vectors, the entries that differ most.
std::string difference(const Value& got, const Value& expected);

/// Compares a result with its exact value. The first wrong result of a task is reported when its
/// check has ended. A mistake that gives this result is named only if it gives all wrong results of
/// the task, and if these have two different wrong numbers or more. Of any other mistake that gives
/// the first wrong result, the report says that this is one way to get it.
void expect(const Comparison& comparison);

/// Checks all tasks, whose numbers are those of the exercise's README, and reports on each. These
/// environment variables change what run() does:
/// - STOKESBOOK_TASK, a number: only this task is checked.
/// - STOKESBOOK_SHOW: "hint", "formula" or both are shown for each task that has not passed.
/// - STOKESBOOK_REPORT, a file: gets a line for each task when the task has ended. ./stokes check
///   believes these lines only, because the reader's code may print anything.
/// @return exit code: 0 when all of them pass, else 1
int run(const std::vector<Task>& tasks);

}  // namespace stokesbook::exercise
