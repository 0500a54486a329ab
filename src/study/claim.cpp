#include "study/claim.hpp"

#include "record/number_text.hpp"

namespace stokesbook::study {

namespace {

struct TextOfLaw {
  std::string x;

  std::string operator()(const Algebraic& law) const {
    return "error = C " + x + "^-" + short_number(law.order);
  }
  std::string operator()(const Geometric& law) const {
    const std::string power = law.power == 0.0 ? "" : x + "^" + short_number(law.power) + " ";
    return "error = C " + power + "exp(-" + short_number(law.rate, 4) + " " + x + ")";
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
  std::string operator()(const Cost& law) const {
    return "operations = C " + x + "^" + short_number(law.order);
  }
  std::string operator()(const ErrorBelowTolerance& law) const {
    return short_number(law.least) + " " + x + " <= error <= " + short_number(law.most) + " " + x;
  }
};

struct NumberOfLaw {
  double operator()(const Algebraic& law) const { return law.order; }
  double operator()(const Geometric& law) const { return law.rate; }
  double operator()(const Superalgebraic& law) const { return law.order; }
  double operator()(const Floor& law) const { return law.level; }
  double operator()(const Identity& law) const { return law.tolerance; }
  double operator()(const Cost& law) const { return law.order; }
  double operator()(const ErrorBelowTolerance& law) const { return law.most; }
};

}  // namespace

std::string law_text(const Law& law, const std::string& x) {
  return std::visit(TextOfLaw{x}, law);
}

double claimed_number(const Law& law) {
  return std::visit(NumberOfLaw{}, law);
}

}  // namespace stokesbook::study
