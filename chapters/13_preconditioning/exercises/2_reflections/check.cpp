// Check of exercise 13.2: reflections of two circles against their spectrum; the race.
#include "chapters/check.hpp"

#include <algorithm>
#include <fstream>
#include <numbers>

#include "closure/bordered_system.hpp"
#include "krylov/block_diagonal.hpp"
#include "krylov/gmres.hpp"
#include "study/plot.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using exercise::expect;

VectorXd reflected(const LinearMap& apply, const LinearMap& solve_blocks, const VectorXd& b,
                   int rounds);
double contraction(double gap);
int rounds_needed(double gap, double tolerance);

namespace {

// Two unit circles in a flow without their symmetries.
struct Pair {
  DenseSystem system;
  BlockDiagonalPreconditioner blocks;

  VectorXd apply(const VectorXd& v) const { return system.matrix * v; }
  double residual(const VectorXd& x) const {
    return (system.rhs - apply(x)).norm() / system.rhs.norm();
  }
  VectorXd after(int rounds) const {
    return reflected([this](const VectorXd& v) { return apply(v); }, blocks, system.rhs, rounds);
  }
};

Complex flow(Complex z) {
  return z.imag() + 0.7 * std::conj(z) + 0.3 * std::exp(0.4 * z) * imaginary;
}

Pair two_circles(double gap) {
  // The trapezoid rule between them errs as (1 + gap)^-nodes.
  const auto nodes = 2 * static_cast<Index>(std::ceil(12.0 / std::log1p(gap)));
  const Curve circle = sample(Circle{1.0}, nodes, Side::fluid_outside);
  StokesProblem problem;
  problem.background.resize(2 * nodes);
  for (const Index k : {0, 1}) {
    const Complex centre = (k == 0 ? -1.0 : 1.0) * (1.0 + 0.5 * gap);
    const Curve placed = place(circle, centre, 0.0);
    problem.components.push_back({ComponentKind::free_body, placed, centre, {}, 0.0, {}});
    problem.background.segment(k * nodes, nodes) = placed.x.unaryExpr(&flow);
  }
  const auto inverse = std::make_shared<MatrixXd>(
      invert_block(self_block({ComponentKind::free_body, circle, {}, {}, 0.0, {}})));
  return {assemble(problem, ClosureForm::reduced),
          BlockDiagonalPreconditioner({{inverse, 0.0}, {inverse, 0.0}})};
}

// The powers of E, summed: b - E b + E^2 b - ..., through the blocks.
VectorXd series(const Pair& pair, int rounds) {
  VectorXd term = pair.system.rhs, sum = VectorXd::Zero(term.size());
  for (int k = 0; k < rounds; ++k) {
    sum += term;
    term -= pair.apply(pair.blocks(term));
  }
  return pair.blocks(sum);
}

void check_rounds(int rounds) {
  const Pair pair = two_circles(1.0);
  const VectorXd got = pair.after(rounds), expected = series(pair, rounds);
  VectorXd plain = VectorXd::Zero(expected.size()), replaced = plain;
  for (int k = 0; k < rounds; ++k) {
    plain += pair.system.rhs - pair.apply(plain);
    replaced = pair.blocks(pair.system.rhs - pair.apply(replaced));
  }
  expect({.what = "two circles, gap 1, rounds: " + std::to_string(rounds),
          .got = got,
          .expected = expected,
          .tolerance = 1e-10,
          .mistakes = {{plain, "the blocks are not solved for: M^-1 (b - A x)"},
                       {replaced, "a round adds to x, it does not replace it"},
                       {series(pair, rounds + 1), "this is a round too many"},
                       {series(pair, rounds - 1), "this is a round too few: start from zero"}}});
}

double exact_contraction(double alpha) {
  return std::exp(-4.0 * alpha + std::asinh(2.0 * std::sinh(2.0 * alpha)));
}

void check_contraction(double gap) {
  const double alpha = std::acosh(1.0 + 0.5 * gap), exact = exact_contraction(alpha);
  const double got = contraction(gap);
  expect(
      {.what = "gap " + exercise::text(gap),
       .got = got,
       .expected = exact,
       .tolerance = 1e-12,
       .mistakes = {{exact * exact, "this is the factor of two rounds"},
                    {exact_contraction(std::acosh(1.0 + gap)),
                     "alpha is too large: half the distance of the centres is 1 + g/2"},
                    {std::exp(-2.0 * alpha), "this is how the eigenvalues fall from mode to mode"},
                    {1.0 - exact, "this is the least eigenvalue of 1 + E"}}});
  // The slowest part is what is left in the end.
  const Pair pair = two_circles(gap);
  const int rounds = static_cast<int>(std::ceil(std::log(1e-6) / std::log(exact)));
  const double quotient =
      pair.residual(series(pair, rounds + 2)) / pair.residual(series(pair, rounds));
  expect({.what = "gap " + exercise::text(gap) + ", against residuals late in the course",
          .got = got * got,
          .expected = quotient,
          .tolerance = 0.02});
}

void check_needed(double gap, double tolerance) {
  const double q = exact_contraction(std::acosh(1.0 + 0.5 * gap));
  int needed = 0;
  for (double error = 1.0; error > tolerance; error *= q) ++needed;
  expect({.what = "gap " + exercise::text(gap) + ", tolerance " + exercise::text(tolerance),
          .got = static_cast<double>(rounds_needed(gap, tolerance)),
          .expected = static_cast<double>(needed),
          .tolerance = 1e-12,
          .mistakes = {{std::ceil(std::log10(tolerance) / std::log(q)),
                        "a logarithm to the base 10 over a natural one"},
                       {needed - 1.0, "one round less is not enough"},
                       {needed + 1.0, "one round less would do"}}});
}

// Counts by gap; writes race.csv and race.svg.
void check_experiment() {
  constexpr double tolerance = 1e-8;
  std::ofstream table("race.csv");
  table << "gap,rounds,predicted,gmres\n";
  study::PlotLine reflections{"rounds of reflections"}, iterations{"iterations of GMRES"};
  for (const double gap : {4.0, 2.0, 1.0, 0.5, 0.25}) {
    const Pair pair = two_circles(gap);
    const double predicted = rounds_needed(gap, tolerance);
    int rounds = 1;
    while (rounds < 150 && pair.residual(pair.after(rounds)) > tolerance) ++rounds;
    const GmresResult best = gmres([&](const VectorXd& v) { return pair.apply(v); }, pair.blocks,
                                   pair.system.rhs, {tolerance, 500});
    table << gap << ',' << rounds << ',' << predicted << ',' << best.iterations << '\n';
    reflections.points.push_back({gap, static_cast<double>(rounds)});
    iterations.points.push_back({gap, static_cast<double>(best.iterations)});
    // The data hold less than all of the slowest mode, and its share takes some rounds off.
    expect({.what = "rounds, over the prediction, at the gap " + exercise::text(gap),
            .got = rounds / predicted,
            .expected = 0.9,
            .tolerance = 0.3});
    expect({.what = "GMRES at the gap " + exercise::text(gap) + ": more iterations than rounds",
            .got = std::max(0, best.iterations - rounds),
            .expected = 0.0,
            .tolerance = 0.0});
  }
  std::ofstream("race.svg") << study::draw_plot({.title = "Rounds and iterations by gap",
                                                 .x_label = "gap g",
                                                 .y_label = "count",
                                                 .lines = {reflections, iterations}});
}

}  // namespace

int main() {
  return exercise::run(
      {{.title = "the reflections",
        .formula = "x <- x + M^-1 (b - A x), starting from x = 0",
        .hint = "rounds is the number of times that this is done",
        .check =
            [] {
              for (const int rounds : {1, 2, 7}) check_rounds(rounds);
            }},
       {.title = "the contraction",
        .formula = "the largest modulus in the spectrum of E: mode 2, exp(-4 alpha + asinh(2 sinh 2 alpha))",
        .hint = "cosh alpha is half the distance of the centres",
        .check =
            [] {
              for (const double gap : {2.0, 0.5}) check_contraction(gap);
            }},
       {.title = "the rounds needed",
        .builds_on = {2},
        .formula = "contraction^rounds <= tolerance",
        .hint = "two logarithms of one base",
        .check =
            [] {
              for (const double gap : {2.0, 0.5, 0.01}) check_needed(gap, 1e-8);
            }},
       {.title = "the experiment",
        .builds_on = {1, 3},
        .formula = "rounds ~ log(tolerance)/log(contraction)",
        .hint = "look at race.svg; the tasks before come first",
        .check = check_experiment}});
}
