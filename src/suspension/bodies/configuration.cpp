// Packs a configuration into the state vector that time steppers advance, and unpacks it
// (chapters 09 and 12).
#include "suspension/bodies/configuration.hpp"

namespace stokesbook {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd to_state(const Configuration& configuration) {
  VectorXd state(3 * static_cast<Index>(configuration.size()));
  for (Index k = 0; k < state.size() / 3; ++k) {
    const auto [position, orientation] = configuration[static_cast<std::size_t>(k)];
    state.segment<3>(3 * k) << position.real(), position.imag(), orientation;
  }
  return state;
}

Configuration to_configuration(const VectorXd& state) {
  Configuration configuration;
  for (Index k = 0; k < state.size(); k += 3) {
    configuration.push_back({{state[k], state[k + 1]}, state[k + 2]});
  }
  return configuration;
}

}  // namespace stokesbook
