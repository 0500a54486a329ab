// Check of exercise 08.2: the definition of the bound, and translations of the library.
#include "chapters/check.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <numbers>

#include "fmm/translations.hpp"
#include "study/plot.hpp"
#include "support/vectors.hpp"

using namespace stokesbook;
using Eigen::Index;
using exercise::expect;

double ratio(double source_radius, double target_radius, double distance);
int order_needed(double rho, double tolerance);
double work(double rho);
double best_ratio();

namespace {

void check_ratio() {
  for (const double source : {1.0, 0.2, 3.0}) {
    for (const double distance : {5.0, 8.0}) {
      const double multipole = source / (distance - 1.0), local = 1.0 / (distance - source);
      expect({.what = "radii " + exercise::text(source) + " and 1, distance " +
                      exercise::text(distance),
              .got = ratio(source, 1.0, distance),
              .expected = std::max(multipole, local),
              .tolerance = 1e-12,
              .mistakes = {{std::max(source, 1.0) / distance,
                            "targets are nearer than the centre of their disk: D - R_t"},
                           {multipole, "the local expansion has a ratio too: R_t/(D - R_s)"},
                           {local, "the multipole expansion has a ratio too: R_s/(D - R_t)"},
                           {std::min(multipole, local), "the larger of both decides"}}});
    }
  }
}

double bound(int p, double rho) {
  return p * std::pow(rho, p);
}

void check_order() {
  for (const double rho : {0.5, 0.2, 0.7}) {
    for (const double tolerance : {1e-3, 1e-6, 1e-12}) {
      const int got = order_needed(rho, tolerance);
      const std::string what = "rho = " + exercise::text(rho) + ", tolerance " +
                               exercise::text(tolerance) + ": order " + std::to_string(got);
      const auto met = [&](int p) { return p >= 1 && bound(p, rho) <= tolerance ? 1.0 : 0.0; };
      const double without_factor = std::ceil(std::log(tolerance) / std::log(rho));
      if (met(got) == 1.0 && met(got - 1) == 0.0) continue;
      throw exercise::Rejection{
          exercise::line("for", what) +
          exercise::line("got", "p rho^p = " + exercise::text(bound(got, rho))) +
          exercise::line("expected", "at most the tolerance, and more than it for one less") +
          exercise::line("mistake", met(got) == 1.0         ? "a lower order is enough"
                                    : got == without_factor ? "the factor p is missing"
                                                            : "the bound is not met yet")};
    }
  }
}

double exact_work(double rho) {
  const double order = std::numbers::ln2 / std::log(1.0 / rho);
  return order * order * 0.25 / (rho * rho);
}

void check_work() {
  for (const double rho : {0.25, 0.4, 0.6, 0.8}) {
    const double order = std::numbers::ln2 / std::log(1.0 / rho);
    expect({.what = "rho = " + exercise::text(rho),
            .got = work(rho),
            .expected = exact_work(rho),
            .tolerance = 1e-12,
            .mistakes = {{order * 0.25 / (rho * rho), "a conversion takes p^2 operations, not p"},
                         {order * order, "lists grow as boxes have to be farther apart: 1/rho^2"},
                         {order * order * 0.5 / rho, "boxes fill an area: 1/rho^2"}}});
  }
}

void check_best() {
  const double got = best_ratio();
  expect({.what = "the ratio of least work",
          .got = got,
          .expected = 1.0 / std::numbers::e,
          .tolerance = 1e-6,
          .mistakes = {{0.5, "this is the ratio of the library, which counts more than this"},
                       {std::exp(-2.0), "the order enters by its square, as the lists do"}}});
  for (const double rho : {0.9 * got, 1.1 * got}) {
    expect({.what = "less work at rho = " + exercise::text(rho) + " than at the best one",
            .got = exact_work(rho) < exact_work(got) ? 1.0 : 0.0,
            .expected = 0.0,
            .tolerance = 0.0});
  }
}

// Sixteen stresslets on the rim of the unit disk, and targets on the rim of another one.
class Translation {
 public:
  explicit Translation(double rho) {
    from_.radius = to_.radius = 1.0;
    to_.centre = 1.0 + 1.0 / rho;
    const ComplexVector n = test::random_vector(16, 1), eta = test::random_vector(16, 2);
    for (std::size_t i = 0; i < 16; ++i) {
      const auto k = static_cast<Index>(i);
      const Complex rim = std::polar(1.0, 2.4 * static_cast<double>(i)), target = to_.centre - rim;
      x_[i] = rim.real();
      y_[i] = rim.imag();
      nx_[i] = n[k].real();
      ny_[i] = n[k].imag();
      ex_[i] = eta[k].real();
      ey_[i] = eta[k].imag();
      targets_.x[i] = target.real();
      targets_.y[i] = target.imag();
    }
    std::array<VectorGroup, 1> sum{};
    add_velocities<1>(block(), targets_, sum);
    exact_ = velocities(sum[0]);
  }

