// Chapter 05: GMRES, without and with the inverse of the bodies' own blocks.
//
//   chapter_05 [DIRECTORY]    prints residuals and counts; draws chapter_05_residuals.svg and
//                             chapter_05_eigenvalues.svg into the directory
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "closure/bordered_system.hpp"
#include "closure/closure.hpp"
#include "double_layer/double_layer.hpp"
#include "krylov/block_diagonal.hpp"
#include "krylov/gmres.hpp"
#include "record/atomic_file.hpp"
#include "record/svg.hpp"
#include "study/plot.hpp"
#include "support/spectra.hpp"
#include "trapezoid/curve.hpp"

using namespace stokesbook;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// [suspension]
// Free bodies of one shape, and where they are.
struct Suspension {
  std::string name;
  Curve reference;  // in the shape's own frame
  std::vector<Complex> positions;
  std::vector<double> orientations;
};

// The suspension in the shear flow (y, 0).
StokesProblem in_shear(const Suspension& suspension) {
  StokesProblem problem;
  const Index n = suspension.reference.size(), count = std::ssize(suspension.positions);
  problem.background.resize(n * count);
  for (Index k = 0; k < count; ++k) {
    const Complex position = suspension.positions[static_cast<std::size_t>(k)];
    const double orientation = suspension.orientations[static_cast<std::size_t>(k)];
    const Curve curve = place(suspension.reference, position, orientation);
    problem.components.push_back({ComponentKind::free_body, curve, position, {}, 0.0, {}});
    problem.background.segment(k * n, n) = curve.x.imag().cast<Complex>();
  }
  return problem;
}
// [suspension]

Suspension nine_circles() {
  Suspension circles{"nine circles", sample(Circle{0.5}, 48, Side::fluid_outside), {}, {}};
  for (int k = 0; k < 9; ++k) {
    circles.positions.push_back(1.25 * Complex(k % 3 - 1, k / 3 - 1));
    circles.orientations.push_back(0.0);
  }
  return circles;
}

Suspension chain_of_ellipses() {
  Suspension chain{
      "four ellipses 8:1", sample(Ellipse{1.0, 0.125}, 96, Side::fluid_outside), {}, {}};
  for (int k = 0; k < 4; ++k) {
    chain.positions.emplace_back(1.4 * k, 0.2 * k);
    chain.orientations.push_back(1.2 + 0.4 * k);
  }
  return chain;
}

// [preconditioner]
// The inverse of one body's block, computed once in its own frame and turned to each body.
BlockDiagonalPreconditioner own_blocks(const Suspension& suspension) {
  const Component alone{ComponentKind::free_body, suspension.reference, {}, {}, 0.0, {}};
  const auto inverse = std::make_shared<MatrixXd>(invert_block(self_block(alone)));
  std::vector<BlockDiagonalPreconditioner::Member> members;
  for (const double orientation : suspension.orientations) {
    members.push_back({inverse, orientation});
  }
  return BlockDiagonalPreconditioner(members);
}
// [preconditioner]

// Both solutions of a suspension, and the matrices that GMRES saw.
struct Comparison {
  std::string name;
  MatrixXd matrix, preconditioned;
  GmresResult without, with;
};

Comparison compare(const Suspension& suspension) {
  // [solve]
  const DenseSystem system = assemble(in_shear(suspension), ClosureForm::reduced);
  const BlockDiagonalPreconditioner solve_blocks = own_blocks(suspension);
  const LinearMap apply = [&](const VectorXd& v) -> VectorXd { return system.matrix * v; };
  const GmresOptions options{.tolerance = 1e-12};
  const GmresResult without = gmres(apply, {}, system.rhs, options);
  const GmresResult with = gmres(apply, solve_blocks, system.rhs, options);
  // [solve]
  MatrixXd preconditioned(system.matrix.rows(), system.matrix.cols());
  for (Index column = 0; column < preconditioned.cols(); ++column) {
    preconditioned.col(column) = apply(solve_blocks(VectorXd::Unit(preconditioned.cols(), column)));
  }
  return {suspension.name, system.matrix, preconditioned, without, with};
}

