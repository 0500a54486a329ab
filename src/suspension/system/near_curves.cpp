// Places the near-singular schemes of shapes (chapter 06) at the poses of the components
// (chapter 12).
#include "suspension/system/near_curves.hpp"

namespace stokesbook {

namespace {

// A scene with a single component plans no near corrections; the flow near that component requires
// its scheme nevertheless.
std::shared_ptr<const CauchyCurve> cauchy_of(const DiscretisedShape& shape) {
  return shape.cauchy ? shape.cauchy : std::make_shared<const CauchyCurve>(shape.curve);
}

}  // namespace

std::vector<PlacedCurve> placed_schemes(const Configuration& configuration,
                                        const Discretisation& discretisation) {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const DiscretisedShape& shape = *discretisation[k];
    CloseScheme scheme = cauchy_of(shape);
    if (shape.interpolation) scheme = shape.interpolation;
    placed.push_back({scheme, configuration[k].position, configuration[k].orientation});
  }
  return placed;
}

std::vector<PlacedCurve> placed_cauchy_schemes(const Configuration& configuration,
                                               const Discretisation& discretisation) {
  std::vector<PlacedCurve> placed;
  for (std::size_t k = 0; k < configuration.size(); ++k) {
    const auto [position, orientation] = configuration[k];
    placed.push_back({cauchy_of(*discretisation[k]), position, orientation});
  }
  return placed;
}

}  // namespace stokesbook
