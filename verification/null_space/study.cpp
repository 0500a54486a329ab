// Study of the null space of an enclosing wall: identities of the null vectors and of N_0, and
// rates of convergence between circles.
#include "experiments.hpp"
#include "studies.hpp"

namespace stokesbook {

study::Study null_space_study() {
  using namespace verification::null_space;
  return {.number = "04",
          .name = "null_space",
          .title = "Enclosing walls and their null space",
          .experiments = {couette(), null_vectors(), without(), conditioning(), scale(),
                          residuals(), iterations(), leak(), source(), eccentric(), density(),
                          closing_gap(), balance(), bodies_in_wall(), choices(), work()}};
}

}  // namespace stokesbook
