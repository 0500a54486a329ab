// Counts iterations for slender bodies with the block-diagonal preconditioner. A planted defect
// uses blocks that are not rotated with the bodies.
#include <cmath>

#include "double_layer/double_layer.hpp"
#include "experiments.hpp"
#include "support/body_systems.hpp"
#include "support/vectors.hpp"

namespace stokesbook::verification::krylov {

using namespace study;
using Eigen::Index;

namespace {

constexpr GmresOptions slender_options{1e-10, 1000};

/// Selects the blocks of the preconditioner: none, rotated with the bodies, or not rotated.
enum class EllipseBlocks { none, turned, not_turned };

LinearMap blocks_of(std::vector<PlacedBody> bodies, Index nodes, EllipseBlocks blocks) {
  if (blocks == EllipseBlocks::none) return {};
  if (blocks == EllipseBlocks::not_turned) {
    for (PlacedBody& body : bodies) body.orientation = 0.0;
  }
  return block_diagonal(bodies, nodes);
}

/// Returns a number of nodes that resolves an ellipse. The modes of the double layer decay by the
/// factor (a - b) / (a + b).
Index nodes_of_ellipse(double aspect) {
  return 16 * std::lround(1.0 + aspect);
}

/// Returns the iterations for a single rotated ellipse with random data.
int alone_count(double aspect, EllipseBlocks blocks) {
  const std::vector<PlacedBody> body{{Ellipse{1.0, 1.0 / aspect}, 0.0, 0.7}};
  const Index nodes = nodes_of_ellipse(aspect);
  const BodySystem system(body, nodes, shear);
  const ComplexVector data = test::random_vector(nodes, 1);
  return gmres(system.map(), blocks_of(body, nodes, blocks), interleaved(data), slender_options)
      .iterations;
}

int woven_count(double aspect, Index nodes, Between between, EllipseBlocks blocks) {
  const std::vector<PlacedBody> bodies = woven_ellipses(2, 2, aspect);
  const BodySystem system(bodies, nodes, generic_flow, between);
  return gmres(system.map(), blocks_of(bodies, nodes, blocks), system.rhs(), slender_options)
      .iterations;
}

template <class Number>
Measure over_aspects(const Number& number) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double aspect : size == Size::full ? std::vector<double>{1.5, 2, 3, 4, 6, 8, 12, 16}
                                                  : std::vector<double>{1.5, 2, 3, 4, 6, 8}) {
      measurements.push_back({.x = aspect, .error = static_cast<double>(number(aspect))});
    }
    return measurements;
  };
}

Measure over_nodes(Between between, EllipseBlocks blocks) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const Index nodes : size == Size::full ? std::vector<Index>{48, 64, 80, 96, 128, 160, 192}
                                                : std::vector<Index>{48, 64, 96, 128, 160}) {
      const int count = woven_count(6.0, nodes, between, blocks);
      measurements.push_back({.x = static_cast<double>(nodes),
                              .error = static_cast<double>(count),
                              .unknowns = 8.0 * static_cast<double>(nodes)});
    }
    return measurements;
  };
}

Line mesh_independent(const std::string& key, const std::string& label, const std::string& id,
                      EllipseBlocks blocks, double band) {
  return {.key = key,
          .label = label,
          .measure = over_nodes(Between::resolved, blocks),
          .claim = Claim{.id = id,
                         .statement = "Slender bodies with narrow gaps need no more iterations on "
                                      "a finer mesh: " +
                                      label + ".",
                         .law = Algebraic{0.0, band},
                         .window = {.from = 96.0},
                         .reason = "as for circles; from 96 nodes on, which hold the densities "
                                   "to a ten-thousandth; the band: one iteration as N grows by "
                                   "5 / 3",
                         .api = {"stokesbook::gmres"}},
          .control = Control{"the plain trapezoid rule between the ellipses",
                             over_nodes(Between::trapezoid, blocks)}};
}

}  // namespace

Experiment one_body() {
  const auto difference_from_one = [](EllipseBlocks blocks) {
    return over_aspects([=](double aspect) { return std::abs(alone_count(aspect, blocks) - 1); });
  };
  return {.key = "alone",
          .title = "One turned ellipse",
          .x = "aspect ratio R",
          .error = "iterations beyond the first",
          .lines = {{.key = "turned",
                     .label = "block of the reference, turned",
                     .measure = difference_from_one(EllipseBlocks::turned),
                     .claim = Claim{.id = "05_18",
                                    .statement = "A body alone takes one iteration, however it is "
                                                 "turned.",
                                    .law = Identity{0.0},
                                    .reason = "its block is Q A Q^T with the rotation Q of all "
                                              "node vectors: the preconditioner is the inverse",
                                    .api = {"stokesbook::self_block",
                                            "stokesbook::BlockDiagonalPreconditioner"}},
                     .control = Control{"the block is not turned with the body",
                                        difference_from_one(EllipseBlocks::not_turned)}},
                    {.key = "not_turned",
                     .label = "block of the reference, not turned",
                     .measure = difference_from_one(EllipseBlocks::not_turned)}}};
}

Experiment slender_bodies() {
  return {
      .key = "slender",
      .title = "Four woven ellipses 6:1",
      .x = "nodes of an ellipse, N",
      .error = "iterations to a residual of 1e-10",
      .lines = {mesh_independent("none", "no preconditioner", "05_19", EllipseBlocks::none, 0.04),
                mesh_independent("blocks", "block-diagonal", "05_20", EllipseBlocks::turned, 0.08),
                {.key = "not_turned",
                 .label = "block-diagonal, blocks not turned with the bodies",
                 .measure = over_nodes(Between::resolved, EllipseBlocks::not_turned)}}};
}

Experiment aspect_ratios() {
  const auto woven = [](EllipseBlocks blocks) {
    return over_aspects([=](double aspect) {
      return woven_count(aspect, nodes_of_ellipse(aspect), Between::resolved, blocks);
    });
  };
  return {.key = "aspect",
          .title = "Iterations and aspect ratio",
          .x = "aspect ratio R",
          .error = "iterations to a residual of 1e-10",
          .lines = {{.key = "alone",
                     .label = "one ellipse, no preconditioner",
                     .measure = over_aspects(
                         [](double aspect) { return alone_count(aspect, EllipseBlocks::none); })},
                    {.key = "none",
                     .label = "four woven ellipses, no preconditioner",
                     .measure = woven(EllipseBlocks::none)},
                    {.key = "blocks",
                     .label = "four woven ellipses, block-diagonal",
                     .measure = woven(EllipseBlocks::turned)}}};
}

}  // namespace stokesbook::verification::krylov
