// Writes the law of a claim as text for the pages.
#include "study/claim.hpp"

#include <cmath>

#include "text/number_text.hpp"

namespace stokesbook::study {

namespace {

/// Returns the text of a factor x^p; empty for p = 0.
std::string power(const std::string& x, double p) {
  if (p == 0.0) return "";
  return ' ' + x + (p == 1.0 ? "" : '^' + short_number(p));
}

struct TextOfLaw {
  std::string x;

  std::string operator()(const Algebraic& law) const { return "error = C" + power(x, -law.order); }
  std::string operator()(const Geometric& law) const {
    return "error = C" + power(x, law.power) + " exp(-" + short_number(law.rate, 4) + " " + x + ")";
  }
  std::string operator()(const Superalgebraic& law) const {
    return "order grows beyond " + short_number(law.order);
  }
  std::string operator()(const Floor& law) const {
    return "error = " + short_number(law.level) + " within a factor " + short_number(law.factor);
  }
  std::string operator()(const Identity& law) const {
    return "error <= " + short_number(law.tolerance);
  }
  std::string operator()(const AtMost& law) const { return "value <= " + short_number(law.bound); }
  std::string operator()(const Cost& law) const { return "operations = C" + power(x, law.order); }
  std::string operator()(const ErrorBelowTolerance& law) const {
    const std::string most = "error <= " + short_number(law.most) + " " + x;
    return law.least > 0.0 ? short_number(law.least) + " " + x + " <= " + most : most;
  }
};

struct NumberOfLaw {
  double operator()(const Algebraic& law) const { return std::abs(law.order); }
  double operator()(const Geometric& law) const { return law.rate; }
  double operator()(const Superalgebraic& law) const { return law.order; }
  double operator()(const Floor& law) const { return law.level; }
  double operator()(const Identity& law) const { return law.tolerance; }
  double operator()(const AtMost& law) const { return law.bound; }
  double operator()(const Cost& law) const { return law.order; }
  double operator()(const ErrorBelowTolerance& law) const { return law.most; }
};

}  // namespace

std::string law_text(const Law& law, const std::string& axis) {
  return std::visit(TextOfLaw{axis.substr(axis.rfind(' ') + 1)}, law);
}

double claimed_number(const Law& law) {
  return std::visit(NumberOfLaw{}, law);
}

}  // namespace stokesbook::study
