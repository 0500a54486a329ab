// Checks sums over images of the sources against sums at targets that are moved the other way.
#include <stdexcept>

#include <boost/test/unit_test.hpp>

#include "double_layer/kernels.hpp"
#include "double_layer/stresslet_sum.hpp"
#include "fmm/fmm.hpp"
#include "support/point_sets.hpp"

using namespace stokesbook;
using Eigen::Index;
using test::random_vector;
using test::relative_error;

namespace {

constexpr int image_order = 44;

// Plans two near images, one of which overlaps the sources, and one image that is converted as a
// whole (M2L), in the directions of the vectors.
struct Images {
  std::vector<Complex> near;
  Complex far;

  FmmImagePlan plan() const {
    return [*this](double radius, int) {
      const auto convert = [=, far = far](Eigen::Ref<const Expansion> multipole,
                                          Eigen::Ref<Expansion> local) {
        Box source;
        source.radius = radius;
        Box target = source;
        target.centre = -far;
        Expansions expansions(1, 1, image_order);
        expansions(0, 0) = multipole;
        Translations(image_order)
            .m2l({source}, expansions, std::vector<Index>{0}, 0, target, local);
      };
      return FmmImages{near, convert};
    };
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(images_of_nodes_and_points) {
  const std::vector<Curve> curves = test::ellipses(4, 32);
  const ComplexVector points = random_vector(20, 1), force = random_vector(20, 2),
                      density = random_vector(16 * 32, 3);
  const Eigen::VectorXd torque = random_vector(20, 4).real();
  const Images images{{{1.0, 2.0}, {-9.0, 3.0}}, {60.0, -30.0}};
  const ComplexVector elsewhere =
      (3.0 * random_vector(100, 5).array() + Complex{9.0, 9.0}).matrix();
  const StressletSum sum(curves);
  for (const ComplexVector& targets : {all_nodes(curves), elsewhere}) {
    ComplexVector exact = ComplexVector::Zero(targets.size());
    std::vector<FlowDerivatives> slopes(static_cast<std::size_t>(targets.size()));
    for (const Complex w : {Complex{}, images.near[0], images.near[1], images.far}) {
      const ComplexVector moved = targets.array() - w;
      exact += sum(moved, density);
      const std::vector<FlowDerivatives> of_nodes = sum.derivatives(moved, density);
      for (Index i = 0; i < targets.size(); ++i) {
        FlowDerivatives& slope = slopes[static_cast<std::size_t>(i)];
        slope += of_nodes[static_cast<std::size_t>(i)];
        for (Index j = 0; j < 20; ++j) {
          const Complex r = moved[i] - points[j];
          exact[i] += stokeslet(r, force[j], 1.0, 1.0) + rotlet(r, torque[j], 1.0);
          slope += stokeslet_derivatives(r, force[j], 1.0);
          slope += rotlet_derivatives(r, torque[j], 1.0);
        }
      }
    }
    for (const Index leaf_size : {10, 40, 10000}) {
      const FmmSettings settings{image_order, leaf_size};
      const Fmm fmm(curves, points, targets, settings, images.plan());
      const FmmStrengths strengths(density, force, torque);
      BOOST_TEST(relative_error(fmm.velocity(strengths).col(0), exact) < 1e-13);
      BOOST_TEST(relative_error(fmm.derivatives(strengths), slopes) < 1e-12);
      if (targets.size() != 16 * 32) continue;
      const Fmm at_nodes(curves, points, settings, images.plan());
      BOOST_TEST(relative_error(at_nodes.velocity(strengths).col(0), exact) < 1e-13);
    }
  }
}

// A plan without images leaves every bit of a sum as it is.
BOOST_AUTO_TEST_CASE(no_images) {
  const std::vector<Curve> curves = test::ellipses(6, 64);
  const ComplexVector density = random_vector(36 * 64, 3);
  const FmmImagePlan none = [](double, int) { return FmmImages{}; };
  BOOST_TEST((Fmm(curves, {}, {12, 20}, none).velocity(density) ==
              Fmm(curves, {}, {12, 20}).velocity(density)));
  const ComplexVector empty;
  BOOST_TEST(Fmm({}, {}, empty, {12, 20}, Images{{1.0}, 50.0}.plan()).velocity(empty).size() == 0);
}

// The disk is the smallest one that contains the disks of both roots.
BOOST_AUTO_TEST_CASE(disk_of_sources_and_targets) {
  const std::vector<Curve> curves = test::ellipses(2, 32);
  for (const Complex centre : {Complex{1.0, 1.5}, Complex{30.0, 40.0}}) {
    for (const double size : {0.1, 200.0}) {
      const ComplexVector targets = (size * random_vector(50, 1).array() + centre).matrix();
      Box cell;
      const Fmm fmm(curves, {}, targets, {12, 20}, [&](double radius, int given_order) {
        cell.radius = radius;
        BOOST_TEST(given_order == 12);
        return FmmImages{};
      });
      cell.centre = fmm.cell().centre;
      BOOST_TEST(fmm.cell().radius == cell.radius);
      const Box &sources = fmm.sources().boxes.front(), &others = fmm.targets().boxes.front();
      const double reach = std::max(std::abs(sources.centre - cell.centre) + sources.radius,
                                    std::abs(others.centre - cell.centre) + others.radius);
      BOOST_TEST(std::abs(reach / cell.radius - 1.0) < 1e-14);
      const double distance = std::abs(sources.centre - others.centre);
      const double least = std::max(
          {sources.radius, others.radius, 0.5 * (distance + sources.radius + others.radius)});
      if (distance + std::min(sources.radius, others.radius) >
          std::max(sources.radius, others.radius)) {
        BOOST_TEST(std::abs(cell.radius / least - 1.0) < 1e-14);
      } else {
        BOOST_TEST(cell.radius == std::max(sources.radius, others.radius));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(workspaces_of_sums_without_images_are_refused) {
  const std::vector<Curve> curves = test::ellipses(1, 64);
  const ComplexVector density = random_vector(64, 2);
  const Fmm alone(curves, {}, {image_order, 20}),
      together(curves, {}, {image_order, 20}, Images{{}, 50.0}.plan());
  FmmWorkspace work = alone.workspace();
  BOOST_CHECK_THROW(together.velocity(density, work), std::invalid_argument);
}
