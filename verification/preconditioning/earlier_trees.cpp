// Solves for moved bodies with the tree of groups of their earlier positions: compares the
// iterations with those in a new tree, and with the price of building one.
#include <ctime>
#include <functional>
#include <vector>

#include "experiments.hpp"
#include "support/touching.hpp"
#include "suspension/system/preconditioner_choice.hpp"

namespace stokesbook::verification::preconditioning {

using namespace study;

namespace {

/// Bodies in a shear flow, their velocities at first, and the tree of their first positions.
class MovingBodies {
 public:
  explicit MovingBodies(const Scene& scene)
      : start_(test::with_preconditioner(scene, PreconditionerKind::hierarchical)),
        motions_(start_.solver.solve(start_.solver.start()).motions),
        options_{start_.solver.plan().gmres_tolerance, scene.solver.gmres_max_iterations} {
    // The time after which tree_lasts() no longer holds.
    double after = 1.0;
    for (double part = 0.5; part > 1e-4; part *= 0.5) after += lasts(after) ? part : -part;
    time_of_length_ = 0.5 * after;
  }

  /// Returns the number of iterations beyond those in a new tree, after bodies have moved past each
  /// other by some lengths of their gaps.
  double more_iterations(double lengths, bool in_earlier_tree) const {
    const LinearSystem own = start_.solver.linear_system(
        start_.solver.instant(moved(lengths * time_of_length_)), start_.discretisation);
    LinearSystem other = own;
    other.precondition = in_earlier_tree ? start_.discrete.precondition : LinearMap{};
    return iterations(other) - iterations(own);
  }

  /// Returns the CPU time of building the tree, over that of a product with the operator.
  double price_in_products() const {
    constexpr int products = 20;
    const std::clock_t begin = std::clock();
    const LinearSystem again =
        start_.solver.linear_system(start_.solver.start(), start_.discretisation);
    const std::clock_t built = std::clock();
    ComplexVector density = again.system.right_hand_side();
    for (int k = 0; k < products; ++k) density = again.system(density);
    const std::clock_t applied = std::clock();
    return products * static_cast<double>(built - begin) / static_cast<double>(applied - built);
  }

 private:
  int iterations(const LinearSystem& discrete) const {
    return solve(discrete, discrete.system.right_hand_side(), options_).iterations;
  }

  Configuration moved(double time) const {
    Configuration moved = start_.configuration;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      moved[k].position += time * motions_[k].velocity;
      moved[k].orientation += time * motions_[k].omega;
    }
    return moved;
  }

  bool lasts(double time) const {
    const Configuration there = moved(time);
    return tree_lasts(start_.configuration, there, start_.solver.gaps(there),
                      start_.discretisation);
  }

  test::Discretised start_;
  std::vector<RigidMotion> motions_;
  GmresOptions options_;
  double time_of_length_;
};

const MovingBodies& moving_disks() {
  static const MovingBodies disks([] {
    Scene scene = test::sheared(test::loaded_packing(24, 0.6));
    scene.solver.tolerance = 1e-8;
    return scene;
  }());
  return disks;
}

Measure after(const std::vector<double>& lengths, const std::function<double(double)>& measured) {
  return [=](Size) {
    std::vector<Measurement> measurements;
    for (const double x : lengths) measurements.push_back({.x = x, .error = measured(x)});
    return measurements;
  };
}

const std::vector<double> near_paths{0.5, 1.0, 1.5, 1.9}, far_paths{2.5, 4.0, 6.0};

double in_earlier_tree(double lengths) {
  return moving_disks().more_iterations(lengths, true);
}

double without_tree(double lengths) {
  return moving_disks().more_iterations(lengths, false);
}

double price(double) {
  static const double products = moving_disks().price_in_products();
  return products;
}

}  // namespace

Experiment earlier_trees() {
  return {.key = "earlier",
          .title = "A tree of groups of an earlier configuration",
          .x = "path of bodies past each other, in lengths of their gap",
          .error = "iterations beyond those in a new tree",
          .lines = {
              {.key = "near",
               .label = "in the earlier tree, which is used",
               .measure = after(near_paths, in_earlier_tree),
               .claim = Claim{.id = "13_19",
                              .statement =
                                  "After 24 disks have moved past each other by up to two lengths "
                                  "of their gaps, the root of gap times radius of gyration, their "
                                  "tree of groups takes at most 30 iterations more than a new one, "
                                  "to ten digits.",
                              .law = AtMost{30.0},
                              .reason = "the flow in a gap changes over this length",
                              .api = {"stokesbook::tree_lasts"}},
               .control = Control{"no tree", after(near_paths, without_tree)}},
              {.key = "far",
               .label = "in the earlier tree, where a new one is built",
               .measure = after(far_paths, in_earlier_tree)},
              {.key = "price",
               .label = "price of a new tree, in products",
               .measure = after({near_paths.front(), far_paths.back()}, price)}}};
}

}  // namespace stokesbook::verification::preconditioning
