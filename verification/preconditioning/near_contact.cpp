// Counts iterations for bodies that nearly touch with the block-diagonal preconditioner.
#include "experiments.hpp"
#include "support/body_systems.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;
using Eigen::Index;

namespace {

constexpr GmresOptions near_contact_options{1e-8, 1000};

using Arrangement = std::vector<PlacedBody> (*)(double gap);

enum class CircleBlocks { none, own };

LinearMap blocks_of(const std::vector<PlacedBody>& bodies, Index nodes, CircleBlocks blocks) {
  return blocks == CircleBlocks::own ? LinearMap(block_diagonal(bodies, nodes)) : LinearMap{};
}

/// @param  fixed_nodes  number of nodes for every gap (a planted defect); 0: as many as the gap
///                      requires
Measure counts(Arrangement arrange, CircleBlocks blocks, std::vector<double> gaps,
               Index fixed_nodes = 0) {
  return [=](Size size) {
    std::vector<Measurement> measurements;
    for (const double gap : gaps) {
      if (size == Size::quick && gap < 0.02 && arrange == hexagon) continue;
      if (size == Size::quick && gap < 0.01) continue;
      const Index nodes = fixed_nodes > 0 ? fixed_nodes : nodes_at_gap(gap);
      const std::vector<PlacedBody> bodies = arrange(gap);
      const BodySystem system(bodies, nodes, generic_flow);
      const GmresResult result =
          gmres(system.map(), blocks_of(bodies, nodes, blocks), system.rhs(), near_contact_options);
      measurements.push_back({.x = gap,
                              .error = static_cast<double>(result.iterations),
                              .unknowns = static_cast<double>(system.size())});
    }
    return measurements;
  };
}

}  // namespace

Experiment gaps() {
  const std::vector<double> of_pair{0.001, 0.003, 0.01, 0.03, 0.1, 0.3};
  const std::vector<double> of_hexagon{0.01, 0.03, 0.1, 0.3};
  return {.key = "gaps",
          .title = "Iterations with the blocks of single bodies, when the gap closes",
          .x = "gap, in radii, g",
          .error = "iterations to a residual of 1e-8",
          .lines = {
              {.key = "pair",
               .label = "two circles, block-diagonal",
               .measure = counts(circle_pair, CircleBlocks::own, of_pair),
               .claim = Claim{.id = "13_5",
                              .statement = "Near contact the block-diagonal preconditioner fails: "
                                           "the iterations of two circles grow as g^(-1/2).",
                              .law = Algebraic{0.5, 0.1},
                              .window = {.to = 0.1},
                              .reason = "2 a k - asinh(k sinh 2a) is the same function of a k for "
                                        "all small a: the eigenvalues that are not clustered "
                                        "number C / a, a ~ g^(1/2)",
                              .api = {"stokesbook::BlockDiagonalPreconditioner"}},
               .control = Control{"32 nodes a circle, whatever the gap",
                                  counts(circle_pair, CircleBlocks::own, of_pair, 32)}},
              {.key = "pair_none",
               .label = "two circles, no preconditioner",
               .measure = counts(circle_pair, CircleBlocks::none, of_pair)},
              {.key = "hexagon",
               .label = "hexagon of seven circles, block-diagonal",
               .measure = counts(hexagon, CircleBlocks::own, of_hexagon)}}};
}

}  // namespace stokesbook::verification::preconditioning