  // Largest error of an order, relative to the largest velocity.
  double error(int order) const {
    Expansions multipole(1, 1, order);
    multipole.clear(0);
    p2m(from_, block(), multipole(0, 0));
    Expansion local = Expansion::Zero(4, order + 1);
    Translations(order).m2l({from_}, multipole, std::array<Index, 1>{0}, 0, to_, local);
    VectorGroup sum;
    l2p(to_, local, targets_, sum);
    return (velocities(sum) - exact_).cwiseAbs().maxCoeff() / exact_.cwiseAbs().maxCoeff();
  }

 private:
  StressletBlock block() const {
    return {x_.data(),      y_.data(), nx_.data(), ny_.data(),
            least2_.data(), 16,        ex_.data(), ey_.data()};
  }

  static ComplexVector velocities(const VectorGroup& group) {
    return ComplexVector::NullaryExpr(16, [&](Index i) {
      return Complex{group.x[static_cast<std::size_t>(i)], group.y[static_cast<std::size_t>(i)]};
    });
  }

  Box from_, to_;
  std::array<double, 16> x_, y_, nx_, ny_, ex_, ey_, least2_{};
  VectorGroup targets_;
  ComplexVector exact_;
};

void check_experiment() {
  std::ofstream table("error_bound.csv");
  table << "line,order,error\n";
  std::vector<study::PlotLine> lines;
  for (const double rho : {2.0 / 3.0, 0.5, 1.0 / 3.0}) {
    const std::string name = "rho = " + exercise::text(std::round(1e3 * rho) * 1e-3);
    const Translation translation(rho);
    study::PlotLine measured{name, {}}, bounds{"p rho^p, " + name, {}};
    for (int p = 2; p <= 40; p += 2) {
      measured.points.push_back({static_cast<double>(p), translation.error(p)});
      bounds.points.push_back({static_cast<double>(p), bound(p, rho)});
    }
    for (const study::PlotLine& line : {measured, bounds}) {
      for (const study::PlotPoint& point : line.points) {
        table << line.label << ',' << point.x << ',' << point.y << '\n';
      }
      lines.push_back(line);
    }
    for (const double tolerance : {1e-3, 1e-6, 1e-8}) {
      const int order = order_needed(rho, tolerance);
      expect({.what = name + ", order " + std::to_string(order) + " for the tolerance " +
                      exercise::text(tolerance) + ": error over tolerance",
              .got = std::min(1.0, std::floor(translation.error(order) / tolerance)),
              .expected = 0.0,
              .tolerance = 0.0});
    }
  }
  std::ofstream("error_bound.svg") << study::draw_plot({.title = "What a translation leaves out",
                                                        .x_label = "order p",
                                                        .y_label = "largest error, relative",
                                                        .log_x = false,
                                                        .lines = lines});
}

}  // namespace

int main() {
  return exercise::run({{.title = "the ratio",
                         .formula = "rho = max(R_s/(D - R_t), R_t/(D - R_s))",
                         .hint = "radius over the distance of the nearest point of the other disk",
                         .check = check_ratio},
                        {.title = "the order",
                         .formula = "p rho^p <= tolerance, and not for p - 1",
                         .hint = "a loop from 1 does it",
                         .check = check_order},
                        {.title = "the work",
                         .formula = "(ln 2/ln(1/rho))^2 (1/2)^2/rho^2",
                         .hint = "order squared times the length of the lists",
                         .check = check_work},
                        {.title = "the best ratio",
                         .formula = "d/d rho of rho ln(1/rho) = 0",
                         .hint = "ln(1/rho) = 1",
                         .check = check_best},
                        {.title = "the experiment",
                         .builds_on = {2},
                         .formula = "errors lie below p rho^p",
                         .hint = "look at error_bound.svg; the tasks before come first",
                         .check = check_experiment}});
}