void print(const Comparison& comparison) {
  std::printf("%s, %td unknowns\n", comparison.name.c_str(), comparison.matrix.rows());
  std::printf("%12s %16s %16s\n", "iteration", "residual", "with own blocks");
  const auto& [first, second] = std::tie(comparison.without.history, comparison.with.history);
  for (std::size_t k = 0; k < std::max(first.size(), second.size()); k += 4) {
    std::printf("%12zu", k);
    for (const std::vector<double>& history : {first, second}) {
      if (k < history.size()) std::printf(" %16.1e", history[k]);
    }
    std::printf("\n");
  }
  std::printf("%12s %16d %16d\n", "iterations", comparison.without.iterations,
              comparison.with.iterations);
  std::printf("%12s %16.1e %16.1e\n\n", "true", comparison.without.residual,
              comparison.with.residual);
}

study::PlotLine line(const std::string& label, const GmresResult& result) {
  study::PlotLine line{label, {}};
  for (std::size_t k = 0; k < result.history.size(); ++k) {
    line.points.push_back({static_cast<double>(k), result.history[k]});
  }
  return line;
}

std::string residuals(const std::vector<Comparison>& comparisons) {
  study::Plot plot{.title = "Residuals of GMRES",
                   .x_label = "iterations",
                   .y_label = "relative residual",
                   .log_x = false};
  for (const Comparison& comparison : comparisons) {
    plot.lines.push_back(line(comparison.name, comparison.without));
    plot.lines.push_back(line(comparison.name + ", preconditioned", comparison.with));
  }
  return study::draw_plot(plot);
}

// Eigenvalues in the complex plane, rings of radius 2.5 pixels, and the origin as a cross.
std::string eigenvalues(const MatrixXd& matrix, const std::string& name, Complex origin) {
  constexpr double scale = 230.0;
  const auto pixel = [&](Complex z) { return origin + scale * std::conj(z); };
  const Complex zero = pixel(0.0);
  std::string rings;
  for (const Complex value : test::eigenvalues(matrix)) {
    const Complex at = pixel(value);
    ComplexVector ring(12);
    for (int j = 0; j < 12; ++j) ring[j] = at + std::polar(2.5, 0.5236 * j);
    rings += svg::polygon(ring);
  }
  const std::string stroke = "fill=\"none\" stroke=\"currentColor\" ";
  std::string ticks, numbers;
  for (const double x : {-2.0, -1.5, -1.0, -0.5, 0.5, 1.0, 1.5, 2.0}) {
    const Complex at = pixel(x);
    if (at.real() < 20.0 || at.real() > 540.0) continue;
    ticks += svg::line(at + Complex{0.0, 12.0}, at + Complex{0.0, 17.0});
    numbers += svg::label(at + Complex{0.0, 32.0}, svg::number(x), "text-anchor=\"middle\"");
  }
  return svg::label({20.0, origin.imag() - 28.0}, name) + numbers +
         svg::path(svg::line({20.0, zero.imag() + 12.0}, {540.0, zero.imag() + 12.0}) + ticks,
                   stroke + "stroke-opacity=\"0.4\"") +
         svg::path(svg::line(zero - Complex{7.0, 7.0}, zero + Complex{7.0, 7.0}) +
                       svg::line(zero - Complex{7.0, -7.0}, zero + Complex{7.0, -7.0}),
                   stroke + "stroke-width=\"2\"") +
         svg::path(rings, stroke);
}

std::string spectra(const std::vector<Comparison>& comparisons) {
  std::string pictures;
  double y = 60.0;
  for (const Comparison& comparison : comparisons) {
    pictures += eigenvalues(comparison.matrix, comparison.name, {500.0, y});
    pictures += eigenvalues(comparison.preconditioned, comparison.name + ", preconditioned",
                            {60.0, y + 95.0});
    y += 190.0;
  }
  return svg::open({560.0, y - 10.0}, "Eigenvalues in the complex plane; the cross is 0") +
         pictures + "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Comparison> comparisons{compare(nine_circles()), compare(chain_of_ellipses())};
  for (const Comparison& comparison : comparisons) print(comparison);
  if (argc > 1) {
    const std::filesystem::path directory = argv[1];
    write_atomically(directory / "chapter_05_residuals.svg", residuals(comparisons),
                     SafeFrom::kill);
    write_atomically(directory / "chapter_05_eigenvalues.svg", spectra(comparisons),
                     SafeFrom::kill);
  }
}
